// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_CROSSING_PATH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_CROSSING_PATH_H

#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>

#include <array>
#include <vector>

/*!
\file
Paths over the input from face to face: reduced words in the crossings of input edges, which form a
groupoid. A crossing followed by its inverse cancels.
*/

namespace CGAL::Intrinsic_triangulations {

/// A crossing of an input edge, from a side of an input face to the side that is glued to it.
struct Crossing {
  Face_side from; ///< the side on the near side
  Face_side to;   ///< the side on the far side
};

/// Crossings, the first one first; no crossing is followed by its inverse.
using Crossing_path = std::vector<Crossing>;

/// returns the side that follows a side in its face.
inline Face_side next_side(Face_side s) { return {s.face, (s.slot + 1) % 3}; }

/// returns the side before a side in its face.
inline Face_side last_side(Face_side s) { return {s.face, (s.slot + 2) % 3}; }

/// appends a crossing.
inline void append(Crossing_path& p, const Crossing& c) {
  if (!p.empty() && p.back().to == c.from && p.back().from == c.to)
    p.pop_back();
  else
    p.push_back(c);
}

/*!
\brief locates a vertex in the plane into which the input is unfolded along a path.
*/
struct Developed_corner {
  /// From a face to the one in which the vertex is found.
  Crossing_path path;
  /// Where this side of an input face starts, unless the vertex was inserted.
  Face_side side;
  /// Barycentric coordinates of the vertex in that face, of its corners from the start of `side` on.
  std::array<double, 3> weights{1, 0, 0};

  /// tells whether the vertex was inserted.
  bool is_inserted() const { return weights[0] != 1; }
  /// tells whether the vertex is an end of a side.
  bool is_end_of(Face_side s) const {
    return !is_inserted() && (side == s || side == next_side(s));
  }

  /// makes the path as short as it can be: an end of the last edge crossed is seen before crossing it.
  void trim() {
    while (!path.empty() && is_end_of(path.back().to)) {
      const auto [from, to] = path.back();
      side = side == to ? next_side(from) : from;
      path.pop_back();
    }
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_CROSSING_PATH_H
