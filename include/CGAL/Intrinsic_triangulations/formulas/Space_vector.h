// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_SPACE_VECTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_SPACE_VECTOR_H

#include <array>
#include <cmath>

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

inline double norm(const Space_vector<double>& a) { return std::hypot(a[0], a[1], a[2]); }

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_SPACE_VECTOR_H
