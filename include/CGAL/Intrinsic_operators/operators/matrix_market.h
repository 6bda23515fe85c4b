// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_OPERATORS_MATRIX_MARKET_H
#define CGAL_INTRINSIC_OPERATORS_OPERATORS_MATRIX_MARKET_H

#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <string>

/*!
\file
Sparse matrices in the Matrix Market exchange format, which Matlab, Julia, SciPy, PETSc and Eigen read.

Eigen's own `saveMarket()` is not used: for a symmetric matrix it writes both triangles under a header
that announces one, and it does not notice that the disk is full.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

inline bool is_symmetric(const Eigen::SparseMatrix<double>& m) {
  if (m.rows() != m.cols()) return false;
  const Eigen::SparseMatrix<double> rest = m - Eigen::SparseMatrix<double>(m.transpose());
  return rest.nonZeros() == m.nonZeros() && (rest.coeffs() == 0).all();
}

} // namespace internal

/*!
\brief writes a sparse matrix in Matrix Market coordinate format.

If the matrix is symmetric bit by bit, the header says `symmetric` and the lower triangle with the
diagonal is written, else `general` and all. Rows and columns count from 1. Values have 17 significant
digits and are read back without loss, whatever the locale.
\param out the stream
\param m the matrix
\param comment one or more lines, which are written after the header
\throws std::runtime_error if the stream fails
\complexity linear
*/
inline void write_matrix_market(std::ostream& out, const Eigen::SparseMatrix<double>& m,
                                const std::string& comment = {}) {
  using Iterator = Eigen::SparseMatrix<double>::InnerIterator;
  const bool symmetric = internal::is_symmetric(m);
  std::int64_t count = 0;
  for (Eigen::Index c = 0; c < m.outerSize(); ++c)
    for (Iterator i(m, c); i; ++i) count += !symmetric || i.row() >= c;
  out << "%%MatrixMarket matrix coordinate real " << (symmetric ? "symmetric" : "general") << '\n';
  for (std::size_t from = 0; from < comment.size();) {
    const std::size_t to = std::min(comment.find('\n', from), comment.size());
    out << "% " << comment.substr(from, to - from) << '\n';
    from = to + 1;
  }
  std::string text; // goes to the stream in blocks
  const auto write = [&](char end, auto... number) {
    std::array<char, 32> digits;
    char* const last = std::to_chars(digits.data(), digits.data() + digits.size(), number...).ptr;
    text.append(digits.data(), last) += end;
    if (text.size() < std::size_t{1} << 14U) return;
    out << text;
    text.clear();
  };
  write(' ', m.rows());
  write(' ', m.cols());
  write('\n', count);
  for (Eigen::Index c = 0; c < m.outerSize(); ++c)
    for (Iterator i(m, c); i; ++i) {
      if (symmetric && i.row() < c) continue;
      write(' ', i.row() + 1);
      write(' ', c + 1);
      write('\n', i.value(), std::chars_format::general, 17); // tells any two doubles apart
    }
  out << text;
  if (!out) throw std::runtime_error("the matrix cannot be written completely");
}

/*!
\brief writes a sparse matrix to a Matrix Market file, ordinarily with extension `.mtx`.

The data are written to a temporary file beside it, which replaces the file at the end: whatever fails,
the file is complete or what it was before.
\param path the file
\param m the matrix
\param comment see above
\throws std::runtime_error naming the file if it cannot be written
\complexity linear
*/
inline void write_matrix_market(const std::filesystem::path& path,
                                const Eigen::SparseMatrix<double>& m,
                                const std::string& comment = {}) {
  Replacing_file file(path);
  try {
    write_matrix_market(file.stream(), m, comment);
  } catch (const std::runtime_error&) {
    throw std::runtime_error(path.string() + " cannot be written completely; is the disk full?");
  }
  file.commit();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_OPERATORS_MATRIX_MARKET_H
