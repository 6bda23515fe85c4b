// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_EXPRESSION_DEGREE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_EXPRESSION_DEGREE_H

#include <algorithm>

/*!
\file
Of what kind a polynomial is. Some ways to decide its sign are faster, and right for polynomials of some kind only: those that add,
subtract and multiply values of a diamond, without constants. Of which degree one is, which parity it has in the areas, is found by
evaluating it on `Expression_degree`.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief tells of what kind a polynomial in squared lengths and quadruple areas is.

Sums, differences, negations and products of degrees belong to those of polynomials.
*/
struct Expression_degree {
  unsigned total;  ///< degree of a term in lengths and areas together, which scale alike
  unsigned areas;  ///< highest degree of a term in the areas alone
  double terms;    ///< bound on the sum of all coefficients, without their signs
  bool is_uniform; ///< whether all terms have one total degree, and one parity in the areas

  /// constructs a degree; there is none of a constant.
  constexpr Expression_degree(unsigned total_, unsigned areas_, double terms_, bool is_uniform_)
      : total(total_), areas(areas_), terms(terms_), is_uniform(is_uniform_) {}

  /// returns the degree of a squared length.
  static constexpr Expression_degree length() { return {1, 0, 1, true}; }
  /// returns the degree of a quadruple area.
  static constexpr Expression_degree area() { return {1, 1, 1, true}; }

  /// tells whether the polynomial is a sum of a few areas times at most a length each.
  constexpr bool is_linear_in_areas() const {
    return is_uniform && areas == 1 && total <= 2 && terms <= 16;
  }

  /// adds
  friend constexpr Expression_degree operator+(const Expression_degree& a,
                                               const Expression_degree& b) {
    const bool is_alike = a.total == b.total && a.areas % 2 == b.areas % 2;
    return {std::max(a.total, b.total), std::max(a.areas, b.areas), a.terms + b.terms,
            a.is_uniform && b.is_uniform && is_alike};
  }
  /// subtracts
  friend constexpr Expression_degree operator-(const Expression_degree& a,
                                               const Expression_degree& b) {
    return a + b;
  }
  /// negates
  friend constexpr Expression_degree operator-(const Expression_degree& a) { return a; }
  /// multiplies
  friend constexpr Expression_degree operator*(const Expression_degree& a,
                                               const Expression_degree& b) {
    return {a.total + b.total, a.areas + b.areas, a.terms * b.terms, a.is_uniform && b.is_uniform};
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_EXPRESSION_DEGREE_H
