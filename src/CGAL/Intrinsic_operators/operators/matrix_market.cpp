// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/matrix_market.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <charconv>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Whether the entries of each row are those of its column, in their order; a transposed copy would
// take as much memory as the matrix.
static bool is_symmetric(const Eigen::SparseMatrix<double>& m) {
  if (m.rows() != m.cols()) return false;
  const auto size = static_cast<std::size_t>(m.cols());
  std::vector<int> next(m.outerIndexPtr(), m.outerIndexPtr() + size); // entry of each column
  const auto end = [&](Eigen::Index c) {
    return m.isCompressed() ? m.outerIndexPtr()[c + 1]
                            : m.outerIndexPtr()[c] + m.innerNonZeroPtr()[c];
  };
  for (Eigen::Index c = 0; c < m.cols(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(m, c); i; ++i) {
      const int other = next[static_cast<std::size_t>(i.row())]++;
      if (other >= end(i.row()) || m.innerIndexPtr()[other] != c ||
          !(m.valuePtr()[other] == i.value()))
        return false;
    }
  return true;
}

namespace {

// Numbers as text, which goes to a stream in blocks.
class Number_writer {
public:
  explicit Number_writer(std::ostream& out) : out_(out) {}

  void operator()(char end, auto... number) {
    std::array<char, 32> digits;
    char* const last = std::to_chars(digits.data(), digits.data() + digits.size(), number...).ptr;
    text_.append(digits.data(), last) += end;
    if (text_.size() >= std::size_t{1} << 14U) flush();
  }
  // 17 digits distinguish any two doubles
  void value(double x) { (*this)('\n', x, std::chars_format::general, 17); }
  void value(const std::complex<double>& z) {
    (*this)(' ', z.real(), std::chars_format::general, 17);
    value(z.imag());
  }
  void flush() {
    out_ << text_;
    text_.clear();
  }

private:
  std::ostream& out_;
  std::string text_;
};

void write_market_header(std::ostream& out, const std::string& kind, const std::string& comment) {
  out << "%%MatrixMarket matrix coordinate " << kind << '\n';
  for (std::size_t from = 0; from < comment.size();) {
    const std::size_t to = std::min(comment.find('\n', from), comment.size());
    out << "% " << comment.substr(from, to - from) << '\n';
    from = to + 1;
  }
}

// \param is_lower only the lower triangle is written
template <class Scalar>
void write_market_entries(std::ostream& out, const Eigen::SparseMatrix<Scalar>& m, bool is_lower) {
  using Iterator = typename Eigen::SparseMatrix<Scalar>::InnerIterator;
  std::int64_t count = 0;
  for (Eigen::Index c = 0; c < m.outerSize(); ++c)
    for (Iterator i(m, c); i; ++i) count += !is_lower || i.row() >= c;
  Number_writer write(out);
  write(' ', m.rows());
  write(' ', m.cols());
  write('\n', count);
  for (Eigen::Index c = 0; c < m.outerSize(); ++c)
    for (Iterator i(m, c); i; ++i) {
      if (is_lower && i.row() < c) continue;
      write(' ', i.row() + 1);
      write(' ', c + 1);
      write.value(i.value());
    }
  write.flush();
  if (!out) throw std::runtime_error("the matrix cannot be written completely");
}

} // namespace

void write_complex_matrix(std::ostream& out, const Eigen::SparseMatrix<std::complex<double>>& m,
                          const std::string& comment) {
  write_market_header(out, "complex general", comment);
  write_market_entries(out, m, false);
}

} // namespace internal

void write_matrix_market(std::ostream& out, const Eigen::SparseMatrix<double>& m,
                         const std::string& comment) {
  const bool symmetric = internal::is_symmetric(m);
  internal::write_market_header(out, symmetric ? "real symmetric" : "real general", comment);
  internal::write_market_entries(out, m, symmetric);
}

void write_matrix_market(const std::string& path, const Eigen::SparseMatrix<double>& m,
                         const std::string& comment) {
  write_file(path, [&](std::ostream& out) { write_matrix_market(out, m, comment); });
}

} // namespace CGAL::Intrinsic_triangulations
