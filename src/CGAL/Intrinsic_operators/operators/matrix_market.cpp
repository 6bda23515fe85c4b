// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/matrix_market.h>
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

namespace CGAL::Intrinsic_triangulations {

namespace internal {

static bool is_symmetric(const Eigen::SparseMatrix<double>& m) {
  if (m.rows() != m.cols()) return false;
  const Eigen::SparseMatrix<double> rest = m - Eigen::SparseMatrix<double>(m.transpose());
  return rest.nonZeros() == m.nonZeros() && (rest.coeffs() == 0).all();
}

} // namespace internal

void write_matrix_market(std::ostream& out, const Eigen::SparseMatrix<double>& m,
                         const std::string& comment) {
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
      write('\n', i.value(), std::chars_format::general, 17); // distinguishes any two doubles
    }
  out << text;
  if (!out) throw std::runtime_error("the matrix cannot be written completely");
}

void write_matrix_market(const std::filesystem::path& path, const Eigen::SparseMatrix<double>& m,
                         const std::string& comment) {
  Replacing_file file(path);
  try {
    write_matrix_market(file.stream(), m, comment);
  } catch (const std::runtime_error&) {
    throw std::runtime_error(path.string() + " cannot be written completely; is the disk full?");
  }
  file.commit();
}

} // namespace CGAL::Intrinsic_triangulations
