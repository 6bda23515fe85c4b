// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_NONNEGATIVE_INTERVALS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_NONNEGATIVE_INTERVALS_H

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>

#include <boost/config.hpp>

#include <algorithm>
#include <optional>

/*!
\file
Interval arithmetic for nonnegative lengths and areas: two products instead of up to eight.
Everything here requires rounding upwards (`Protect_FPU_rounding`); a lower bound is the negative of
an upper bound of the negative.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief multiplies two intervals; the second has no negative element.

Whatever the sign of a bound, the outer of its products with both bounds of `b` is the right one;
there is no branch.
\pre `b.inf() >= 0`, the bounds are finite
*/
inline Interval_nt<false> product_with_nonnegative(const Interval_nt<false>& a,
                                                   const Interval_nt<false>& b) {
#ifdef CGAL_USE_SSE2 // both bounds at once
  const __m128d x = a.simd(), y = b.simd(), low = _mm_xor_pd(y, _mm_set1_pd(-0.0));
  return Interval_nt<false>(
      _mm_max_pd(_mm_mul_pd(x, _mm_unpacklo_pd(low, low)), _mm_mul_pd(x, _mm_unpackhi_pd(y, y))));
#else
  const double minus_inf = -a.inf(), sup = a.sup(), low = b.inf(), high = b.sup();
  return {-std::max(minus_inf * low, minus_inf * high), std::max(sup * low, sup * high)};
#endif
}

/// is `product_with_nonnegative()` as a functor, for formulas that multiply by nonnegative numbers.
struct Times_nonnegative {
  /// multiplies.
  Interval_nt<false> operator()(const Interval_nt<false>& a, const Interval_nt<false>& b) const {
    return product_with_nonnegative(a, b);
  }
};

/*!
\brief squares an interval.
\pre the bounds are finite
*/
inline Interval_nt<false> interval_square(const Interval_nt<false>& a) {
#ifdef CGAL_USE_SSE2
  const __m128d x = a.simd(), y = _mm_unpackhi_pd(x, x), minus = _mm_set1_pd(-0.0);
  const __m128d low = _mm_max_sd(_mm_max_sd(_mm_xor_pd(x, minus), _mm_xor_pd(y, minus)),
                                 _mm_setzero_pd()),
                bounds = _mm_unpacklo_pd(low, _mm_max_sd(x, y));
  return Interval_nt<false>(_mm_mul_pd(_mm_xor_pd(bounds, _mm_setr_pd(-0.0, 0.0)), bounds));
#else
  const double low = std::max(std::max(a.inf(), -a.sup()), 0.0), high = std::max(-a.inf(), a.sup());
  return {-(-low * low), high * high};
#endif
}

/*!
\brief returns 1 / (2 x).
\pre the lower bound is positive
*/
inline Interval_nt<false> half_of_inverse(const Interval_nt<false>& x) {
#ifdef CGAL_USE_SSE2
  const __m128d y = x.simd(), turned = _mm_xor_pd(_mm_shuffle_pd(y, y, 1), _mm_setr_pd(0.0, -0.0));
  return Interval_nt<false>(_mm_div_pd(_mm_setr_pd(-0.5, 0.5), turned));
#else
  return {-(-0.5 / x.sup()), 0.5 / x.inf()};
#endif
}

/*!
\brief returns the sign that all numbers of an interval have, or nothing.
*/
inline std::optional<Sign> certain_sign(const Interval_nt<false>& x) {
  if (x.inf() > 0) return POSITIVE;
  if (x.sup() < 0) return NEGATIVE;
  if (x.inf() == 0 && x.sup() == 0) return ZERO;
  return std::nullopt;
}

/*!
\brief evaluates `Delaunay_expression`.
\pre the areas have no negative lower bound
*/
inline Interval_nt<false> delaunay_value(const Interval_nt<false>& q_f,
                                         const Interval_nt<false>& area_f,
                                         const Interval_nt<false>& q_g,
                                         const Interval_nt<false>& area_g) {
  return product_with_nonnegative(q_f, area_g) + product_with_nonnegative(q_g, area_f);
}

// With an optional `bool` or `CGAL::Uncertain`, which g++ stores and reads again, a check of an
// edge takes 15 % more instructions.
/// What intervals prove of a statement.
enum class Certainty {
  no,  ///< it is false
  yes, ///< it is true
  open ///< nothing
};

/*!
\brief tells whether an edge is Delaunay, if intervals prove it.
\param q_f, q_g the numerators of the cotangents opposite the edge
\param area_f, area_g the quadruple areas, read only if an angle may be obtuse
\pre the areas have no negative lower bound
*/
BOOST_FORCEINLINE Certainty certain_delaunay(const Interval_nt<false>& q_f,
                                             const Interval_nt<false>& area_f,
                                             const Interval_nt<false>& q_g,
                                             const Interval_nt<false>& area_g) {
  // both angles at most a right one: areas do not matter
  if (q_f.inf() >= 0 && q_g.inf() >= 0) return Certainty::yes;
  const Interval_nt<false> value = delaunay_value(q_f, area_f, q_g, area_g);
  if (value.inf() >= 0) return Certainty::yes;
  return value.sup() < 0 ? Certainty::no : Certainty::open;
}

/*!
\brief computes `flipped()`, faster.
\pre the areas have no negative lower bound
*/
inline Flipped_values<Interval_nt<false>>
flipped_nonnegative(const Diamond_values<Interval_nt<false>>& d) {
  using FT = Interval_nt<false>;
  // else quotients by L_ij may overflow
  if (!(d.ij.inf() >= 0x1p-900)) return flipped(d);
  const FT half = half_of_inverse(d.ij), quarter(-(-half.inf() * 0.5), half.sup() * 0.5);
  const FT x = (d.ki - d.jk) - (d.im - d.mj); // p_k - p_m, without the error of L_ij
  const FT km = interval_square(x) + interval_square(d.area_f + d.area_g);
  const Times_nonnegative times;
  return {times(km, quarter), times(Convexity_at_target_expression()(d, times), half),
          times(Convexity_at_source_expression()(d, times), half)};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_NONNEGATIVE_INTERVALS_H
