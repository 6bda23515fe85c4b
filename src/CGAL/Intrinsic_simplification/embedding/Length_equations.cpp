// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/embedding/Length_equations.h>
#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Precise_points.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/QR>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

Length_equations::Length_equations(const Metric_triangles& t, const Precise_points& points) {
  for (std::uint32_t h = 0; h < t.number_of_halfedges(); ++h)
    if (h < t.opposite(h)) halfedges.push_back(h);
  const Eigen::Index n = static_cast<Eigen::Index>(halfedges.size());
  residual.resize(n);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(6 * halfedges.size());
  for (Eigen::Index e = 0; e < n; ++e) {
    const std::uint32_t h = halfedges[static_cast<std::size_t>(e)];
    const Precise_point d = vector_between(points[t.source(h)], points[t.target(h)]);
    add_gradient(t, h, d, static_cast<int>(e), entries);
    residual[e] = (scalar_product(d, d) - t.squared_length(h)).to_double() / (2 * t.length(h));
  }
  gradients.resize(3 * static_cast<Eigen::Index>(points.size()), n);
  gradients.setFromTriplets(entries.begin(), entries.end());
}

Eigen::SparseMatrix<double> scaled_coordinates(const Eigen::SparseMatrix<double>& gradients) {
  std::vector<std::vector<Eigen::Vector3d>> at_vertex(
      static_cast<std::size_t>(gradients.rows() / 3));
  for (int e = 0; e < gradients.cols(); ++e) {
    Eigen::SparseMatrix<double>::InnerIterator i(gradients, e);
    while (i) { // three coordinates of each end
      const auto v = static_cast<std::size_t>(i.row() / 3);
      Eigen::Vector3d& g = at_vertex[v].emplace_back(0, 0, 0);
      for (; i && static_cast<std::size_t>(i.row() / 3) == v; ++i) g[i.row() % 3] = i.value();
    }
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t v = 0; v < at_vertex.size(); ++v) {
    Eigen::MatrixXd all(std::max<std::size_t>(at_vertex[v].size(), 3), 3);
    all.setZero();
    for (std::size_t k = 0; k < at_vertex[v].size(); ++k)
      all.row(static_cast<Eigen::Index>(k)) = at_vertex[v][k];
    Eigen::Matrix3d r = Eigen::HouseholderQR<Eigen::MatrixXd>(all).matrixQR().topRows<3>();
    constexpr double least = 1e-14; // a plane up to rounding
    for (int k = 0; k < 3; ++k)
      if (std::abs(r(k, k)) < least) r(k, k) = least;
    const Eigen::Matrix3d inverse =
        r.triangularView<Eigen::Upper>().transpose().solve(Eigen::Matrix3d::Identity());
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j)
        entries.emplace_back(3 * static_cast<int>(v) + i, 3 * static_cast<int>(v) + j,
                             inverse(i, j));
  }
  Eigen::SparseMatrix<double> result(gradients.rows(), gradients.rows());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
