// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_BINARY_DOUBLE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_BINARY_DOUBLE_H

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// A finite double as an integer times a power of two.
struct Binary_double {
  std::int64_t mantissa;
  int exponent;

  explicit Binary_double(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const int biased = static_cast<int>(bits >> 52 & 0x7ffU);
    const auto fraction = static_cast<std::int64_t>(bits & 0xfffffffffffffULL);
    mantissa = biased == 0 ? fraction : fraction | std::int64_t{1} << 52;
    exponent = (biased == 0 ? 1 : biased) - 1075;
    const int zeros = mantissa == 0 ? 0 : std::countr_zero(static_cast<std::uint64_t>(mantissa));
    mantissa >>= zeros;
    exponent += zeros;
    if (bits >> 63 != 0) mantissa = -mantissa;
  }

  // the value / 2^e, for e <= exponent
  template <class Integer>
  Integer scaled(int e) const {
    return mantissa == 0 ? Integer(0)
                         : Integer(mantissa).shifted(static_cast<unsigned>(exponent - e));
  }
};

// The range of bits that some doubles occupy.
struct Bit_range {
  int lowest = std::numeric_limits<int>::max() / 4;
  int highest = std::numeric_limits<int>::min() / 4;

  void include(const Binary_double& x) {
    if (x.mantissa == 0) return;
    lowest = std::min(lowest, x.exponent);
    highest =
        std::max(highest, x.exponent + static_cast<int>(std::bit_width(
                                           static_cast<std::uint64_t>(std::abs(x.mantissa)))));
  }
  int width() const { return highest - lowest; }
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_BINARY_DOUBLE_H
