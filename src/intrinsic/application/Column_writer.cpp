// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Column_writer.h"

#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string_view>

namespace program {

namespace {

constexpr std::array<std::string_view, 1> matrix_market{"mtx"};

} // namespace

Column_writer::Column_writer(std::ostream& out, const std::string& path, std::size_t rows,
                             std::size_t columns)
    : out_(out), is_binary_(!CGAL::Intrinsic_triangulations::has_extension(path, matrix_market)) {
  const std::string m = std::to_string(rows), n = std::to_string(columns);
  if (!is_binary_) {
    out_.text("%%MatrixMarket matrix array real general\n% distances: a row per vertex, a column "
              "per set of sources\n",
              m, " ", n, "\n");
    return;
  }
  // Version 1.0: magic, version, length of the dictionary, which ends where a multiple of 64 does.
  constexpr std::size_t prefix = 10, multiple = 64;
  std::string dictionary =
      "{'descr': '<f8', 'fortran_order': True, 'shape': (" + m + ", " + n + "), }";
  dictionary.append(multiple - (prefix + dictionary.size() + 1) % multiple, ' ');
  dictionary += '\n';
  out_.text("\x93NUMPY");
  for (const std::uint8_t version : {std::uint8_t{1}, std::uint8_t{0}}) out_.binary(version);
  out_.binary(static_cast<std::uint16_t>(dictionary.size()));
  out_.text(dictionary);
}

void Column_writer::write(std::span<const double> column) {
  for (const double x : column)
    if (is_binary_)
      out_.binary(x);
    else
      out_.line(x);
}

void Column_writer::finish() {
  if (!out_.flush()) throw std::runtime_error("the matrix cannot be written completely");
}

} // namespace program
