// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures a square by an anisotropic metric, in which heights near the bottom count ten times, and
// refines it to triangles that are good in that metric: flat triangles at the bottom, as the
// boundary layer of a flow needs them. The metric need not be that of a surface in space.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/scale_metric.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main() {
  Mesh mesh;
  const auto corner = [](std::size_t i, std::size_t j) {
    return Point(static_cast<double>(i) / 8, static_cast<double>(j) / 8, 0);
  };
  CGAL::make_grid(8, 8, mesh, corner, true);
  //! [scale]
  const auto norm = [&mesh](Mesh::Face_index f, const std::array<double, 3>& v) {
    double y = 0; // of the center
    for (const Mesh::Vertex_index i : mesh.vertices_around_face(mesh.halfedge(f)))
      y += mesh.point(i).y() / 3;
    return std::hypot(v[0], (1 + 9 * std::exp(-4 * y)) * v[1]);
  };
  const IT::Scaled_metric scaled = IT::scale_by_norm_in_space(mesh, norm);
  IT::Intrinsic_triangulation<> t(scaled.input);
  const auto result =
      IT::delaunay_refine(t, IT::parameters::minimum_angle(25).maximum_circumradius(0.125));
  //! [scale]
  double area = 0;
  for (const auto f : faces(t.mesh())) area += t.area(f);
  std::cout << "area in the new metric: " << area << '\n'
            << result.counts.inserted_vertices() << " vertices inserted, "
            << result.unsatisfied.size() << " faces are left below the bounds\nleast angle in the "
            << "new metric: " << IT::measure_quality(t).minimum_angle << " degrees\n";
  return result.status == IT::Status::done && area > 1 ? 0 : 1;
}
