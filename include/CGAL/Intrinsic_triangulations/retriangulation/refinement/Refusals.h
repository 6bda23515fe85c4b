// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFUSALS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFUSALS_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
Counts how often insertions for a face were refused, and says how close copies of the next vertex
may come to other vertices.

A copy on another sheet may be close to vertices that are far from the circumcenter. After each
refusal half the distance is enough. Shorter distances make smaller faces, whose vertices may be
refused in turn: vertices inherit the halvings of the face that they were inserted for, and the sum
is bounded. So distances stay above a fraction of those without refusals, and refinement ends.
*/
class Refusals {
public:
  using Corners = std::array<std::uint32_t, 3>; // of a face, in order

  // for this face, as it is
  int count(const Corners& face) const {
    const auto found = counts_.find(face);
    return found == counts_.end() ? 0 : found->second;
  }
  // halvings of distances up to now, those that the corners have inherited included
  int halvings(const Corners& face) const {
    int inherited = 0;
    for (const std::uint32_t v : face)
      if (const auto found = halvings_.find(v); found != halvings_.end())
        inherited = std::max(inherited, found->second);
    return inherited + count(face);
  }
  // whether it was refused, and another halving may help
  bool is_worth_trying(const Corners& face) const {
    return count(face) > 0 && halvings(face) <= most_halvings;
  }

  void add(const Corners& face) { ++counts_[face]; }
  // vertices near faces have changed
  void forget() { counts_.clear(); }
  // vertices were inserted for a face with so many halvings
  void inherit(const std::vector<std::uint32_t>& vertices, int halvings) {
    if (halvings == 0) return;
    for (const std::uint32_t v : vertices) halvings_[v] = halvings;
  }

private:
  // Of 240 random soups, 42 stalled at 25 degrees without halvings, 7 with 1, 1 with 2, 0 with 4;
  // at 30 degrees 94, 63, 47, 33.
  static constexpr int most_halvings = 4;

  std::map<Corners, int> counts_;
  std::unordered_map<std::uint32_t, int> halvings_; // of vertices
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFUSALS_H
