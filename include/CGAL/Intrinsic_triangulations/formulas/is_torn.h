// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_IS_TORN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_IS_TORN_H

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <array>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief tells whether the logarithm of a point tears an edge: it makes the edge more than three times
as long.

Shortest paths from the point arrive there on both sides. Curvature stretches less near the point:
on a sphere three times at 131 degrees from it, where r / sin r is 3.
\param from, to places of the ends; unknown ones, which are NaN, tear nothing
\param length of the edge on the surface
*/
inline bool is_torn(const std::array<double, 2>& from, const std::array<double, 2>& to,
                    double length) {
  return std::hypot(to[0] - from[0], to[1] - from[1]) > 3 * length;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_IS_TORN_H
