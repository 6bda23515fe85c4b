// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_WITHOUT_CORNER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_WITHOUT_CORNER_H

#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief returns the part of a diamond that reaches all of its corners but one, which is put where corner k is.

Three corners may be near to each other and the fourth across hundreds of triangles. What depends on the three alone is
decided over the part.
\param diamond the diamond
\param corner the corner that is left out, not k: 0 for i, 1 for j, 3 for m
\complexity linear
*/
inline Unfolded_diamond without_corner(const Unfolded_diamond& diamond, std::size_t corner) {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  const auto& old = diamond.triangles;
  auto corners = diamond.corners;
  corners[corner] = corners[2];
  std::vector<unsigned> below(old.size(), 0); // corners in the triangle and beyond
  for (const Unfolded_diamond::Corner& c : corners) ++below[c.triangle];
  std::size_t root = old.size() - 1; // the last triangle from which all are reached
  for (; below[root] < 4; --root) below[old[root].parent] += below[root];
  Unfolded_diamond part{{{old[root].face, 0, 0, {0, 1, 2}}}, corners};
  std::vector<std::uint32_t> number(old.size(), none);
  number[root] = 0;
  for (std::size_t n = root + 1; n < old.size(); ++n) {
    const std::uint32_t parent = number[old[n].parent];
    if (below[n] == 0 || parent == none) continue;
    const auto& p = old[old[n].parent].point;
    const auto exit =
        static_cast<std::uint32_t>(std::find(p.begin(), p.end(), old[n].end()) - p.begin());
    number[n] = static_cast<std::uint32_t>(part.triangles.size());
    part.triangles.push_back(part.beyond(parent, exit, old[n].face, old[n].entry));
  }
  for (Unfolded_diamond::Corner& c : part.corners) c.triangle = number[c.triangle];
  return part;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_WITHOUT_CORNER_H
