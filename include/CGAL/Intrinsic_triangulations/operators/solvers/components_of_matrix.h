// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_COMPONENTS_OF_MATRIX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_COMPONENTS_OF_MATRIX_H

#include <CGAL/Intrinsic_triangulations/operators/solvers/Disjoint_sets.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief finds which rows of a symmetric matrix its nonzero entries connect.
\return for each row the least row of its component
\complexity linear in the number of entries, nearly
*/
inline std::vector<std::uint32_t> components_of_matrix(const Eigen::SparseMatrix<double>& a) {
  internal::Disjoint_sets rows(static_cast<std::size_t>(a.cols()));
  for (int c = 0; c < a.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(a, c); i; ++i)
      if (i.value() != 0)
        rows.join(static_cast<std::uint32_t>(i.row()), static_cast<std::uint32_t>(c));
  return std::move(rows).least();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_COMPONENTS_OF_MATRIX_H
