// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Unrolls a surface about a vertex by the logarithmic map, follows one of its vectors back by the exponential map, and finds the
// centre of three points.

#include <CGAL/Intrinsic_operators/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_operators/vectors/centres.h>
#include <CGAL/Intrinsic_operators/vectors/logarithmic_map.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <complex>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = IT::Corresponding_triangulation;

int main() {
  Mesh mesh;
  const auto corner = [](std::size_t i, std::size_t j) {
    return Point(static_cast<double>(i), static_cast<double>(j), 0);
  };
  CGAL::make_grid(8, 8, mesh, corner, true);
  //! [log]
  const Triangulation t(mesh);
  const Mesh::Vertex_index from(40), to(70); // (4, 4) and (7, 7)
  const auto v = IT::vertex_on_intrinsic(t, from, mesh);
  const std::vector<std::complex<double>> log = IT::logarithmic_map(t, v);
  const std::complex<double> z = log[t.input_vertex(IT::vertex_on_intrinsic(t, to, mesh))];
  const IT::Geodesic back = IT::exponential_map(t, v, z);
  //! [log]
  const Point p = IT::point_in_space(t, *IT::locate_on_input(t, back.points.back()), mesh);
  std::cout << "distance " << std::abs(z) << ", and back to (" << p << ")\n";
  //! [mean]
  const IT::Vector_heat_method<Triangulation> heat(t);
  std::vector<std::pair<IT::Surface_point, double>> points; // in faces, with weights
  for (const std::uint32_t f : {3U, 60U, 101U})
    points.push_back({IT::surface_point(t, {t.numbers().face_at(f), {0.4, 0.3, 0.3}}), 1.});
  const IT::Karcher_mean mean = IT::karcher_mean(heat, points);
  //! [mean]
  std::cout << "centre after " << mean.steps << " steps, at ("
            << IT::point_in_space(t, *IT::locate_on_input(t, mean.point), mesh) << ")\n";
  return CGAL::squared_distance(p, mesh.point(to)) < 1e-12 ? 0 : 1;
}
