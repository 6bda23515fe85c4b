// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_EXPRESSION_STEPS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_EXPRESSION_STEPS_H

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief describes the kind of a polynomial in squared lengths and quadruple areas: some fast
decisions of signs are right only for some kinds.

It is found by evaluating the polynomial on numbers of this type. Sums, differences, negations and
products of degrees belong to those of polynomials.
*/
struct Expression_degree {
  unsigned total;  ///< degree of a term in lengths and areas together, which scale alike
  unsigned areas;  ///< highest degree of a term in the areas alone
  double terms;    ///< bound on the sum of all coefficients, without their signs
  bool is_uniform; ///< whether all terms have one total degree, and one parity in the areas

  /// constructs a degree; constants have none.
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

/*!
\brief lists the operations of an expression in order.
*/
class Expression_steps {
public:
  /// The operation of a step.
  enum class Operation : std::uint32_t {
    constant,   ///< gives a constant of the expression
    sum,        ///< adds
    difference, ///< subtracts
    negation,   ///< changes the sign of the first operand; there is no second one
    product,    ///< multiplies
    quotient    ///< divides
  };

  /// constructs a list without steps, of an expression in so many values.
  explicit Expression_steps(std::uint32_t number_of_values) : values_(number_of_values) {
    steps_.reserve(12); // those of two faces have no more
  }

  /// adds a step. \return the number of its result, where the first numbers are those of the values
  std::uint32_t add(Operation operation, std::uint32_t a, std::uint32_t b, double constant = 0) {
    steps_.push_back({operation, a, b, false, false, constant});
    return values_ + static_cast<std::uint32_t>(steps_.size()) - 1;
  }
  /// makes a value or the result of a step the result of all.
  void finish(std::uint32_t result) {
    result_ = result;
    if (steps_.size() > few_steps) find_last_uses();
  }

  /// tells whether there are neither constants nor quotients.
  bool is_polynomial() const {
    return std::none_of(steps_.begin(), steps_.end(), [](const Step& s) {
      return s.operation == Operation::constant || s.operation == Operation::quotient;
    });
  }

  /*!
  \brief repeats the steps. If there are many, it frees results after their last use, since numbers
  may grow with every step.
  \tparam FT a ring; a field made of doubles too, unless `is_polynomial()`
  \param values as many as the expression depends on
  */
  template <class FT>
  FT run(std::span<const FT* const> values) const;

private:
  struct Step {
    Operation operation;
    std::uint32_t a, b;
    bool is_last_of_a, is_last_of_b; // uses of results of steps; left out where there are few
    double constant;
  };

  // whose results are not worth freeing: in 256 bits they take seven kilobytes
  static constexpr std::size_t few_steps = 32;

  void find_last_uses();

  std::uint32_t values_;
  std::uint32_t result_ = 0;
  std::vector<Step> steps_;
};

template <class FT>
FT Expression_steps::run(std::span<const FT* const> values) const {
  boost::container::small_vector<FT, 12> results;
  results.reserve(steps_.size());
  const auto at = [&](std::uint32_t n) -> const FT& {
    return n < values.size() ? *values[n] : results[n - values.size()];
  };
  for (const Step& s : steps_) {
    switch (s.operation) {
    case Operation::sum:
      results.push_back(at(s.a) + at(s.b));
      break;
    case Operation::difference:
      results.push_back(at(s.a) - at(s.b));
      break;
    case Operation::negation:
      results.push_back(-at(s.a));
      break;
    case Operation::product:
      results.push_back(at(s.a) * at(s.b));
      break;
    default:
      if constexpr (std::is_constructible_v<FT, double> && requires(const FT& x) { x / x; })
        results.push_back(s.operation == Operation::constant ? FT(s.constant)
                                                             : FT(at(s.a) / at(s.b)));
      else
        throw std::logic_error("an expression that is no polynomial is evaluated in a ring");
    }
    if constexpr (std::is_default_constructible_v<FT>) {
      if (s.is_last_of_a) results[s.a - values.size()] = FT();
      if (s.is_last_of_b) results[s.b - values.size()] = FT();
    }
  }
  return at(result_);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_EXPRESSION_STEPS_H
