// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_NEAREST_DOUBLE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_NEAREST_DOUBLE_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>

#include <cmath>
#include <limits>
#include <optional>

/*!
\file
The double nearest to a number that is enclosed: the same one from whatever enclosure decides it, so that results do not
depend on the way in which they were computed.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// what both bounds round to; neither zero nor infinite
inline std::optional<double> common_rounding(double low, double high) {
  if (low == high && low != 0 && std::abs(low) < std::numeric_limits<double>::infinity())
    return low;
  return std::nullopt;
}

} // namespace internal

/*!
\brief returns the double nearest to all numbers of a ball, if there is one that is neither zero nor infinite.
\pre rounding is to the nearest
*/
template <class Center>
std::optional<double> nearest_double(const Ball<Center>& x) {
  const double c = x.to_double();
  const Ball<Center> rest = x - Ball<Center>(c);
  // the factors are for the rounding of what is here
  const double r = rest.to_double(),
               radius = static_cast<double>((rest.radius() + std::abs(r) * 0x1p-50) * (1 + 0x1p-50));
  return internal::common_rounding(c + (r - radius), c + (r + radius));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_NEAREST_DOUBLE_H
