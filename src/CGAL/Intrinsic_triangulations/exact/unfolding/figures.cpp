// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

Unfolded_diamond Unfolded_diamond::without(std::size_t corner) const {
  Unfolded_diamond part{{}, corners};
  part.corners[corner] = corners[2];
  std::vector<unsigned> below(size(), 0); // corners in the triangle and beyond
  for (const Corner& c : part.corners) ++below[c.triangle];
  std::uint32_t root = triangles.last(); // the last triangle from which all are reached
  for (; below[root] < 4; --root) below[triangles[root].parent()] += below[root];
  std::vector<std::uint32_t> number(size(), Triangles::none);
  part.triangles.start(triangles[root].side);
  number[root] = 0;
  for (std::uint32_t n = root + 1; n < size(); ++n)
    if (const std::uint32_t parent = number[triangles[n].parent()];
        below[n] > 0 && parent != Triangles::none)
      number[n] = part.triangles.enter(parent, triangles.exit_to(n), triangles[n].side);
  for (Corner& c : part.corners) c.triangle = number[c.triangle];
  return part;
}

} // namespace CGAL::Intrinsic_triangulations
