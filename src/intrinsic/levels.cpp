// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "levels.h"

#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>
#include <CGAL/Intrinsic_triangulations/support/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

namespace program {

namespace {

namespace text = CGAL::Intrinsic_triangulations::text;

constexpr auto most_levels =
    static_cast<std::size_t>(CGAL::Intrinsic_triangulations::ranges::levels.most);

} // namespace

std::optional<std::size_t> number_of_levels(std::string_view text) {
  std::size_t count = 0;
  if (!text::parse_number(text, count)) return std::nullopt;
  return count;
}

std::vector<double> listed_levels(std::string_view text) {
  std::vector<double> levels;
  while (true) {
    const std::size_t n = std::min(text.find(','), text.size());
    double x = 0;
    const bool is_number = text::parse_number(text.substr(0, n), x) && std::isfinite(x);
    levels.push_back(is_number ? x : std::nan(""));
    if (n == text.size()) return levels;
    text.remove_prefix(n + 1);
  }
}

std::string levels_misuse(const std::string& text) {
  const std::string most = std::to_string(most_levels);
  if (const auto count = number_of_levels(text)) {
    if (*count >= 1 && *count <= most_levels) return {};
    return std::string("there are too few or too many levels; give a number from 1 to ") + most;
  }
  const std::vector<double> levels = listed_levels(text);
  if (levels.size() > most_levels)
    return std::string("there are too many levels; give ") + most + " at most";
  for (const double x : levels)
    if (std::isnan(x))
      return text::shown(text) + ": this is not a list of levels; give how many there are, or "
                                 "numbers separated by commas";
  return {};
}

} // namespace program
