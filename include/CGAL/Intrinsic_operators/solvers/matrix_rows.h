// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_MATRIX_ROWS_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_MATRIX_ROWS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <complex>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The numbers of matrices that are factored: real for symmetric ones, complex for Hermitian ones.
template <class Scalar>
concept Matrix_number = std::same_as<Scalar, double> || std::same_as<Scalar, std::complex<double>>;

// A row of a matrix as the index of a standard container: Eigen's indices have a sign. \pre not
// negative
inline std::size_t row_number(Eigen::Index row) { return static_cast<std::size_t>(row); }

// The matrix with given entries; entries at the same place add up.
template <class Scalar>
Eigen::SparseMatrix<Scalar> matrix_of(Eigen::Index rows, Eigen::Index columns,
                                      const std::vector<Eigen::Triplet<Scalar>>& entries) {
  Eigen::SparseMatrix<Scalar> result(rows, columns);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

} // namespace internal

/*!
\brief finds which rows of a symmetric matrix its nonzero entries connect.
\return for each row the least row of its component
\complexity linear in the number of entries, nearly
*/
template <internal::Matrix_number Scalar>
std::vector<std::uint32_t> components_of_matrix(const Eigen::SparseMatrix<Scalar>& a) {
  return internal::joined_sets(static_cast<std::size_t>(a.cols()), [&a](const auto& join) {
    for (int c = 0; c < a.outerSize(); ++c)
      for (typename Eigen::SparseMatrix<Scalar>::InnerIterator i(a, c); i; ++i)
        if (i.value() != Scalar(0)) join(i.row(), c);
  });
}

namespace internal {

// The sums of the rows of a symmetric matrix, and bounds for their rounding errors, including those
// of the diagonal entries.
struct Row_sums {
  explicit Row_sums(const Eigen::SparseMatrix<double>& a);
  bool may_be_zero(Eigen::Index row) const { return std::abs(sum[row]) <= bound[row]; }

  Eigen::VectorXd sum, bound;
};

// Marks, at their least rows, the components of whose rows all fulfil a condition.
template <class Condition>
std::vector<char> components_where_all(const std::vector<std::uint32_t>& component,
                                       const Condition& condition) {
  std::vector<char> result(component.size(), 1);
  for (std::size_t r = 0; r < component.size(); ++r)
    if (!condition(static_cast<Eigen::Index>(r))) result[component[r]] = 0;
  return result;
}

// Marks, at their least rows, the components whose rows all may sum to zero.
std::vector<char> laplacian_components(const Row_sums& sums,
                                       const std::vector<std::uint32_t>& component);

// Marks some rows of a matrix.
// \throws std::invalid_argument if a row does not exist
std::vector<char> marked_rows(Eigen::Index size, std::span<const std::uint32_t> rows);

// The least rows of the components that are marked there.
std::vector<std::uint32_t> least_rows(const std::vector<std::uint32_t>& component,
                                      const std::vector<char>& is_marked);

// Whether all rows may sum to zero.
bool is_laplacian(const Eigen::SparseMatrix<double>& a);

// Whether no weight is negative.
bool has_no_positive_entry_off_diagonal(const Eigen::SparseMatrix<double>& a);

// Replaces the fixed rows and columns of a symmetric matrix by those of the identity: the result
// solves for the free rows.
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

// The diagonal of that matrix, for a Laplacian and a diagonal: free rows also get their weights to
// fixed rows.
Eigen::VectorXd diagonal_with_fixed_rows(const Eigen::SparseMatrix<double>& laplacian,
                                         Eigen::VectorXd diagonal,
                                         const std::vector<char>& is_fixed);

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_MATRIX_ROWS_H
