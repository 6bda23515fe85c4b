// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_HTML_TABLE_H
#define INTRINSIC_HTML_TABLE_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace program {

/// A table whose first column holds names, and the others numbers or words.
struct Html_table {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

/*!
\brief writes a table; rows beyond `shown` are folded away.
\param out where it goes
\param table head and rows, as text
\param shown number of rows that are always shown
*/
void write_table(std::ostream& out, const Html_table& table, std::size_t shown = 30);

/// returns a number with commas between groups of three digits.
std::string grouped(std::uint64_t n);
/// returns a number with some significant digits, such as `0.0123` or `3.1e-12`; a dash if unknown.
std::string short_number(std::optional<double> x, int digits = 3);

} // namespace program

#endif // INTRINSIC_HTML_TABLE_H
