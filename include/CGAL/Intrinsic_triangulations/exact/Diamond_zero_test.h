// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_DIAMOND_ZERO_TEST_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_DIAMOND_ZERO_TEST_H

#include <CGAL/Intrinsic_triangulations/exact/Conjugate_bound.h>
#include <CGAL/Intrinsic_triangulations/exact/Conjugate_evaluator.h>
#include <CGAL/Intrinsic_triangulations/exact/Field_zero_test.h>
#include <CGAL/Intrinsic_triangulations/exact/Zero_answer.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Integer_faces.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Prime_field.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief decides whether expressions in the values of a diamond that is unfolded from the input are
exactly zero.

Expressions that are not polynomials, or have terms of different kinds (see `Expression_degree`), are decided by
a `Field_zero_test`. Else every value is a polynomial in the square roots of the areas of some input faces, with rational
coefficients. The expression is evaluated in finite fields of p^2 elements, for all choices of signs of
independent square roots.

- A value that is not zero there proves that the expression is not zero; the first one mostly does.
- Let y be the expression times an integer that makes y an algebraic integer, P the product of the
  primes p done. None divides a representative d_g of the square classes; hence the images for all
  choices of signs vanish only if y / p is an algebraic integer as well, and so is y / P. If y is
  not zero then the norm of y / P is an integer, not zero, thus some conjugate of y is at least P
  in absolute value. So when P exceeds the bound on all conjugates (see `Conjugate_bound`), the
  value is zero.

The cost is that of b / 62 * 2^k evaluations in a finite field, k the number of independent square
roots, b the bits of the bound. No number grows on the way. With more than a few square roots, images
for one choice of signs are taken first, then the terms of the value are added up, which are few in
strips of rectangles (see `Square_class_basis::limit_products()`). Where there are many, beyond
`maximal_dimension` square roots, what vanishes in several fields counts as *probably* zero; beyond the
64 that a `Square_class_basis` holds, everything does.
*/
class Diamond_zero_test {
public:
  /// Number of independent square roots up to which zero is proven.
  static constexpr std::size_t maximal_dimension = 12;

  /*!
  \brief decides about an expression in the values of a diamond.
  \param input the input, always the same
  \param diamond the diamond; no triangle is entered by a side without length
  \param expression the expression
  */
  Zero_answer operator()(const Input_metric& input, const Unfolded_diamond& diamond,
                         const Recorded_diamond_expression& expression) {
    if (expression.degree() && expression.degree()->is_uniform)
      return decide_uniform_polynomial(input, diamond, expression);
    return of_figure(input, diamond, expression);
  }

  /// decides about an expression in the values of any other figure, see `Exact_ladder`, by a `Field_zero_test`.
  template <class Figure, class Expression>
  Zero_answer operator()(const Input_metric& input, const Figure& figure,
                         const Expression& expression) {
    return of_figure(input, figure, expression);
  }

private:
  // entries that are kept between calls, some hundred bytes each
  static constexpr std::size_t maximal_memory = 50000;
  // number of square roots up to which trying all signs is the fastest proof: it takes a millisecond or two there, where
  // adding up the terms of a strip without rectangles took fifty
  static constexpr std::size_t few_roots = 9;
  // largest number of pairs of terms that are multiplied then: a tenth of a second
  static constexpr std::size_t few_pairs = 1 << 19;
  // four primes
  static constexpr double probable_bits = 3.5 * Prime_fields::bits;

  // evaluates in any field
  template <class Figure, class Expression>
  static auto value_of(const Figure& figure, const Expression& expression) {
    return [&](const auto& faces) {
      using Number = typename std::decay_t<decltype(faces)>::Number;
      return expression(figure.template values<Number>(faces));
    };
  }

  template <class Figure, class Expression>
  Zero_answer of_figure(const Input_metric& input, const Figure& figure,
                        const Expression& expression) {
    if (faces_.size() > maximal_memory) faces_ = {};
    return Field_zero_test(input, faces_)(value_of(figure, expression));
  }

  Zero_answer decide_uniform_polynomial(const Input_metric& input, const Unfolded_diamond& diamond,
                                        const Recorded_diamond_expression& expression) {
    if (faces_.size() > maximal_memory) faces_ = {};
    if (!find_shapes(input, diamond)) return Zero_answer::probably_zero;
    if (basis_.dimension() > few_roots) {
      if (!vanishes(diamond, expression, probable_bits, false)) return Zero_answer::not_zero;
      // the terms of the value, if they are not too many
      if (Field_zero_test(input, faces_)
              .is_proven_zero(value_of(diamond, expression), few_pairs))
        return Zero_answer::zero;
      if (basis_.dimension() > maximal_dimension) return Zero_answer::probably_zero;
    }
    const double bits =
        Conjugate_bound(diamond, metric_, diamond.is_in_space(input)).bits(expression);
    return vanishes(diamond, expression, bits, true) ? Zero_answer::zero : Zero_answer::not_zero;
  }

  // evaluates modulo primes whose product has more than `bits` bits
  bool vanishes(const Unfolded_diamond& diamond, const Recorded_diamond_expression& expression,
                double bits, bool for_all_signs) {
    double done = 0;
    for (std::size_t i = 0; done <= bits; ++i) {
      Conjugate_evaluator images(diamond, shapes_, metric_.front()->exponent, basis_, fields_[i]);
      if (!images.is_defined()) continue;
      do
        if (!expression(images.values()).is_zero()) return false;
      while (for_all_signs && images.next());
      done += Prime_fields::bits;
    }
    return true;
  }

  // false if there are too many square roots
  bool find_shapes(const Input_metric& input, const Unfolded_diamond& diamond) {
    basis_ = {};
    metric_.clear();
    shapes_.clear();
    for (const Unfolded_diamond::Triangle& t : diamond.triangles) {
      const Integer_face& face = faces_(input, t.face);
      const std::optional<Square_root> area = basis_.sqrt_of(face.radicand);
      if (!area) return false;
      metric_.push_back(&face);
      shapes_.push_back({&face.squared_lengths, &face.area_factor, *area});
    }
    return true;
  }

  Integer_faces faces_;
  Prime_fields fields_;
  // of the last call
  Square_class_basis basis_;
  std::vector<const Integer_face*> metric_;
  std::vector<Conjugate_evaluator::Shape> shapes_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_DIAMOND_ZERO_TEST_H
