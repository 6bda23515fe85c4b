// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_INTEGER_DIAMOND_SIGN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_INTEGER_DIAMOND_SIGN_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Word_integer.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>

#include <CGAL/enum.h>
#include <CGAL/int.h>
#include <CGAL/number_utils.h>

namespace CGAL::Intrinsic_triangulations::internal {

// The usual expressions as they are written: steps would take half as long again, and most ties are decided here.
template <class Integer>
Integer evaluate(const Recorded_diamond_expression& expression, const Diamond_values<Integer>& d) {
  switch (expression.zero_meaning()) {
  case Zero_meaning::cocircular:
    return Delaunay_expression()(d);
  case Zero_meaning::collinear_at_source:
    return Convexity_at_source_expression()(d);
  case Zero_meaning::collinear_at_target:
    return Convexity_at_target_expression()(d);
  default:
    return expression(d);
  }
}

/*
The sign of an expression that is linear in the areas, A a_f + B a_g, from integer squared lengths.
It follows from the signs of A and B if they agree, else from that of A^2 D_f - B^2 D_g. Coefficients
are sums of at most 16 squared lengths; squared lengths must be below 2^(b - 6) for integers of b bits.
*/
template <class Integer>
Sign integer_diamond_sign(Diamond_values<Integer> d,
                          const Recorded_diamond_expression& expression) {
  d.area_f = 1, d.area_g = 0;
  const Integer a = evaluate(expression, d);
  d.area_f = 0, d.area_g = 1;
  const Integer b = evaluate(expression, d);
  if (a.is_zero() && b.is_zero()) return ZERO; // two right angles
  const auto squared_area = [](const Integer& ij, const Integer& jk, const Integer& ki) {
    const Integer p = (ij + ki - jk).magnitude(); // D = 4 L_ij L_ki - p^2
    return full_product(ij + ij, ki + ki) - full_product(p, p);
  };
  const auto left = squared_area(d.ij, d.jk, d.ki);
  const auto right = squared_area(d.ij, d.mj, d.im);
  const int sign_a = left.is_zero() ? 0 : a.sign(), sign_b = right.is_zero() ? 0 : b.sign();
  if (sign_a == sign_b || sign_b == 0) return CGAL::sign(sign_a);
  if (sign_a == 0) return CGAL::sign(sign_b);
  const Integer m = a.magnitude(), n = b.magnitude();
  const auto x = full_product(full_product(m, m), left),
             y = full_product(full_product(n, n), right);
  return x == y ? ZERO : CGAL::sign(is_less(y, x) ? sign_a : sign_b);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_INTEGER_DIAMOND_SIGN_H
