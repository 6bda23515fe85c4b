// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INITIAL_VALUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INITIAL_VALUES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
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

namespace internal {

// \cond complete where areas of any number type are defined
template <class FT>
struct Area_computation;
// \endcond

// whether `quadruple_areas()` are there: those of doubles and intervals may be compiled already
template <class FT>
inline constexpr bool has_quadruple_areas =
    std::is_same_v<FT, double> || std::is_same_v<FT, Interval_nt<false>> || requires {
  sizeof(Area_computation<FT>);
};

// D = 4 |u x v|^2 with u and v two sides: far more accurate on slivers than the form in squared
// lengths. Also |u|^2 |v|^2, against which rounding errors are to be compared.
template <class FT>
struct Embedded_area {
  FT squared, scale;

  Embedded_area(const Input_metric& m, std::uint32_t f) {
    const Input_metric::Sides& s = m.sides(f);
    const Input_metric::Point &p = m.points()[s[0]], &q = m.points()[s[1]], &r = m.points()[s[2]];
    FT u[3], v[3];
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = FT(q[k]) - FT(p[k]);
      v[k] = FT(r[k]) - FT(p[k]);
    }
    const FT x = u[1] * v[2] - u[2] * v[1];
    const FT y = u[2] * v[0] - u[0] * v[2];
    const FT z = u[0] * v[1] - u[1] * v[0];
    squared = FT(4) * (square(x) + square(y) + square(z));
    const FT uu = square(u[0]) + square(u[1]) + square(u[2]);
    const FT vv = square(v[0]) + square(v[1]) + square(v[2]);
    scale = uu * vv;
    if (m.delta() > 0) { // adding delta to all L adds 2 delta (L_0 + L_1 + L_2) + 3 delta^2 to D
      const FT delta(m.delta());
      const FT sum = uu + vv + Input_metric::squared_distance<FT>(q, r);
      squared = squared + delta * (FT(2) * sum + FT(3) * delta);
    }
  }
};

// |p - q|^2, when rounding upwards; faster than interval arithmetic, which does not know that both
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

} // namespace internal

/*!
\brief computes the quadruple area 4A of input face `f`, in scaled units.

Inexact types are accurate to about 2^-30 even on slivers, and zero exactly where the area is zero;
exact types with square root are exact; types without are exact where the area is rational.
\tparam FT a number type
\throws Invalid_input if the face violates the triangle inequality, or its area is irrational and
  `FT` has no square root
*/
template <class FT>
FT quadruple_area(const Input_metric& m, std::uint32_t f);

/*!
\brief computes the squared lengths of all edges, in scaled units.
\tparam FT a number type constructible from `double`
\complexity linear
*/
template <class FT>
std::vector<FT> squared_lengths(const Input_metric& m, const Gluing_map& mesh) {
  std::vector<FT> result;
  result.reserve(mesh.number_of_edges());
  const FT delta(m.delta());
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e) {
    if (m.is_embedded()) {
      const Input_metric::Point& p = m.points()[mesh.source({2 * e}).index];
      const Input_metric::Point& q = m.points()[mesh.target({2 * e}).index];
      if constexpr (std::is_same_v<FT, Interval_nt<false>>)
        result.push_back(internal::squared_distance_interval(p, q));
      else
        result.push_back(Input_metric::squared_distance<FT>(p, q));
    } else
      result.push_back(FT(m.squared_lengths()[e]));
    if (m.delta() > 0) result.back() = result.back() + delta;
  }
  return result;
}

/*!
\brief computes the quadruple areas of all faces, in scaled units.
\tparam FT as for `quadruple_area()`
\throws Invalid_input as `quadruple_area()`
\complexity linear
*/
template <class FT>
std::vector<FT> quadruple_areas(const Input_metric& m);

} // namespace CGAL::Intrinsic_triangulations

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/input/initial_values_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INITIAL_VALUES_H
