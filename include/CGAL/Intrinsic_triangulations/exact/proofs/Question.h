// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_QUESTION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_QUESTION_H

#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/enum.h>

#include <concepts>

/*!
\file
A proof is a functor from a question to an answer.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is the question for the sign of an expression in the values of a figure.
\tparam Figure_ says how values follow from the input, see `Exact_ladder`
\tparam Expression_ `Recorded_diamond_expression` or `Recorded_face_expression`
*/
template <std::copyable Figure_, std::copyable Expression_>
struct Question {
  /// Type of the figure.
  using Figure = Figure_;
  /// Type of the expression.
  using Expression = Expression_;

  const Input_metric& input;    ///< the input
  const Figure& figure;         ///< the figure; no triangle is entered by a side without length
  const Expression& expression; ///< the expression
};

/// deduces the types.
template <std::copyable Figure, std::copyable Expression>
Question(const Input_metric&, const Figure&, const Expression&) -> Question<Figure, Expression>;

/// The proven property of a value.
enum class Answer {
  negative, ///< it is negative
  zero,     ///< it is zero
  positive, ///< it is positive
  not_zero, ///< it is not zero, of unknown sign
  open      ///< nothing
};

/// returns the answer that names a sign.
constexpr Answer to_answer(Sign s) {
  return s == ZERO ? Answer::zero : s == POSITIVE ? Answer::positive : Answer::negative;
}

/*!
\brief requires a functor that answers questions of one kind.

Syntax of \ref ::ProofOf, which describes its meaning.
*/
template <class Proof, class Asked>
concept ProofOf = requires(Proof& proof, const Asked& question) {
  { proof(question) } -> std::same_as<Answer>;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_QUESTION_H
