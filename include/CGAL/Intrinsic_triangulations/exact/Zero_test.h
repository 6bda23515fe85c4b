// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_ZERO_TEST_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_ZERO_TEST_H

#include <CGAL/Intrinsic_triangulations/exact/Diamond_zero_test.h>
#include <CGAL/Intrinsic_triangulations/exact/History_zero_test.h>
#include <CGAL/Intrinsic_triangulations/exact/Zero_answer.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolding.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <cstddef>
#include <optional>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief decides whether expressions in the values of a diamond are exactly zero.

The diamond is unfolded from the input along the history of moves (see `Unfolding`) and decided by
`Diamond_zero_test`; where that cannot be, the moves are repeated (see `History_zero_test`).
*/
class Zero_test {
public:
  /// Outcome of the test.
  using Answer = Zero_answer;
  /// A slot of a version of a face.
  using Side = Flip_history::Side;

  /*!
  \brief decides about an expression in the values of the diamond between two sides.
  \param input the input, always the same
  \param history the flips since, always the same but for new flips
  \param left side on the left
  \param right side on the right, glued to `left`
  \param expression a model of `DiamondExpression`
  */
  template <class Expression>
  Answer operator()(const Input_metric& input, const Flip_history& history, Side left, Side right,
                    const Expression& expression) {
    unfold(input, history, left, right);
    return decide(input, history, left, right, expression);
  }

  /// unfolds the diamond between two sides, without deciding anything.
  void unfold(const Input_metric& input, const Flip_history& history, Side left, Side right) {
    if (unfolding_.size() > maximal_memory) unfolding_ = {};
    diamond_.reset();
    // the sides of an edge inside one face are told apart by no `Diamond`
    if (left.version != right.version) diamond_ = unfolding_.diamond(history, left, right);
    if (diamond_ && !is_zero_.is_defined(input, *diamond_)) diamond_.reset();
  }

  /// decides about an expression in the values of the diamond that was unfolded last; parameters as above.
  template <class Expression>
  Answer decide(const Input_metric& input, const Flip_history& history, Side left, Side right,
                const Expression& expression) {
    if (diamond_) return is_zero_(input, *diamond_, expression);
    return History_zero_test(input, history, left, right)(expression);
  }

  /// returns the diamond of the last call, or nothing if it cannot be unfolded.
  const std::optional<Unfolded_diamond>& diamond() const { return diamond_; }

private:
  // entries that are kept between calls, some hundred bytes each
  static constexpr std::size_t maximal_memory = 50000;

  Unfolding unfolding_;
  Diamond_zero_test is_zero_;
  std::optional<Unfolded_diamond> diamond_; // of the last call
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_ZERO_TEST_H
