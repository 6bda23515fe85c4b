// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_GEODESIC_RANGE_H
#define INTRINSIC_GEODESIC_RANGE_H

#include "../levels.h"

#include <CGAL/Intrinsic_geodesics/isolines/isolines.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace program {

/// The least and the greatest of finite numbers, and how many are not finite.
struct Range {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  std::size_t infinite = 0; ///< how many are not finite

  void add(double x) {
    if (!std::isfinite(x)) {
      ++infinite;
      return;
    }
    least = std::min(least, x);
    greatest = std::max(greatest, x);
  }
};

/// returns the range of numbers.
template <class Numbers>
Range range_of(const Numbers& numbers) {
  Range range;
  for (const double x : numbers) range.add(x);
  return range;
}

/// returns the levels that a text without misuse asks for: those of a list, or so many in a range,
/// evenly spaced.
inline std::vector<double> levels_in(const Range& range, const std::string& text) {
  const auto count = number_of_levels(text);
  return count ? CGAL::Intrinsic_triangulations::even_levels(
                     std::array{range.least, range.greatest}, *count)
               : listed_levels(text);
}

} // namespace program

#endif // INTRINSIC_GEODESIC_RANGE_H
