// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_RECORDED_EXPRESSION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_RECORDED_EXPRESSION_H

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Expression_steps.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>

#include <CGAL/Interval_nt.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

/*!
\file
Expressions, whose signs a metric decides.

An expression is a functor with a template `operator()`, from the values of a diamond or of a span
of faces to one value, that computes by the operations of a field, `+ - * /`, constants made of
`int` or `double` included. It gives the same result in every field, so it neither compares nor
branches on values, and has no static numbers and no state that changes. Its sign is decided
exactly, whatever its degree.

Intervals of doubles, which decide nearly all signs, evaluate an expression as it is written. For
what they leave open it is *recorded*: evaluated once on a `Recorded_number`, which keeps the steps.
Other number types then repeat the steps, so that their code is compiled once and not for each
expression. The steps also give the degree of a polynomial (see `Expression_degree`), hence the
right fast ways to decide its sign; users need not declare it.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a symbolic number: it only stores how values and constants compute it.

Operations add a step to the recording that goes on in this thread.
\throws std::logic_error if there is none, as of static numbers
\pre numbers are not kept after the recording they were made in
\cgalModels{FieldNumber}
*/
class Recorded_number {
public:
  /// constructs zero.
  Recorded_number() : Recorded_number(0.0) {}
  /// constructs a constant.
  Recorded_number(double x) // NOLINT(google-explicit-constructor)
      : number_(add(Operation::constant, 0, 0, x)) {}

  /// adds
  friend Recorded_number operator+(const Recorded_number& a, const Recorded_number& b) {
    return {Operation::sum, a, b};
  }
  /// subtracts
  friend Recorded_number operator-(const Recorded_number& a, const Recorded_number& b) {
    return {Operation::difference, a, b};
  }
  /// negates
  friend Recorded_number operator-(const Recorded_number& a) { return {Operation::negation, a, a}; }
  /// multiplies
  friend Recorded_number operator*(const Recorded_number& a, const Recorded_number& b) {
    return {Operation::product, a, b};
  }
  /// divides
  friend Recorded_number operator/(const Recorded_number& a, const Recorded_number& b) {
    return {Operation::quotient, a, b};
  }

  /*!
  \brief records an expression.
  \param number_of_values what it depends on
  \param compute a functor from a functor that returns values by number to the result
  */
  template <class Compute>
  static Expression_steps record(std::uint32_t number_of_values, const Compute& compute) {
    Expression_steps steps(number_of_values);
    const Scope scope(steps);
    steps.finish(compute([](std::uint32_t n) { return Recorded_number(n, Value_tag()); }).number_);
    return steps;
  }

private:
  using Operation = Expression_steps::Operation;
  struct Value_tag {};

  // lets numbers of this thread be recorded in a list
  struct Scope {
    explicit Scope(Expression_steps& steps) : previous(std::exchange(recording(), &steps)) {}
    ~Scope() { recording() = previous; }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    Expression_steps* previous;
  };

  Recorded_number(std::uint32_t number, Value_tag) : number_(number) {}
  Recorded_number(Operation operation, const Recorded_number& a, const Recorded_number& b)
      : number_(add(operation, a.number_, b.number_)) {}

  static std::uint32_t add(Operation operation, std::uint32_t a, std::uint32_t b, double x = 0) {
    if (recording() == nullptr)
      throw std::logic_error("numbers of an expression are made while it is recorded: it has no "
                             "static numbers");
    return recording()->add(operation, a, b, x);
  }
  static Expression_steps*& recording() {
    thread_local Expression_steps* steps = nullptr;
    return steps;
  }

  std::uint32_t number_;
};

/*!
\brief requires an expression in the values of a diamond.

Syntax of \ref ::DiamondExpression, which describes its meaning.
*/
template <class Expression>
concept DiamondExpression = requires(const Expression& e,
                                     const Diamond_values<Interval_nt<false>>& values,
                                     const Diamond_values<Recorded_number>& recorded) {
  { e(values) } -> std::convertible_to<Interval_nt<false>>;
  { e(recorded) } -> std::convertible_to<Recorded_number>;
};

/*!
\brief requires an expression in the values of a span of faces.

Syntax of \ref ::FaceExpression, which describes its meaning.
*/
template <class Expression>
concept FaceExpression = requires(const Expression& e,
                                  std::span<const Face_values<Interval_nt<false>>> values,
                                  std::span<const Face_values<Recorded_number>> recorded) {
  { e(values) } -> std::convertible_to<Interval_nt<false>>;
  { e(recorded) } -> std::convertible_to<Recorded_number>;
};

/// The geometric meaning of a zero of an expression; some proofs use it.
enum class Zero_meaning {
  cocircular,          ///< the corners of the diamond are: `Delaunay_expression`
  collinear_at_source, ///< corners k, i, m are: `Convexity_at_source_expression`
  collinear_at_target, ///< corners k, j, m are: `Convexity_at_target_expression`
  other                ///< unknown
};

