// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_PRINCIPAL_SUBMATRIX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_PRINCIPAL_SUBMATRIX_H

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The rows and columns of a symmetric matrix that are kept.
template <class Scalar>
Eigen::SparseMatrix<Scalar> principal_submatrix(const Eigen::SparseMatrix<Scalar>& a,
                                                const std::vector<int>& kept) {
  std::vector<int> place(static_cast<std::size_t>(a.cols()), -1);
  for (std::size_t i = 0; i < kept.size(); ++i)
    place[static_cast<std::size_t>(kept[i])] = static_cast<int>(i);
  const auto size = static_cast<Eigen::Index>(kept.size());
  Eigen::SparseMatrix<Scalar> part(size, size);
  part.reserve(a.nonZeros());
  for (int c = 0; c < size; ++c) {
    part.startVec(c);
    for (typename Eigen::SparseMatrix<Scalar>::InnerIterator i(a,
                                                               kept[static_cast<std::size_t>(c)]);
         i; ++i)
      if (const int r = place[static_cast<std::size_t>(i.row())]; r >= 0)
        part.insertBack(r, c) = i.value(); // `kept` is sorted, so are rows
  }
  part.finalize();
  return part;
}

// What belongs to the rows that are kept of a Laplacian and a diagonal, when the others are fixed: their diagonal has the weights to those as well.
inline Eigen::VectorXd principal_diagonal(const Eigen::SparseMatrix<double>& laplacian,
                                          const Eigen::VectorXd& diagonal,
                                          const std::vector<int>& kept) {
  std::vector<char> is_kept(static_cast<std::size_t>(laplacian.cols()), 0);
  for (const int r : kept) is_kept[static_cast<std::size_t>(r)] = 1;
  Eigen::VectorXd result(static_cast<Eigen::Index>(kept.size()));
  for (std::size_t k = 0; k < kept.size(); ++k) {
    double sum = diagonal[kept[k]];
    for (Eigen::SparseMatrix<double>::InnerIterator i(laplacian, kept[k]); i; ++i)
      if (is_kept[static_cast<std::size_t>(i.row())] == 0) sum -= i.value();
    result[static_cast<Eigen::Index>(k)] = sum;
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_PRINCIPAL_SUBMATRIX_H
