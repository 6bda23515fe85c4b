// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_EXPRESSION_DEGREE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_EXPRESSION_DEGREE_H

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <concepts>
#include <span>

/*!
\file
What may be asked of a metric: signs of expressions, and what arithmetic may assume of them.

An expression is a functor with a template `operator()`, from the values of a diamond or of a span of faces
to one value, that computes by the operations of a field, constants made of `int` or `double` included. It
gives the same result in every field, so it neither compares nor branches on values. Its sign is decided
exactly, whatever its degree.

Some ways to decide are faster and right for polynomials of some kind only. An expression opts in by a
member `static constexpr bool is_polynomial = true`: it adds, subtracts and multiplies values of a diamond,
and nothing else; there are no constants. Of which degree it is, which parity it has in the areas, need not
be said: it is evaluated on `Expression_degree`. So nothing can be declared that is not true: what is no
such polynomial does not compile. Nothing is assumed of expressions without that member.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief tells of what kind a polynomial in squared lengths and quadruple areas is.

Sums, differences and products of degrees belong to those of polynomials.
*/
struct Expression_degree {
  unsigned total;  ///< degree of a term in lengths and areas together, which scale alike
  unsigned areas;  ///< highest degree of a term in the areas alone
  double terms;    ///< bound on the sum of all coefficients, without their signs
  bool is_uniform; ///< whether all terms have one total degree, and one parity in the areas

  /// constructs a degree; there is none of a constant, so that polynomials with constants do not compile.
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
  /// multiplies
  friend constexpr Expression_degree operator*(const Expression_degree& a,
                                               const Expression_degree& b) {
    return {a.total + b.total, a.areas + b.areas, a.terms * b.terms, a.is_uniform && b.is_uniform};
  }
};

/*!
\brief asks for an expression in the values of a diamond.
*/
template <class Expression>
concept DiamondExpression = requires(const Expression& e,
                                     const Diamond_values<Interval_nt<false>>& values) {
  { e(values) } -> std::convertible_to<Interval_nt<false>>;
};

/*!
\brief asks for an expression in the values of a diamond that is a polynomial without constants.
*/
template <class Expression>
concept PolynomialExpression = DiamondExpression<Expression> && requires {
  requires Expression::is_polynomial;
} && requires(const Expression& e, const Diamond_values<Expression_degree>& values) {
  { e(values) } -> std::same_as<Expression_degree>;
};

/*!
\brief asks for an expression in the values of a span of faces.
*/
template <class Expression>
concept FaceExpression = requires(const Expression& e,
                                  std::span<const Face_values<Interval_nt<false>>> values) {
  { e(values) } -> std::convertible_to<Interval_nt<false>>;
};

/*!
\brief computes the degree of a polynomial expression.
*/
template <PolynomialExpression Expression>
constexpr Expression_degree degree_of(const Expression& expression) {
  constexpr Expression_degree l = Expression_degree::length(), a = Expression_degree::area();
  return expression(Diamond_values<Expression_degree>{l, l, l, l, l, a, a});
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_EXPRESSION_DEGREE_H