/*!
\brief is an expression in the values of a diamond that can be evaluated in any field.
*/
class Recorded_diamond_expression {
public:
  /// records an expression.
  template <DiamondExpression Expression>
  explicit Recorded_diamond_expression(const Expression& expression)
      : Recorded_diamond_expression(
            Recorded_number::record(7,
                                    [&](const auto& x) {
                                      return Recorded_number(
                                          expression(Diamond_values<Recorded_number>{
                                              x(0), x(1), x(2), x(3), x(4), x(5), x(6)}));
                                    }),
            meaning_of<Expression>()) {}

  /// evaluates the expression. \tparam FT see `Expression_steps::run()`
  template <class FT>
  FT operator()(const Diamond_values<FT>& d) const {
    const std::array<const FT*, 7> values{&d.ij, &d.jk, &d.ki, &d.im, &d.mj, &d.area_f, &d.area_g};
    return steps_.run<FT>(values);
  }

  /// returns the degree; nothing if the expression has constants or quotients.
  const std::optional<Expression_degree>& degree() const { return degree_; }
  /// tells whether it is a sum of a few areas times at most a length each.
  bool is_linear_in_areas() const { return degree_ && degree_->is_linear_in_areas(); }
  /// returns the geometric meaning of a zero.
  Zero_meaning zero_meaning() const { return meaning_; }

private:
  Recorded_diamond_expression(Expression_steps&& steps, Zero_meaning meaning);

  template <class Expression>
  static constexpr Zero_meaning meaning_of() {
    if (std::is_same_v<Expression, Delaunay_expression>) return Zero_meaning::cocircular;
    if (std::is_same_v<Expression, Convexity_at_source_expression>)
      return Zero_meaning::collinear_at_source;
    if (std::is_same_v<Expression, Convexity_at_target_expression>)
      return Zero_meaning::collinear_at_target;
    return Zero_meaning::other;
  }

  Expression_steps steps_;
  Zero_meaning meaning_;
  std::optional<Expression_degree> degree_;
};

namespace internal {

// those of the library depend only on the values; another one without data may still read global
// state
template <class Expression>
inline constexpr bool is_recorded_once =
    std::is_same_v<Expression, Delaunay_expression> ||
    std::is_same_v<Expression, Left_area_expression> ||
    std::is_same_v<Expression, Right_cosine_expression> ||
    std::is_same_v<Expression, Convexity_at_source_expression> ||
    std::is_same_v<Expression, Convexity_at_target_expression>;

} // namespace internal

/// records an expression; each of the library once for all.
template <DiamondExpression Expression>
decltype(auto) recorded(const Expression& expression) {
  if constexpr (internal::is_recorded_once<Expression>) {
    static const Recorded_diamond_expression once(expression);
    return (once);
  } else
    return Recorded_diamond_expression(expression);
}

/*!
\brief is an expression in the values of faces that can be evaluated in any field.
*/
class Recorded_face_expression {
public:
  /// records an expression in the values of so many faces.
  template <FaceExpression Expression>
  Recorded_face_expression(const Expression& expression, std::size_t number_of_faces)
      : steps_(Recorded_number::record(
            static_cast<std::uint32_t>(4 * number_of_faces), [&](const auto& x) {
              std::vector<Face_values<Recorded_number>> faces;
              for (std::uint32_t n = 0; n < 4 * number_of_faces; n += 4)
                faces.push_back({{x(n), x(n + 1), x(n + 2)}, x(n + 3)});
              return Recorded_number(
                  expression(std::span<const Face_values<Recorded_number>>(faces)));
            })) {
    if constexpr (std::is_same_v<Expression, Wedge_sine_expression>)
      of_sides_ = &recorded(Convexity_at_source_expression());
    if constexpr (std::is_same_v<Expression, Wedge_cosine_expression>)
      of_sides_ = &recorded(Right_cosine_expression());
  }

  /// evaluates the expression. \tparam FT a field \pre there are as many faces as were recorded
  template <class FT>
  FT operator()(const std::vector<Face_values<FT>>& faces) const {
    std::vector<const FT*> values;
    for (const Face_values<FT>& f : faces) {
      for (const FT& l : f.squared_lengths) values.push_back(&l);
      values.push_back(&f.quadruple_area);
    }
    return steps_.run<FT>(values);
  }

  /// returns an expression in the diamond of the two sides of a wedge, see
  /// `Diamond_unfolder::wedge()`, with the same sign; null if the expression is another one.
  const Recorded_diamond_expression* of_sides() const { return of_sides_; }

private:
  Expression_steps steps_;
  const Recorded_diamond_expression* of_sides_ = nullptr;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_RECORDED_EXPRESSION_H
