// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_SPACE_VECTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_SPACE_VECTOR_H

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A vector or a point of space, in any number type.
template <class FT>
using Space_vector = std::array<FT, 3>;

template <class FT>
Space_vector<FT> difference(const Space_vector<FT>& a, const Space_vector<FT>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class FT>
Space_vector<FT> cross_product(const Space_vector<FT>& a, const Space_vector<FT>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class FT>
FT inner_product(const Space_vector<FT>& a, const Space_vector<FT>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The exponent of the power of two that is near to the largest coordinate, relative to the first
// point.
inline int exponent_of_extent(const std::vector<Space_vector<double>>& points) {
  double extent = 0;
  for (const Space_vector<double>& p : points)
    for (std::size_t k = 0; k < 3; ++k)
      extent = std::max(extent, std::abs(p[k] / 2 - points[0][k] / 2));
  return extent > 0 ? std::ilogb(extent) : 0;
}

inline double norm(const Space_vector<double>& a) { return std::hypot(a[0], a[1], a[2]); }

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_SPACE_VECTOR_H
