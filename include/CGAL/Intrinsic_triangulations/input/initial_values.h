// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INITIAL_VALUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INITIAL_VALUES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/formulas/Space_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Gmpz.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

/*!
\file
Squared lengths and quadruple areas of the input in a given number type: the only place where a
square root is taken.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief computes the exact square root of a rational number that is a square.
\return whether `x` is the square of a rational; if so, `root` is set to its nonnegative root
*/
bool rational_square_root(const Gmpq& x, Gmpq& root);

/*!
\brief converts a rational number to `FT`, rounded or enclosed if `FT` is inexact.

A type that is not constructible from `Gmpq` gets about 400 bits, far below the least rounding
error of its own. \pre such values are in the range of `double`
*/
template <FieldNumber FT>
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

// D = 4 |u x v|^2 with u and v two sides: far more accurate on slivers than the form in squared
// lengths.
template <class FT>
struct Embedded_area {
  FT squared;

  Embedded_area(const Input_metric& m, std::uint32_t f) {
    const Input_metric::Sides& s = m.sides(f);
    const auto point = [&](unsigned k) {
      const Input_metric::Point& p = m.points()[s[k]];
      return Space_vector<FT>{FT(p[0]), FT(p[1]), FT(p[2])};
    };
    u_ = difference(point(1), point(0));
    v_ = difference(point(2), point(0));
    if (m.has_excess(f)) {
      squared = m.squared_quadruple_area<FT>(f);
      return;
    }
    squared = FT(4) * norm(cross_product(u_, v_));
    if (m.delta() > 0) { // adding delta to all L adds 2 delta (L_0 + L_1 + L_2) + 3 delta^2 to D
      const FT delta(m.delta());
      const FT sum = norm(u_) + norm(v_) +
                     Input_metric::squared_distance<FT>(m.points()[s[1]], m.points()[s[2]]);
      squared = squared + delta * (FT(2) * sum + FT(3) * delta);
    }
  }

  // |u|^2 |v|^2, against which rounding errors are to be compared; optional, since it is a third of
  // the work. The face must not have an excess.
  FT scale() const { return norm(u_) * norm(v_); }

private:
  static FT norm(const Space_vector<FT>& a) { return square(a[0]) + square(a[1]) + square(a[2]); }

  Space_vector<FT> u_, v_;
};

// |p - q|^2, when rounding upwards; faster than interval arithmetic, which does not use that both
// bounds of a rounded difference have one sign.
inline Interval_nt<false> squared_distance_interval(const Input_metric::Point& p,
                                                    const Input_metric::Point& q) {
  double minus_inf = 0, sup = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = std::abs(p[k] - q[k]),
                 b = std::abs(q[k] - p[k]); // the difference lies between
    const double low = std::min(a, b), high = std::max(a, b);
    minus_inf = minus_inf + -low * low;
    sup = sup + high * high;
  }
  return {-minus_inf, sup};
}

// exactly
template <class FT>
FT checked_squared_quadruple_area(const Input_metric& m, std::uint32_t f) {
  const FT d = m.squared_quadruple_area<FT>(f);
  if (d < FT(0))
    throw Invalid_input::about(
        Element_kind::face, f,
        " violates the triangle inequality; correct the lengths of its edges "
        "or mollify them");
  return d;
}

// Floating point is trusted where rounding, at most about 2^-52 |u| |v| in a, is below 2^-30 of a
// (a^2 against |u|^2 |v|^2 from points, D against L_0 L_2 from lengths); all else is computed from
// rationals.
template <class FT>
FT quadruple_area_float(const Input_metric& m, std::uint32_t f) {
  if (m.is_embedded() && !m.has_excess(f)) {
    const Embedded_area<FT> d(m, f);
    if (d.squared > FT(0x1p-40) * d.scale()) return CGAL::sqrt(d.squared);
  } else {
    const FT d = m.squared_quadruple_area<FT>(f);
    if (d > FT(0x1p-20) * m.squared_length<FT>(f, 0) * m.squared_length<FT>(f, 2))
      return CGAL::sqrt(d);
  }
  return CGAL::sqrt(from_rational<FT>(checked_squared_quadruple_area<Gmpq>(m, f)));
}

