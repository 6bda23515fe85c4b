// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INITIAL_VALUES_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INITIAL_VALUES_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Gmpz.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief computes the exact square root of a rational number that is a square.
\return whether `x` is the square of a rational; if so, `root` is set to its nonnegative root
*/
CGAL_INTRINSIC_TRIANGULATIONS_INLINE bool rational_square_root(const Gmpq& x, Gmpq& root) {
  const Gmpz n = x.numerator(), d = x.denominator();
  if (mpz_perfect_square_p(n.mpz()) == 0 || mpz_perfect_square_p(d.mpz()) == 0) return false;
  root = Gmpq(CGAL::sqrt(n), CGAL::sqrt(d));
  return true;
}

/*!
\brief converts a rational number to `FT`, rounded or enclosed if `FT` is inexact.

A type that is not constructible from `Gmpq` gets about 400 bits, far below the least rounding
error of its own. \pre such values are in the range of `double`
*/
template <class FT>
FT from_rational(const Gmpq& x) {
  if constexpr (std::is_constructible_v<FT, Gmpq>)
    return FT(x);
  else if constexpr (std::is_same_v<FT, double>)
    return CGAL::to_double(x);
  else if constexpr (std::is_same_v<FT, Interval_nt<false>>) {
    const std::pair<double, double> i = CGAL::to_interval(x);
    return FT(i.first, i.second);
  } else {
    FT sum(0);
    Gmpq rest = x;
    for (int digits = 0; digits < 8 && rest != Gmpq(0); ++digits) {
      const double digit = CGAL::to_double(rest);
      sum = sum + FT(digit);
      rest = rest - Gmpq(digit);
    }
    return sum;
  }
}

namespace internal {

template <class FT>
struct Area_computation {};

// a = 2 |u x v| of a face in space, in floating point with a bound on the error, or an interval below
// zero where that is not good enough. With e = 2^-52, whatever the rounding: sides are off by e times
// themselves, the two products of a component by 3e, the norm of the cross product by 4.2 e m at
// most, m the sum of all six products; squares and root add 2.5e a, the
// bounds e a, a <= 2m. Together less than 16 e m.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE Interval_nt<false>
embedded_area_interval(const Input_metric& m, std::uint32_t f) {
  const Input_metric::Sides& s = m.sides(f);
  const Input_metric::Point &p = m.points()[s[0]], &q = m.points()[s[1]], &r = m.points()[s[2]];
  const double u[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  const double v[3] = {r[0] - p[0], r[1] - p[1], r[2] - p[2]};
  double squares = 0, sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double x = u[i] * v[j], y = u[j] * v[i];
    squares = squares + (x - y) * (x - y);
    sum = sum + (std::abs(x) + std::abs(y));
  }
  const double area = 2 * std::sqrt(squares), error = 0x1p-48 * sum;
  if (area > 0x1p-400 && area < 0x1p400 && error <= 0x1p-38 * area)
    return {area - error, area + error};
  return {-1.0, -1.0};
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void check_triangle_inequality(const Gmpq& squared_area,
                                                                    std::uint32_t f) {
  if (squared_area < Gmpq(0))
    throw Invalid_input::about(
        Element_kind::face, f,
        " violates the triangle inequality; correct the lengths of its edges "
        "or mollify them");
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Gmpq checked_squared_quadruple_area(const Input_metric& m,
                                                                         std::uint32_t f) {
  const Gmpq d = m.squared_quadruple_area<Gmpq>(f);
  check_triangle_inequality(d, f);
  return d;
}

// Floating point is trusted where rounding, at most about 2^-52 |u| |v| in a, is below 2^-30 of a
// (a^2 against |u|^2 |v|^2 from points, D against L_0 L_2 from lengths); all else is computed from
// rationals.
template <class FT>
FT quadruple_area_float(const Input_metric& m, std::uint32_t f) {
  if (m.is_embedded()) {
    const Embedded_area<FT> d(m, f);
    if (d.squared > FT(0x1p-40) * d.scale) return CGAL::sqrt(d.squared);
  } else {
    const FT d = m.squared_quadruple_area<FT>(f);
    if (d > FT(0x1p-20) * m.squared_length<FT>(f, 0) * m.squared_length<FT>(f, 2))
      return CGAL::sqrt(d);
  }
  return CGAL::sqrt(from_rational<FT>(checked_squared_quadruple_area(m, f)));
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Interval_nt<false>
quadruple_area_interval(const Input_metric& m, std::uint32_t f) {
  using FT = Interval_nt<false>;
  if (m.is_embedded() && m.delta() == 0) {
    const FT fast = embedded_area_interval(m, f);
    if (fast.inf() > 0) return fast;
  }
  const FT d = m.is_embedded() ? Embedded_area<FT>(m, f).squared : m.squared_quadruple_area<FT>(f);
  if (d.inf() > 0 && d.sup() - d.inf() <= 0x1p-36 * d.sup()) return CGAL::sqrt(d);
  return CGAL::sqrt(from_rational<FT>(checked_squared_quadruple_area(m, f)));
}

template <class FT>
FT quadruple_area_exact(const Input_metric& m, std::uint32_t f) {
  const FT d = m.is_embedded() ? Embedded_area<FT>(m, f).squared : m.squared_quadruple_area<FT>(f);
  if (d < FT(0)) checked_squared_quadruple_area(m, f);
  return CGAL::sqrt(d);
}

template <class FT>
FT quadruple_area_rational(const Input_metric& m, std::uint32_t f) {
  const Gmpq d = checked_squared_quadruple_area(m, f);
  Gmpq root;
  if (!rational_square_root(d, root))
    throw Invalid_input::about(
        Element_kind::face, f,
        " has an irrational area, which this number type cannot hold; use the "
        "exact traits");
  return from_rational<FT>(root);
}

} // namespace internal

template <class FT>
FT quadruple_area(const Input_metric& m, std::uint32_t f) {
  using Structure = Algebraic_structure_traits<FT>;
  if constexpr (std::is_same_v<FT, Interval_nt<false>>)
    return internal::quadruple_area_interval(m, f);
  else if constexpr (std::is_same_v<FT, Interval_nt<true>>) {
    const Protect_FPU_rounding<true> upwards;
    const Interval_nt<false> a = internal::quadruple_area_interval(m, f);
    return {a.inf(), a.sup()};
  } else if constexpr (std::is_same_v<typename Structure::Sqrt, Null_functor>)
    return internal::quadruple_area_rational<FT>(m, f);
  else if constexpr (std::is_same_v<typename Structure::Is_exact, Tag_true>)
    return internal::quadruple_area_exact<FT>(m, f);
  else
    return internal::quadruple_area_float<FT>(m, f);
}

template <class FT>
std::vector<FT> quadruple_areas(const Input_metric& m) {
  std::vector<FT> result;
  result.reserve(m.number_of_faces());
  for (std::uint32_t f = 0; f < m.number_of_faces(); ++f)
    result.push_back(quadruple_area<FT>(m, f));
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INITIAL_VALUES_IMPL_H
