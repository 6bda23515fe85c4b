// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_COMPONENTS_OF_MATRIX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_COMPONENTS_OF_MATRIX_H

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief finds which rows of a symmetric matrix its nonzero entries connect.
\return for each row the least row of its component
\complexity linear in the number of entries, nearly
*/
inline std::vector<std::uint32_t> components_of_matrix(const Eigen::SparseMatrix<double>& a) {
  std::vector<std::uint32_t> parent(static_cast<std::size_t>(a.cols()));
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&parent](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (int c = 0; c < a.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(a, c); i; ++i) {
      if (i.value() == 0) continue;
      const std::uint32_t r = root(static_cast<std::uint32_t>(i.row())),
                          s = root(static_cast<std::uint32_t>(c));
      parent[std::max(r, s)] = std::min(r, s);
    }
  for (std::uint32_t i = 0; i < parent.size(); ++i) parent[i] = root(i);
  return parent;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_COMPONENTS_OF_MATRIX_H
