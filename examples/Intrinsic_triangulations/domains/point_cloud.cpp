// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds a Laplacian on points of a sphere, without any face.

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_triangulations.h>
#include <CGAL/Intrinsic_triangulations/domains/Point_cloud.h>

#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

int main() {
  std::vector<std::array<double, 3>> points; // nearly as far from each other everywhere
  constexpr int n = 2000;
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1.) / n, r = std::sqrt(1 - z * z), a = 2.4 * i;
    points.push_back({r * std::cos(a), r * std::sin(a), z});
  }
  //! [points]
  // from a file:
  // read_triangle_soup("sphere.xyz", Nonplanar_polygons::fan, File_faces::optional).points
  IT::Point_cloud cloud = IT::make_point_cloud(points, 20); // neighbours of each point
  std::cout << cloud.points.duplicated_points << " points were left out\n";
  IT::Intrinsic_triangulation<> t(std::move(cloud.input));
  IT::flip_to_delaunay(t);
  const Eigen::SparseMatrix<double> laplacian = IT::cotangent_laplacian(t); // a row per point
  const double area = IT::lumped_mass_matrix(t).sum();
  //! [points]
  bool is_good = laplacian.rows() == n && std::abs(area - 4 * std::numbers::pi) < 0.1;
  for (int c = 0; c < laplacian.cols(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(laplacian, c); i; ++i)
      is_good = is_good && (i.row() == c || i.value() <= 0); // no weight is negative
  std::cout << laplacian.rows() << " rows, area " << area << '\n';
  return is_good ? 0 : 1;
}
