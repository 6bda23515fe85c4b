// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUPPORT_RANGE_H
#define INTRINSIC_SUPPORT_RANGE_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

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

} // namespace program

#endif // INTRINSIC_SUPPORT_RANGE_H
