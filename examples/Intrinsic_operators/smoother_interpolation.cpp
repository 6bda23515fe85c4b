// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Of all triangulations with the same vertices the Delaunay one interpolates values at them with the least energy (Rippa 1990): heights
// measured on a bad mesh become a smoother function, on the same surface, without a new value. Then some values fix all others, harmonically.

#include <CGAL/Intrinsic_operators/editing/interpolate_harmonically.h>
#include <CGAL/Intrinsic_operators/operators/subdivision_matrices.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main() {
  Mesh mesh;
  const auto corner = [](std::size_t i, std::size_t j) { // a sheared grid on a cylinder
    const double y = static_cast<double>(j) / 10, x = static_cast<double>(i) / 10 + 3 * y;
    return Point(std::cos(x), y, std::sin(x));
  };
  CGAL::make_grid(20, 20, mesh, corner, true);
  Eigen::VectorXd heights(static_cast<Eigen::Index>(mesh.number_of_vertices()));
  for (const Mesh::Vertex_index v : mesh.vertices())
    heights[v] = std::sin(3 * mesh.point(v).x()) * std::cos(4 * mesh.point(v).y());

  //! [rippa]
  IT::Corresponding_triangulation t(mesh);
  const double before = heights.dot(IT::cotangent_laplacian(t) * heights);
  IT::flip_to_delaunay(t);
  const double after = heights.dot(IT::cotangent_laplacian(t) * heights); // never more

  const auto s = IT::common_subdivision(t);
  const Eigen::VectorXd on_input = IT::interpolation_from_input(s) * heights;
  const Eigen::VectorXd smoother = IT::interpolation_from_intrinsic(s) * heights;
  //! [rippa]
  std::cout << "energy " << before << " on the mesh, " << after
            << " on the Delaunay triangulation; values differ by "
            << (on_input - smoother).lpNorm<Eigen::Infinity>() << " at most\n";

  //! [harmonic]
  const std::vector<std::uint32_t> known{0, 20, 220, 440};
  const Eigen::VectorXd u = IT::interpolate_harmonically(t, known, Eigen::Vector4d(1, 4, 2, 3));
  //! [harmonic]
  std::cout << "harmonic values from " << u.minCoeff() << " to " << u.maxCoeff() << '\n';
  return after < before && u.minCoeff() >= 1 && u.maxCoeff() <= 4 ? 0 : 1;
}
