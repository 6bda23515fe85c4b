// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_TRIANGLE_FORMULAS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_TRIANGLE_FORMULAS_H

#include <CGAL/Intrinsic_triangulations/formulas/compensated_arithmetic.h>

#include <CGAL/Uncertain.h>
#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

/*!
\file
Triangle inequality and area of triangles given by lengths or by points.

The three sides of triangle ijk are always passed as ij, jk, ki. `l` is a length, `L` its square,
`a = 4A` the quadruple area.

`FT` is any CGAL number type: `double`, `long double`, `CGAL::Interval_nt`, `CGAL::Gmpq`,
`CORE::Expr`, ...; those without square root do wherever the formula has none. Error bounds are for
floating point types, relative to the exact value for the *given* numbers, with u = epsilon / 2,
where nothing over- or underflows: see `scaling.h`. They hold on needles and caps.

References: N. Sharp, M. Gillespie, K. Crane, *Geometry Processing with Intrinsic Triangulations*,
2021, §2.3.6 and Appendix A; W. Kahan, *Miscalculating Area and Angles of a Needle-like Triangle*,
2014.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief tells whether no side is longer than the other two together.

Exact for floating point types: with x >= y >= z, x - y is exact unless it exceeds z anyway.
\return `bool`, or `Uncertain<bool>` if `FT` is not a floating point type
*/
template <class FT>
auto satisfies_triangle_inequality(const FT& l_ij, const FT& l_jk, const FT& l_ki) {
  if constexpr (internal::is_floating_point<FT>) {
    FT x = l_ij, y = l_jk, z = l_ki;
    internal::sort_descending(x, y, z);
    return z >= x - y;
  } else {
    return make_uncertain(l_ij + l_jk >= l_ki) & make_uncertain(l_jk + l_ki >= l_ij) &
           make_uncertain(l_ki + l_ij >= l_jk);
  }
}

/*!
\brief computes (4A)^2 from squared lengths.

4 y z - (y + z - x)^2, with x >= y >= z the squared lengths: the terms are then the smallest, so that
needles are accurate. Floating point types keep all rounding errors, so that caps are, too. Negative
iff the square roots of the arguments violate the triangle inequality.
\tparam FT a commutative ring; no division, no square root
\return the value, with relative error at most 2 u + 20 u^2 4yz / (4A)^2
*/
template <class FT>
FT squared_quadruple_area(const FT& L_ij, const FT& L_jk, const FT& L_ki) {
  FT x = L_jk, y = L_ij, z = L_ki;
  internal::sort_descending(x, y, z);
  if constexpr (internal::is_floating_point<FT>) {
    const auto p = internal::two_sum(y, -x, z);
    const auto yz = internal::two_product(4 * y, z);
    const auto pp = internal::two_product(p.high, p.high);
    return (yz.high - pp.high) + ((yz.low - pp.low) - (p.high + p.high + p.low) * p.low);
  } else {
    const FT p = z - (x - y);
    return FT(4) * y * z - p * p;
  }
}

/*!
\brief computes 4A from squared lengths, \f$ \sqrt{4 L_{ij} L_{ki} - p_i^2} \f$.
\pre the triangle inequality; a violation within rounding (of the arguments, too) counts
  as zero area
\return the value, with relative error at most 2 u + 10 u^2 4yz / (4A)^2, see
  `squared_quadruple_area()`
*/
template <class FT>
FT quadruple_area_from_squared_lengths(const FT& L_ij, const FT& L_jk, const FT& L_ki) {
  const FT d = squared_quadruple_area(L_ij, L_jk, L_ki);
  if constexpr (internal::is_floating_point<FT>) {
    CGAL_precondition(d >=
                      -4 * std::numeric_limits<FT>::epsilon() * CGAL::square(L_ij + L_jk + L_ki));
    return d > 0 ? std::sqrt(d) : FT(0);
  } else {
    CGAL_precondition(d >= FT(0));
    return CGAL::sqrt(d);
  }
}

/*!
\brief computes 4A from lengths by Heron's formula (Eq. 1, 19) in Kahan's order.

\f$ \sqrt{(x + (y + z)) (z - (x - y)) (z + (x - y)) (x + (y - z))} \f$ with x >= y >= z.
\pre `satisfies_triangle_inequality()`
\return the value, with relative error at most 6 u
*/
template <class FT>
FT quadruple_area_from_lengths(const FT& l_ij, const FT& l_jk, const FT& l_ki) {
  CGAL_precondition(satisfies_triangle_inequality(l_ij, l_jk, l_ki));
  FT x = l_ij, y = l_jk, z = l_ki;
  internal::sort_descending(x, y, z);
  return CGAL::sqrt((x + (y + z)) * (z - (x - y)) * (z + (x - y)) * (x + (y - z)));
}

namespace internal {

// The cross product (q - p) x (r - p).
template <class FT>
std::array<FT, 3> cross_product(const std::array<FT, 3>& p, const std::array<FT, 3>& q,
                                const std::array<FT, 3>& r) {
  std::array<Unevaluated_sum<FT>, 3> v, w;
  for (unsigned c = 0; c < 3; ++c) {
    v[c] = difference(q[c], p[c]);
    w[c] = difference(r[c], p[c]);
  }
  return {difference_of_products(v[1], w[2], v[2], w[1]),
          difference_of_products(v[2], w[0], v[0], w[2]),
          difference_of_products(v[0], w[1], v[1], w[0])};
}

template <std::size_t n, class FT>
FT squared_distance(const std::array<FT, n>& p, const std::array<FT, n>& q) {
  FT result(0);
  for (std::size_t c = 0; c < n; ++c) result = result + CGAL::square(FT(p[c] - q[c]));
  return result;
}

// The corner between the two shortest sides: the product of their lengths bounds rounding.
template <std::size_t n, class FT>
unsigned best_corner(const std::array<std::array<FT, n>, 3>& points) {
  unsigned best = 0;
  if constexpr (is_rounded<FT>) {
    FT longest = squared_distance(points[1], points[2]);
    for (unsigned c = 1; c < 3; ++c) {
      const FT opposite = squared_distance(points[(c + 1) % 3], points[(c + 2) % 3]);
      if (!is_less(longest, opposite)) continue;
      longest = opposite;
      best = c;
    }
  }
  return best;
}

} // namespace internal

/*!
\brief computes 4A from three points in space, \f$ 2 |(q - p) \times (r - p)| \f$ (§2.3.6).

The cross product is that of the two shortest sides, and floating point types keep the rounding
errors of coordinate differences and of products.
\tparam FT the number type to compute in
\tparam Point has `operator[]` for three coordinates convertible to `FT`
\return the value, with relative error at most 7 u + O(u^2) s t / (4A), with s and t the two shortest
  sides
*/
template <class FT, class Point>
FT quadruple_area_from_points(const Point& p, const Point& q, const Point& r) {
  const std::array<std::array<FT, 3>, 3> points{{{FT(p[0]), FT(p[1]), FT(p[2])},
                                                 {FT(q[0]), FT(q[1]), FT(q[2])},
                                                 {FT(r[0]), FT(r[1]), FT(r[2])}}};
  const unsigned c = internal::best_corner(points);
  const std::array<FT, 3> n =
      internal::cross_product(points[c], points[(c + 1) % 3], points[(c + 2) % 3]);
  return FT(2) * CGAL::sqrt(FT(CGAL::square(n[0]) + CGAL::square(n[1]) + CGAL::square(n[2])));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_TRIANGLE_FORMULAS_H
