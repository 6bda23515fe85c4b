// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FLAT_DIAMOND_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FLAT_DIAMOND_H

#include <array>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/// A diamond that lies in the plane of an input face in space, with the same orientation.
struct Flat_diamond {
  /// A corner, a convex combination of points of the input.
  struct Corner {
    std::array<std::uint32_t, 3> points; ///< the points
    std::array<double, 3> weights;       ///< their weights
  };
  std::uint32_t face;            ///< an input face in the plane
  std::array<Corner, 4> corners; ///< corners i, j, k, m
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FLAT_DIAMOND_H
