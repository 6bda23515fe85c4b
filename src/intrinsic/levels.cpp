// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "levels.h"

#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

namespace program {

namespace {

namespace internal = CGAL::Intrinsic_triangulations::internal;

constexpr std::size_t most_levels = 10000; // more is a mistake, as of a length for a number

std::optional<std::size_t> number_of_levels(std::string_view text) {
  std::size_t count = 0;
  if (!internal::parse_number(text, count)) return std::nullopt;
  return count;
}

// Levels that are not finite numbers become NaN.
std::vector<double> list_of(std::string_view text) {
  std::vector<double> levels;
  while (true) {
    const std::size_t n = std::min(text.find(','), text.size());
    double x = 0;
    const bool is_number = internal::parse_number(text.substr(0, n), x) && std::isfinite(x);
    levels.push_back(is_number ? x : std::nan(""));
    if (n == text.size()) return levels;
    text.remove_prefix(n + 1);
  }
}

} // namespace

std::string levels_misuse(const std::string& text) {
  const std::string most = std::to_string(most_levels);
  if (const auto count = number_of_levels(text)) {
    if (*count >= 1 && *count <= most_levels) return {};
    return std::string("there are too few or too many levels; give a number from 1 to ") + most;
  }
  const std::vector<double> levels = list_of(text);
  if (levels.size() > most_levels)
    return std::string("there are too many levels; give ") + most + " at most";
  for (const double x : levels)
    if (std::isnan(x))
      return internal::shown(text) + ": this is not a list of levels; give how many there are, or "
                                     "numbers separated by commas";
  return {};
}

std::vector<double> levels_of(const std::string& text, double least, double greatest) {
  const auto count = number_of_levels(text);
  if (!count) return list_of(text);
  std::vector<double> levels;
  for (std::size_t k = 1; k <= *count; ++k)
    levels.push_back(
        std::lerp(least, greatest, static_cast<double>(k) / static_cast<double>(*count + 1)));
  return levels;
}

} // namespace program
