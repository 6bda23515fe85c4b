// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What programs do by geometry-central: flips, refinement, places on both surfaces, distances,
// paths, vectors, fields.

#include <CGAL/Intrinsic_geodesics.h>
#include <CGAL/Intrinsic_operators/distance/Heat_distance.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/transfer.h>
#include <CGAL/Intrinsic_operators/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_operators/vectors/direction_field.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <Eigen/Core>

#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
namespace PMP = CGAL::Polygon_mesh_processing;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = IT::Corresponding_triangulation;

int main(int argc, char* argv[]) {
  const char* const file = argc > 1 ? argv[1] : "data/part.off";
  //! [delaunay]
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh)) return 1;
  Triangulation t(mesh); // exact, integer coordinates
  IT::flip_to_delaunay(t);
  const Eigen::SparseMatrix<double> L = IT::cotangent_laplacian(t);
  //! [delaunay]

  //! [heat]
  const auto v = IT::vertex_on_intrinsic(t, Mesh::Vertex_index(0), mesh);
  IT::Heat_distance heat(t); // factors once
  const Eigen::VectorXd d = heat.distances(v);
  //! [heat]
  //! [exact]
  const IT::Polyhedral_distance exact(t, v);
  const std::vector<double> distances = exact.distances();
  //! [exact]

  //! [path]
  const Mesh::Vertex_index end(mesh.number_of_vertices() / 2);
  IT::Geodesic_finder<Triangulation> find(t);
  const IT::Geodesic_path path = find(v, IT::vertex_on_intrinsic(t, end, mesh));
  const std::vector<Point> line = IT::polyline(t, path, mesh);
  //! [path]

  //! [vectors]
  const IT::Vector_heat_method<Triangulation> vectors(t);
  const IT::Tangent_field transported = vectors.transport(v, {0, 1});
  const auto log = vectors.logarithmic_map(v); // by rows
  //! [vectors]
  //! [field]
  const IT::Direction_field crosses = IT::smoothest_direction_field(t, 4);
  //! [field]

  //! [refine]
  IT::delaunay_refine(t, IT::parameters::minimum_angle(25));
  const Eigen::VectorXd refined = IT::Heat_distance(t).distances(v);
  const Eigen::VectorXd on_mesh = IT::copy_to_input(t, refined);
  //! [refine]
  //! [places]
  const IT::Face_location<Mesh> p(Mesh::Face_index(7), {0.5, 0.25, 0.25});
  const auto on_t = IT::locate_on_intrinsic(t, p, mesh);
  const auto back = IT::locate_on_input(t, *on_t, mesh);
  //! [places]
  //! [edges]
  std::vector<std::vector<Point>> lines;
  for (const auto e : edges(t.mesh())) lines.push_back(IT::polyline(t, IT::trace_edge(t, e), mesh));
  //! [edges]

  std::cout << L.rows() << " rows, " << line.size() << " points on a path of length " << path.length
            << ", where the distance is " << distances[end] << " and by heat " << d[end] << "; "
            << lines.size() << " edges\n";
  const bool is_back = back && CGAL::squared_distance(PMP::construct_point(p, mesh),
                                                      PMP::construct_point(*back, mesh)) < 1e-18;
  return is_back && on_mesh.size() == d.size() && log.size() == distances.size() &&
                 transported.size() == log.size() && crosses.degree == 4
             ? 0
             : 1;
}
