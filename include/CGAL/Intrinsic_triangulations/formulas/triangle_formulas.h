// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_TRIANGLE_FORMULAS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_TRIANGLE_FORMULAS_H

#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <concepts>
#include <iterator>
#include <limits>
#include <numbers>
#include <type_traits>
#include <utility>

/*!
\file
Areas and angles of triangles given by squared lengths, and the curvature that angles sum up to.

The three sides of triangle ijk are passed as ij, jk, ki, `L` is a squared length, `a = 4A` the
quadruple area. Functions of a corner are for `i`, between the first and the last side; rotate the
arguments for the others. Error bounds are for floating point types, relative to the exact value for
the *given* numbers, with u = epsilon / 2, where nothing over- or underflows. They hold on needles
and caps.

References: N. Sharp, M. Gillespie, K. Crane, *Geometry Processing with Intrinsic Triangulations*,
2021, §2.3.6 and Appendix A; W. Kahan, *Miscalculating Area and Angles of a Needle-like Triangle*,
2014.
*/

namespace CGAL::Intrinsic_triangulations {

/*
Sums and products whose rounding errors are kept: floating point types take the compensated path
(Møller and Knuth's sum, the product by fused multiply-add). Other number types compute plainly:
they are exact, enclose, or have a precision chosen by the user.
*/
namespace internal {

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

/// A number as a rounded value and its rounding error.
template <class FT>
struct Unevaluated_sum {
  FT high; ///< the rounded value
  FT low;  ///< the rounding error
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

/// computes x + y + z; relative error u + O(u^2 (|x| + |y| + |z|) / |x + y + z|) for floating
/// types.
template <class FT>
Unevaluated_sum<FT> two_sum(FT x, FT y, FT z) {
  const Unevaluated_sum<FT> s = two_sum(x, y);
  const Unevaluated_sum<FT> t = two_sum(s.high, z);
  return two_sum(t.high, s.low + t.low);
}

} // namespace internal

/*!
\brief computes (4A)^2 from squared lengths.

4 y z - (y + z - x)^2, with x >= y >= z the squared lengths: the terms are then the smallest, so
that needles are accurate. Floating point types keep all rounding errors, so that caps are, too.
Negative iff the square roots of the arguments violate the triangle inequality.
\tparam FT a model of `RingNumber`
\return the value, with relative error at most 2 u + 20 u^2 4yz / (4A)^2
*/
template <RingNumber FT>
FT squared_quadruple_area(const FT& L_ij, const FT& L_jk, const FT& L_ki) {
  FT x = L_jk, y = L_ij, z = L_ki;
  internal::sort_descending(x, y, z);
  if constexpr (internal::is_floating_point<FT>) {
    const auto p = internal::two_sum(y, -x, z);
    const auto yz = internal::two_product(4 * y, z);
    const auto pp = internal::two_product(p.high, p.high);
    return (yz.high - pp.high) + ((yz.low - pp.low) - (p.high + p.high + p.low) * p.low);
  } else {
    const FT p = z - (x - y), yz = y * z, twice = yz + yz;
    return twice + twice - p * p;
  }
}

/*!
\brief computes p_i = L_ij + L_ki - L_jk, twice the inner product of ij and ik (Eq. 2 with the
denominator 2 l_ij l_ki).
\return the value, with relative error at most u + O(u^2) (L_ij + L_ki + L_jk) / |p_i|
*/
template <RingNumber FT>
FT twice_inner_product(const FT& L_ij, const FT& L_jk, const FT& L_ki) {
  if constexpr (internal::is_floating_point<FT>)
    return internal::two_sum(L_ij, -L_jk, L_ki).high;
  else
    return L_ij + L_ki - L_jk;
}

/*!
\brief computes the angle at `i` as atan2(a, p_i): accurate near 0 and near pi, where Eq. 20 is not.
\param a the quadruple area
\param p what `twice_inner_product()` returns
\pre `a >= 0`, not both zero
\return the angle; the relative errors of the arguments are not magnified, atan2 adds 2 u
*/
template <std::floating_point FT>
FT corner_angle(FT a, FT p) {
  CGAL_precondition(a >= 0);
  return std::atan2(a, p);
}

namespace internal {

// `n` pi minus the sum of the angles, n a power of two. The sum is that of Kahan and Babuska in
// Neumaier's form, and pi a double and the rest.
template <class Angles>
auto minus_angles(int n, const Angles& angles) {
  using Angle = std::remove_cvref_t<decltype(*std::begin(angles))>;
  const long double rest_of_pi = 1.2246467991473531772260659322749979970830539012e-16L;
  Angle sum = static_cast<Angle>(n) * std::numbers::pi_v<Angle>;
  const long double rounded = n * static_cast<long double>(std::numbers::pi) - sum;
  Angle lost = static_cast<Angle>(rounded + n * rest_of_pi);
  for (const Angle& angle : angles) {
    const Unevaluated_sum<Angle> s = two_sum(sum, -angle);
    sum = s.high;
    lost += s.low;
  }
  return sum + lost;
}

} // namespace internal

/*!
\brief computes the angle defect of an interior vertex, 2 pi minus its angles (Eq. 3).

Angles are summed with compensation and 2 pi is held to twice the precision: the result is as good
as the angles are, whatever the degree.
\tparam Angles a range of the corner angles at the vertex
\return the defect, zero where the surface is flat, with error u |defect| + O(n^2 u^2)
\complexity linear
*/
template <std::ranges::input_range Angles>
  requires std::floating_point<std::ranges::range_value_t<Angles>>
auto angle_defect(const Angles& angles) { return internal::minus_angles(2, angles); }

/*!
\brief computes the geodesic curvature of the boundary at a vertex, pi minus its angles.
\tparam Angles a range of the corner angles at the vertex
\return the curvature, zero where the boundary is straight, with error as for `angle_defect()`
\complexity linear
*/
template <std::ranges::input_range Angles>
  requires std::floating_point<std::ranges::range_value_t<Angles>>
auto boundary_geodesic_curvature(const Angles& angles) { return internal::minus_angles(1, angles); }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_TRIANGLE_FORMULAS_H
