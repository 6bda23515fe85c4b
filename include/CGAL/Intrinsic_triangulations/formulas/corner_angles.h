// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_CORNER_ANGLES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_CORNER_ANGLES_H

#include <CGAL/Intrinsic_triangulations/formulas/compensated_arithmetic.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <iterator>
#include <numbers>
#include <type_traits>
#include <utility>

/*!
\file
Inner products, angles and cotangents at the corners of triangles given by lengths, and the
curvature that angles sum up to.

The three sides of triangle ijk are passed as ij, jk, ki, and the result is that of corner `i`,
between the first and the last side; rotate the arguments for the others. Notation, number types and
the meaning of error bounds are those of `triangle_formulas.h`. p_i = L_ij + L_ki - L_jk = 2<ij, ik>.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief computes p_i = L_ij + L_ki - L_jk, twice the inner product of ij and ik (Eq. 2 with the
denominator 2 l_ij l_ki).
\return the value, with relative error at most u + O(u^2) (L_ij + L_ki + L_jk) / |p_i|
*/
template <class FT>
FT twice_inner_product(const FT& L_ij, const FT& L_jk, const FT& L_ki) {
  if constexpr (internal::is_floating_point<FT>)
    return internal::two_sum(L_ij, -L_jk, L_ki).high;
  else if constexpr (internal::is_rounded<FT>)
    return internal::is_less(L_ij, L_ki) ? (L_ki - L_jk) + L_ij : (L_ij - L_jk) + L_ki;
  else
    return L_ij + L_ki - L_jk;
}

/*!
\brief computes the same as `twice_inner_product()` from lengths, as (x - l_jk) (x + l_jk) + y^2
with x >= y the sides at the corner.
\return the value, with error at most 4 u (|p_i| + y^2)
*/
template <class FT>
FT twice_inner_product_from_lengths(const FT& l_ij, const FT& l_jk, const FT& l_ki) {
  const bool swapped = internal::is_rounded<FT> && internal::is_less(l_ij, l_ki);
  const FT& x = swapped ? l_ki : l_ij;
  const FT& y = swapped ? l_ij : l_ki;
  return (x - l_jk) * (x + l_jk) + y * y;
}

/*!
\brief computes the angle at `i` as atan2(a, p_i): accurate near 0 and near pi, where Eq. 20 is not.
\param a the quadruple area
\param p what `twice_inner_product()` returns
\pre `a >= 0`, not both zero
\return the angle, as `FT` if that is a floating point type, else as `double`; the relative errors of
  the arguments are not magnified, atan2 adds 2 u
*/
template <class FT>
internal::Angle_type<FT> corner_angle(const FT& a, const FT& p) {
  CGAL_precondition(a >= FT(0));
  return std::atan2(internal::to_angle_type(a), internal::to_angle_type(p));
}

/// computes the angle at `i` from squared lengths. \pre the triangle inequality, `L_ij, L_ki > 0`
template <class FT>
internal::Angle_type<FT> corner_angle_from_squared_lengths(const FT& L_ij, const FT& L_jk,
                                                           const FT& L_ki) {
  return corner_angle(quadruple_area_from_squared_lengths(L_ij, L_jk, L_ki),
                      twice_inner_product(L_ij, L_jk, L_ki));
}

/*!
\brief computes the angle at `i` from lengths by Kahan's formula.

The tangent of half the angle is the root of ((x - y) + o) m / ((x + (y + o)) ((x - o) + y)), with
o = l_jk opposite, x >= y the sides at the corner, and m = o - (x - y) = y - (x - o), whichever is
free of rounding in the brackets.
\pre `satisfies_triangle_inequality()`, `l_ij, l_ki > 0`
\return the angle, with relative error at most 9 u
*/
template <class FT>
internal::Angle_type<FT> corner_angle_from_lengths(const FT& l_ij, const FT& l_jk, const FT& l_ki) {
  CGAL_precondition(satisfies_triangle_inequality(l_ij, l_jk, l_ki));
  using Angle = internal::Angle_type<FT>;
  FT x = l_ij, y = l_ki;
  const FT& o = l_jk;
  if (internal::is_less(x, y)) std::swap(x, y);
  const FT m = internal::is_less(y, o) ? FT(y - (x - o)) : FT(o - (x - y));
  const Angle sine = internal::to_angle_type(FT(((x - y) + o) * m));
  const Angle cosine = internal::to_angle_type(FT((x + (y + o)) * ((x - o) + y)));
  return 2 * std::atan2(std::sqrt(sine), std::sqrt(cosine));
}

/*!
\brief computes the cotangent of the angle at `i`, p_i / a (Eq. 21).
\param a the quadruple area
\param p what `twice_inner_product()` returns
\pre `a > 0`
\return the cotangent; division adds u to the relative errors of the arguments
*/
template <class FT>
FT cotangent(const FT& a, const FT& p) {
  CGAL_precondition(a > FT(0));
  return p / a;
}

/*!
\brief computes the cotangent of the angle at `i` from lengths.
\pre the strict triangle inequality
\return the cotangent, with error at most 11 u |cot| + 2 u y / (x sin), with x >= y the sides at `i`
*/
template <class FT>
FT cotangent_from_lengths(const FT& l_ij, const FT& l_jk, const FT& l_ki) {
  return cotangent(quadruple_area_from_lengths(l_ij, l_jk, l_ki),
                   twice_inner_product_from_lengths(l_ij, l_jk, l_ki));
}

namespace internal {

// `n` pi minus the sum of the angles, n a power of two. The sum is that of Kahan and Babuska in
// Neumaier's form, and pi a double and the rest.
template <class Angles>
auto minus_angles(int n, const Angles& angles) {
  using Value = std::remove_cvref_t<decltype(*std::begin(angles))>;
  using Angle = Angle_type<Value>;
  const long double rest_of_pi = 1.2246467991473531772260659322749979970830539012e-16L;
  Angle sum = static_cast<Angle>(n) * std::numbers::pi_v<Angle>;
  const long double rounded = n * static_cast<long double>(std::numbers::pi) - sum;
  Angle lost = static_cast<Angle>(rounded + n * rest_of_pi);
  for (const Value& angle : angles) {
    const Unevaluated_sum<Angle> s = two_sum(sum, Angle(-to_angle_type(angle)));
    sum = s.high;
    lost += s.low;
  }
  return sum + lost;
}

} // namespace internal

/*!
\brief computes the angle defect of an interior vertex, 2 pi minus its angles (Eq. 3).

Angles are summed with compensation and 2 pi is held to twice the precision: the result is as good as
the angles are, whatever the degree.
\tparam Angles a range of the corner angles at the vertex
\return the defect, zero where the surface is flat, with error u |defect| + O(n^2 u^2)
\complexity linear
*/
template <class Angles>
auto angle_defect(const Angles& angles) {
  return internal::minus_angles(2, angles);
}

/*!
\brief computes the geodesic curvature of the boundary at a vertex, pi minus its angles.
\tparam Angles a range of the corner angles at the vertex
\return the curvature, zero where the boundary is straight, with error as for `angle_defect()`
\complexity linear
*/
template <class Angles>
auto boundary_geodesic_curvature(const Angles& angles) {
  return internal::minus_angles(1, angles);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_CORNER_ANGLES_H
