// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nearest_word.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace program {

namespace {

// How many letters must be inserted, removed, replaced or swapped with the next one.
std::size_t difference(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before, last, row(b.size() + 1); // for the first letters of `a`
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(last, std::exchange(row, std::vector<std::size_t>(b.size() + 1, i)));
    for (std::size_t k = 1; k <= b.size(); ++k) {
      row[k] =
          std::min({last[k] + 1, row[k - 1] + 1, last[k - 1] + (a[i - 1] == b[k - 1] ? 0 : 1)});
      if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
        row[k] = std::min(row[k], before[k - 2] + 1);
    }
  }
  return row.back();
}

// How many letters two words begin with in common.
std::size_t common_letters(const std::string& a, const std::string& b) {
  return static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
}

} // namespace

std::string nearest_word(const std::string& word, const std::vector<std::string>& words) {
  constexpr std::size_t longest = 60; // no word of ours is longer, and the work grows by squares
  std::string nearest;
  std::size_t least = word.size() > longest ? 0 : word.size() / 3 + 1;
  for (const std::string& w : words)
    if (const std::size_t d = least == 0 ? 0 : difference(word, w); d < least) {
      least = d;
      nearest = w;
    }
  if (!nearest.empty() || word.empty() || words.empty()) return nearest;
  const std::string& begins_alike = *std::ranges::max_element(
      words, {}, [&](const std::string& w) { return common_letters(word, w); });
  return 3 * common_letters(word, begins_alike) >= 2 * word.size() ? begins_alike : "";
}

} // namespace program