Interval_nt<false> quadruple_area_interval(const Input_metric& m, std::uint32_t f);

template <class FT>
FT quadruple_area_exact(const Input_metric& m, std::uint32_t f) {
  const FT d = m.is_embedded() ? Embedded_area<FT>(m, f).squared : m.squared_quadruple_area<FT>(f);
  if (d < FT(0)) checked_squared_quadruple_area<Gmpq>(m, f);
  return CGAL::sqrt(d);
}

template <class FT>
FT quadruple_area_rational(const Input_metric& m, std::uint32_t f) {
  const Gmpq d = checked_squared_quadruple_area<Gmpq>(m, f);
  Gmpq root;
  if (!rational_square_root(d, root))
    throw Invalid_input::about(
        Element_kind::face, f,
        " has an irrational area, which this number type cannot hold; use the "
        "exact traits");
  return from_rational<FT>(root);
}

// By edge; empty if there is none.
std::vector<double> excess_of_edges(const Input_metric& m, const Gluing_map& mesh);

} // namespace internal

/*!
\brief computes the quadruple area 4A of input face `f`, in scaled units.

Inexact types are accurate to about 2^-30 even on slivers, and zero exactly where the area is zero;
exact types with square root are exact; types without are exact where the area is rational.
\tparam FT a number type
\throws Invalid_input if the face violates the triangle inequality, or its area is irrational and
  `FT` has no square root
*/
template <FieldNumber FT>
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

namespace internal {

// Calls `visit()` with the squared length of each edge.
template <FieldNumber FT, class Visit>
void for_each_squared_length(const Input_metric& m, const Gluing_map& mesh, const Visit& visit) {
  const std::vector<double> excess = excess_of_edges(m, mesh);
  const FT delta(m.delta());
  const auto length = [&](std::uint32_t e) -> FT {
    if (!m.is_embedded()) return FT(m.squared_lengths()[e]);
    const Input_metric::Point& p = m.points()[mesh.source({2 * e}).index];
    const Input_metric::Point& q = m.points()[mesh.target({2 * e}).index];
    if constexpr (std::is_same_v<FT, Interval_nt<false>>)
      return squared_distance_interval(p, q);
    else
      return Input_metric::squared_distance<FT>(p, q);
  };
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e) {
    FT l = length(e);
    if (m.delta() > 0) l = l + delta;
    if (!excess.empty() && excess[e] != 0) l = l + FT(excess[e]);
    visit(l);
  }
}

} // namespace internal

/*!
\brief computes the squared lengths of all edges, in scaled units.
\tparam FT a number type constructible from `double`
\complexity linear
*/
template <FieldNumber FT>
std::vector<FT> squared_lengths(const Input_metric& m, const Gluing_map& mesh) {
  std::vector<FT> result;
  result.reserve(mesh.number_of_edges());
  internal::for_each_squared_length<FT>(m, mesh, [&](const FT& l) { result.push_back(l); });
  return result;
}

/*!
\brief computes the quadruple areas of all faces, in scaled units.
\tparam FT as for `quadruple_area()`
\throws Invalid_input as `quadruple_area()`
\complexity linear
*/
template <FieldNumber FT>
std::vector<FT> quadruple_areas(const Input_metric& m) {
  std::vector<FT> result;
  result.reserve(m.number_of_faces());
  for (std::uint32_t f = 0; f < m.number_of_faces(); ++f)
    result.push_back(quadruple_area<FT>(m, f));
  return result;
}

/// \cond
extern template double quadruple_area(const Input_metric&, std::uint32_t);
extern template Interval_nt<false> quadruple_area(const Input_metric&, std::uint32_t);
extern template std::vector<double> quadruple_areas(const Input_metric&);
extern template std::vector<Interval_nt<false>> quadruple_areas(const Input_metric&);
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INITIAL_VALUES_H
