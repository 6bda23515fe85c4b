// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_UNFOLDED_EVALUATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_UNFOLDED_EVALUATION_H

#include <CGAL/Intrinsic_triangulations/exact/Diamond_zero_test.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/escalation.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Gmpfi.h>
#include <CGAL/Interval_nt.h>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief decides signs that floating point intervals leave open, of diamonds that are unfolded from the
input: there is no history.

Most of these values are zero, which a `Diamond_zero_test` tells. If not, they are computed in intervals of
128 bits, and the precision is doubled until the sign shows. Over long strips intervals come first.
*/
class Unfolded_evaluation {
public:
  /*!
  \brief returns the sign of an expression in the values of a diamond.
  \param input the input, always the same
  \param diamond the diamond; no triangle is entered by a side without length
  \param expression a model of `DiamondExpression`
  \param statistics counts how the sign was decided
  */
  // not inline: see `extern template`
  template <class Expression>
  Sign sign(const Input_metric& input, const Unfolded_diamond& diamond,
            const Expression& expression, Predicate_statistics& statistics);

private:
  Diamond_zero_test is_zero_;
  internal::Gmpfi_faces faces_;
};

template <class Expression>
Sign Unfolded_evaluation::sign(const Input_metric& input, const Unfolded_diamond& diamond,
                               const Expression& expression, Predicate_statistics& statistics) {
  const auto is_zero = [&] { return is_zero_(input, diamond, expression); };
  Diamond_values<Interval_nt<false>> better;
  return internal::escalated_sign(
      128U, [&] { return diamond.values<Gmpfi>(faces_.of(input)); },
      internal::tests_zero_first(diamond.triangles.size()), is_zero, expression, better,
      statistics);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_UNFOLDED_EVALUATION_H
