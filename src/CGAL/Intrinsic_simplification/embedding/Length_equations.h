// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_LENGTH_EQUATIONS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_LENGTH_EQUATIONS_H

#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Precise_points.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// One equation per edge: (|p - q|^2 - L) / (2 l) = 0. Its derivatives are those of the distance.
struct Length_equations {
  std::vector<std::uint32_t> halfedges;  // one per edge
  Eigen::VectorXd residual;              // computed with 106 bits
  Eigen::SparseMatrix<double> gradients; // an equation per column, a coordinate per row

  Length_equations(const Metric_triangles& t, const Precise_points& points);
};

// Adds the gradient of the length of the edge h, whose vector is d, as a column.
template <class Real>
void add_gradient(const Metric_triangles& t, std::uint32_t h, const Precise_point& d, int column,
                  std::vector<Eigen::Triplet<Real>>& entries) {
  for (int k = 0; k < 3; ++k) {
    const Real slope = rounded_to<Real>(d[static_cast<std::size_t>(k)]) / Real(t.length(h));
    entries.emplace_back(3 * static_cast<int>(t.source(h)) + k, column, -slope);
    entries.emplace_back(3 * static_cast<int>(t.target(h)) + k, column, slope);
  }
}

// Coordinates at each vertex, by blocks of a matrix, in which the gradients at it are orthonormal.
// Where edges lie nearly in a plane, lengths hardly depend on moves across it.
Eigen::SparseMatrix<double> scaled_coordinates(const Eigen::SparseMatrix<double>& gradients);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_LENGTH_EQUATIONS_H
