// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_MATRIX_MARKET_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_MATRIX_MARKET_H

#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.h>

#include <Eigen/SparseCore>

#include <algorithm>
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
  const Eigen::SparseMatrix<double> t = m.transpose();
  for (Eigen::Index c = 0; c < m.outerSize(); ++c) {
    Eigen::SparseMatrix<double>::InnerIterator i(m, c), j(t, c);
    for (; i && j; ++i, ++j)
      if (i.row() != j.row() || i.value() != j.value()) return false;
    if (i || j) return false;
  }
  return true;
}

// collects numbers as text and hands them on in blocks
class Number_writer {
public:
  explicit Number_writer(std::ostream& out) : out_(out) {}
  void integer(std::int64_t i, char end) { append(end, i); }
  // 17 significant digits tell any two doubles apart
  void real(double x, char end) { append(end, x, std::chars_format::general, 17); }
  void flush() {
    out_.write(buffer_, static_cast<std::streamsize>(used_));
    used_ = 0;
  }

private:
  template <class... Arguments>
  void append(char end, Arguments... arguments) {
    if (used_ + 32 > sizeof(buffer_)) flush();
    char* const last =
        std::to_chars(buffer_ + used_, buffer_ + sizeof(buffer_) - 1, arguments...).ptr;
    *last = end;
    used_ = static_cast<std::size_t>(last + 1 - buffer_);
  }

  std::ostream& out_;
  std::size_t used_ = 0;
  char buffer_[1 << 14];
};

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
  internal::Number_writer write(out);
  write.integer(m.rows(), ' ');
  write.integer(m.cols(), ' ');
  write.integer(count, '\n');
  for (Eigen::Index c = 0; c < m.outerSize(); ++c)
    for (Iterator i(m, c); i; ++i) {
      if (symmetric && i.row() < c) continue;
      write.integer(i.row() + 1, ' ');
      write.integer(c + 1, ' ');
      write.real(i.value(), '\n');
    }
  write.flush();
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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_MATRIX_MARKET_H
