// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Row_writer.h"

#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string_view>

namespace program {

namespace {

constexpr std::array<std::string_view, 1> numpy{"npy"};

} // namespace

Row_writer::Row_writer(std::ostream& out, const std::string& path, std::size_t rows,
                       std::size_t columns)
    : out_(out), is_binary_(CGAL::Intrinsic_triangulations::has_extension(path, numpy)) {
  if (!is_binary_) return;
  const std::string m = std::to_string(rows), n = std::to_string(columns);
  // Version 1.0: magic, version, length of the dictionary, which ends where a multiple of 64 does.
  constexpr std::size_t prefix = 10, multiple = 64;
  std::string dictionary =
      "{'descr': '<f8', 'fortran_order': False, 'shape': (" + m + ", " + n + "), }";
  dictionary.append(multiple - (prefix + dictionary.size() + 1) % multiple, ' ');
  dictionary += '\n';
  out_.text("\x93NUMPY");
  for (const std::uint8_t version : {std::uint8_t{1}, std::uint8_t{0}}) out_.binary(version);
  out_.binary(static_cast<std::uint16_t>(dictionary.size()));
  out_.text(dictionary);
}

void Row_writer::write(std::span<const double> row) {
  for (const double x : row)
    if (is_binary_)
      out_.binary(x);
    else
      out_.words(x);
  if (!is_binary_) out_.line();
}

void Row_writer::finish() {
  if (!out_.flush()) throw std::runtime_error("the matrix cannot be written completely");
}

} // namespace program
