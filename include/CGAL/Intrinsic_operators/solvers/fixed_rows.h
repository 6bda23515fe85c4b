// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_FIXED_ROWS_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_FIXED_ROWS_H

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Makes the rows and columns of a symmetric matrix that are fixed those of the identity: what is
// left solves for the free rows.
template <class Scalar>
Eigen::SparseMatrix<Scalar> with_fixed_rows(Eigen::SparseMatrix<Scalar> a,
                                            const std::vector<char>& is_fixed) {
  const auto fixed = [&](Eigen::Index r) { return is_fixed[static_cast<std::size_t>(r)] != 0; };
  a.prune([&](Eigen::Index i, Eigen::Index j, const Scalar&) {
    return i == j || (!fixed(i) && !fixed(j));
  });
  for (Eigen::Index r = 0; r < a.cols(); ++r)
    if (fixed(r)) a.coeffRef(r, r) = 1;
  a.makeCompressed();
  return a;
}

// What belongs to that matrix, of a Laplacian and a diagonal: the diagonal of free rows has the
// weights to fixed ones as well.
inline Eigen::VectorXd diagonal_with_fixed_rows(const Eigen::SparseMatrix<double>& laplacian,
                                                Eigen::VectorXd diagonal,
                                                const std::vector<char>& is_fixed) {
  for (int c = 0; c < laplacian.cols(); ++c)
    if (is_fixed[static_cast<std::size_t>(c)] != 0)
      for (Eigen::SparseMatrix<double>::InnerIterator i(laplacian, c); i; ++i)
        diagonal[i.row()] -= i.value();
  for (Eigen::Index r = 0; r < diagonal.size(); ++r)
    if (is_fixed[static_cast<std::size_t>(r)] != 0) diagonal[r] = 1;
  return diagonal;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_FIXED_ROWS_H
