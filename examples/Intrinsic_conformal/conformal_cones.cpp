// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Flattens a closed surface but for eight cones, lays it out in the plane, and proves both.

#include <CGAL/Intrinsic_conformal/angles/flat_angles.h>
#include <CGAL/Intrinsic_conformal/angles/ideal_start.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_in_plane.h>
#include <CGAL/Intrinsic_conformal/maps/uniformize.h>
#include <CGAL/Intrinsic_conformal/metric/conformal_metric.h>
#include <CGAL/Intrinsic_conformal/metric/flat_surface.h>
#include <CGAL/Intrinsic_triangulations.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_ideal_hyperbolic_traits.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cstdint>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Ideal = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_ideal_hyperbolic_traits,
                                          IT::Integer_coordinates>;

int main() {
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Mesh::Point(0, 0, 0), 1.0);
  for (const auto v : vertices(mesh)) // bent
    mesh.point(v) = {2 * mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()};

  //! [cones]
  IT::Corresponding_triangulation surface(mesh);
  IT::flip_to_delaunay(surface);
  Ideal t(IT::ideal_start(surface));
  const IT::Prescribed_angles angles = IT::place_cones(t, 8);
  const IT::Conformal_metric metric = IT::conformal_metric(t, angles);

  std::vector<std::uint32_t> cones;
  for (const auto v : vertices(t.mesh()))
    if (angles.multiple(t.input_vertex(v)) != IT::Multiple_of_pi()) cones.push_back(t.index(v));
  const IT::Flat_layout layout = IT::lay_out_in_plane(IT::flat_surface(t), cones);
  const IT::Map_certificate certificate = IT::certify_map(layout);
  //! [cones]

  //! [in one call]
  IT::Uniformize_options options;
  options.cones = 8;
  const IT::Uniformization map = IT::uniformize(mesh, options); // the same in one call
  const Eigen::MatrixX2d& uv = map.layout->layout.positions;    // of the vertices of its pieces:
  const IT::Common_subdivision& pieces = map.layout->layout.subdivision; // faces of one face each
  //! [in one call]
  const bool is_whole = map.layout->certificate.flipped == 0 &&
                        uv.rows() == static_cast<Eigen::Index>(pieces.number_of_vertices());

  std::cout << "angles are right up to " << metric.proven_residual.value_or(1) << " radians, "
            << layout.seams.size() << " seams, " << certificate.flipped << " flipped triangles\n";
  return metric.status == IT::Status::done && certificate.flipped == 0 && is_whole ? 0 : 1;
}
