// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Square_root_field.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Strip_names.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Value_recipes.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>

#include <CGAL/Gmpq.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

std::uint32_t Strip_names::name_of_length(const Input_metric& m, Face_side s, int exponent) {
  const Gmpq x = scaled_by_power_of_two(m.squared_length<Gmpq>(s.face, s.slot), exponent);
  return lengths_.emplace(x, static_cast<std::uint32_t>(lengths_.size())).first->second;
}

std::optional<Strip_names::Name> Strip_names::name(const Value_recipes& recipes, std::uint32_t edge,
                                                   int exponent) {
  std::vector<std::uint32_t> letters;
  if (const Unfolded_diamond* strip = recipes.strip(edge)) {
    const std::optional<Row> r = row(recipes.metric(), *strip, exponent);
    if (!r) return std::nullopt;
    letters = std::min({r->letters(false, false), r->letters(false, true), r->letters(true, false),
                        r->letters(true, true)});
  } else {
    letters = {name_of_length(recipes.metric(), recipes.input_side_of(edge), exponent)};
  }
  return names_.emplace(std::move(letters), static_cast<Name>(names_.size())).first->second;
}

// A triangle is entered over its first side, from left to right: its second
// side is on the right.
std::optional<Strip_names::Row> Strip_names::row(const Input_metric& m,
                                                 const Unfolded_diamond& strip, int exponent) {
  const auto& triangles = strip.triangles;
  const std::size_t n = triangles.size();
  const auto side = [&](std::size_t triangle, std::uint32_t k) {
    const Face_side& s = triangles[triangle].side;
    return name_of_length(m, {s.face, (s.slot + k) % 3}, exponent);
  };
  if (n < 2 || strip.corners[0].triangle != 0 || strip.corners[1].triangle != n - 1 ||
      strip.corners[1].corner != 2)
    return std::nullopt;
  Row r;
  std::uint32_t exit = triangles.exit_to(1);
  if (strip.corners[0].corner != (exit + 2) % 3) return std::nullopt;
  r.first_left = side(0, (exit + 1) % 3);
  r.first_right = side(0, (exit + 2) % 3);
  r.crossed.push_back(side(1, 0));
  for (std::uint32_t k = 1; k + 1 < n; ++k) {
    if (triangles[k + 1].parent() != k) return std::nullopt;
    exit = triangles.exit_to(k + 1);
    r.turn.push_back(exit - 1); // 0: about the right end of the first side
    r.side.push_back(side(k, 3 - exit));
    r.crossed.push_back(side(k + 1, 0));
  }
  r.last_left = side(n - 1, 2);
  r.last_right = side(n - 1, 1);
  return r;
}

std::vector<std::uint32_t> Strip_names::Row::letters(bool is_backward, bool is_mirrored) const {
  std::vector<std::uint32_t> all;
  // seen from the other end, left is right
  const bool swaps = is_backward != is_mirrored;
  const auto add_pair = [&](std::uint32_t left, std::uint32_t right) {
    all.push_back(swaps ? right : left);
    all.push_back(swaps ? left : right);
  };
  const auto add_first = [&] { add_pair(first_left, first_right); };
  const auto add_last = [&] { add_pair(last_left, last_right); };
  const std::size_t n = turn.size();
  is_backward ? add_last() : add_first();
  all.push_back(is_backward ? crossed.back() : crossed.front());
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = is_backward ? n - 1 - i : i;
    all.push_back(swaps ? 1 - turn[k] : turn[k]);
    all.push_back(side[k]);
    all.push_back(crossed[is_backward ? k : k + 1]);
  }
  is_backward ? add_first() : add_last();
  return all;
}

} // namespace CGAL::Intrinsic_triangulations::internal
