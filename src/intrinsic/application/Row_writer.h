// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_APPLICATION_ROW_WRITER_H
#define INTRINSIC_APPLICATION_ROW_WRITER_H

#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>

#include <cstddef>
#include <ostream>
#include <span>
#include <string>

namespace program {

/// Writes a full matrix row by row, so that it need not be in memory: in NumPy's format to `.npy`,
/// or as text, a line for each row.
class Row_writer {
public:
  /// writes what comes before the numbers.
  Row_writer(std::ostream& out, const std::string& path, std::size_t rows, std::size_t columns);
  /// writes the next row.
  void write(std::span<const double> row);
  /// writes what is left. \throws std::runtime_error if the stream has failed
  void finish();

private:
  CGAL::Intrinsic_triangulations::text::Output_buffer out_;
  bool is_binary_;
};

} // namespace program

#endif // INTRINSIC_APPLICATION_ROW_WRITER_H
