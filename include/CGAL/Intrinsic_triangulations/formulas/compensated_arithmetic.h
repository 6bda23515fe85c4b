// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_COMPENSATED_ARITHMETIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_COMPENSATED_ARITHMETIC_H

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

/*!
\file
Sums and products whose rounding errors are kept, for the formulas of triangles.

Floating point types take the compensated path (Møller and Knuth's sum, the product by fused
multiply-add). Any other number type computes plainly: it is exact,
or encloses, or its user has chosen its precision.
*/

namespace CGAL::Intrinsic_triangulations::internal {

/// Whether `FT` is `float`, `double` or `long double`.
template <class FT>
inline constexpr bool is_floating_point = std::is_floating_point_v<FT>;

/// Whether the order of evaluation matters: `FT` is ordered and not exact.
template <class FT>
inline constexpr bool is_rounded =
    std::is_same_v<typename Real_embeddable_traits<FT>::Is_real_embeddable, Tag_true> &&
    !std::is_same_v<typename Algebraic_structure_traits<FT>::Is_exact, Tag_true>;

/// Whether `FT` rounds to a known precision: a floating point type
/// of the language or of Boost, no interval.
template <class FT>
inline constexpr bool has_precision = is_rounded<FT>&& std::numeric_limits<FT>::is_specialized;

/// tells whether to treat `x` as less than `y`; never uncertain, wrong at most where they overlap.
template <class FT>
bool is_less(const FT& x, const FT& y) {
  if constexpr (is_floating_point<FT>)
    return x < y;
  else
    return CGAL::to_double(x) < CGAL::to_double(y);
}

/// sorts so that x >= y >= z; does nothing if `FT` is exact or not ordered.
template <class FT>
void sort_descending(FT& x, FT& y, FT& z) {
  if constexpr (is_rounded<FT>) {
    using std::swap;
    if (is_less(x, y)) swap(x, y);
    if (is_less(y, z)) swap(y, z);
    if (is_less(x, y)) swap(x, y);
  }
}

/// A number held as a rounded value and what rounding lost.
template <class FT>
struct Unevaluated_sum {
  FT high; ///< the rounded value
  FT low;  ///< what rounding lost
};

/// computes x + y and its rounding error, exactly when rounding to nearest.
template <class FT>
Unevaluated_sum<FT> two_sum(FT x, FT y) {
  const FT s = x + y;
  const FT t = s - x;
  return {s, (x - (s - t)) + (y - t)};
}

/// computes x y and its rounding error, exactly unless the error underflows.
template <class FT>
Unevaluated_sum<FT> two_product(FT x, FT y) {
  const FT p = x * y;
  return {p, std::fma(x, y, -p)};
}

/// computes x + y + z; relative error u + O(u^2 (|x| + |y| + |z|) / |x + y + z|) for floating types.
template <class FT>
Unevaluated_sum<FT> two_sum(FT x, FT y, FT z) {
  const Unevaluated_sum<FT> s = two_sum(x, y);
  const Unevaluated_sum<FT> t = two_sum(s.high, z);
  return two_sum(t.high, s.low + t.low);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_COMPENSATED_ARITHMETIC_H
