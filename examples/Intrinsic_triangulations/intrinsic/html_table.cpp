// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "html_table.h"
#include "svg_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace program {

namespace {

void write_rows(std::ostream& out, const Html_table& table, std::size_t first, std::size_t last) {
  out << "<div class=\"wide\"><table>\n<thead><tr>";
  for (const std::string& h : table.head) out << "<th>" << escaped(h) << "</th>";
  out << "</tr></thead>\n<tbody>\n";
  for (std::size_t i = first; i < last; ++i) {
    out << "<tr>";
    for (std::size_t k = 0; k < table.rows[i].size(); ++k)
      out << (k == 0 ? "<th>" : "<td>") << escaped(table.rows[i][k])
          << (k == 0 ? "</th>" : "</td>");
    out << "</tr>\n";
  }
  out << "</tbody></table></div>\n";
}

} // namespace

void write_table(std::ostream& out, const Html_table& table, std::size_t shown) {
  const std::size_t n = table.rows.size();
  // folding away a few rows hides more than it saves
  const std::size_t open = n <= shown + 5 ? n : shown;
  write_rows(out, table, 0, open);
  if (open == n) return;
  out << "<details><summary>" << n - open << " more</summary>\n";
  write_rows(out, table, open, n);
  out << "</details>\n";
}

std::string grouped(std::uint64_t n) {
  std::string digits = std::to_string(n);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, 1, ',');
  return digits;
}

std::string short_number(std::optional<double> x, int digits) {
  if (!x) return "\u2013";
  char text[40];
  const double size = std::abs(*x);
  if (size != 0 && (size < 1e-3 || size >= 1e6)) {
    std::snprintf(text, sizeof(text), "%.*e", digits - 2, *x);
  } else {
    const int leading = size == 0 ? digits - 1 : static_cast<int>(std::floor(std::log10(size)));
    std::snprintf(text, sizeof(text), "%.*f", std::max(0, digits - 1 - leading), *x);
  }
  return text;
}

} // namespace program
