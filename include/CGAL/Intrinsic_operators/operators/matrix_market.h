// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_OPERATORS_MATRIX_MARKET_H
#define CGAL_INTRINSIC_OPERATORS_OPERATORS_MATRIX_MARKET_H

#include <Eigen/SparseCore>

#include <complex>
#include <concepts>
#include <ostream>
#include <string>

/*!
\file
Sparse matrices in the Matrix Market exchange format, which Matlab, Julia, SciPy, PETSc and
  Eigen read.

Eigen's own `saveMarket()` is not used: for a symmetric matrix it writes both triangles under a
header that announces one, and it does not notice that the disk is full.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

void write_complex_matrix(std::ostream& out, const Eigen::SparseMatrix<std::complex<double>>& m,
                          const std::string& comment);

} // namespace internal

/*!
\brief writes a sparse matrix in Matrix Market coordinate format.

If the matrix is symmetric bit by bit, the header says `symmetric` and the lower triangle with the
diagonal is written, else `general` and all. Rows and columns count from 1. Values have 17
significant digits and are read back without loss, whatever the locale.
\param out the stream
\param m the matrix
\param comment one or more lines, which are written after the header
\throws std::runtime_error if the stream fails
\complexity linear
*/
void write_matrix_market(std::ostream& out, const Eigen::SparseMatrix<double>& m,
                         const std::string& comment = {});

/// writes a complex matrix, `general`, see above: the real and the imaginary part of each value.
/// \tparam Complex `std::complex<double>`; so real expressions go to the other one
template <std::same_as<std::complex<double>> Complex>
void write_matrix_market(std::ostream& out, const Eigen::SparseMatrix<Complex>& m,
                         const std::string& comment = {}) {
  internal::write_complex_matrix(out, m, comment);
}

/*!
\brief writes a sparse matrix to a Matrix Market file, ordinarily with extension `.mtx`.

It writes a temporary file beside it, which replaces the file at the end: after any failure, the
file is complete or unchanged.
\param path the file
\param m the matrix
\param comment see above
\throws File_error naming the file if it cannot be written
\complexity linear
*/
void write_matrix_market(const std::string& path, const Eigen::SparseMatrix<double>& m,
                         const std::string& comment = {});

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_OPERATORS_MATRIX_MARKET_H
