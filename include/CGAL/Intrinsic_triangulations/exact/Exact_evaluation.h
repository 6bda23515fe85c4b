// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_EVALUATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_EVALUATION_H

#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief decides signs that floating point intervals leave open, of expressions of any degree.

Who asks has unfolded a diamond or a face from the input, as a rule. Ties over strips that are folded
along parallel lines are found first. Then values are computed in doubles, which may be enough: stored ones carry
the errors of all flips before. Most of the others are zero, which a `Diamond_zero_test` tells. If not, values are
computed in intervals of 128 bits, and the precision is doubled until the sign shows, which must happen if the
value is proven not to be zero. One that is only probably zero counts as zero at 1024 bits.

What cannot be unfolded is computed by repeating the flips, from 512 bits on, since errors grow with their number.
Their values are remembered, so that every flip is evaluated once, as a rule. Few signs, and weights, are told by repeating flips in
106 bits or 256, before all have to be followed to unfold anything (`sign_by_flips()`, `weight_by_flips()`). Whether that is done depends
on the history and on what was asked before, not on who unfolds: results are the same with every correspondence.
*/
class Exact_evaluation {
public:
  /// remembers nothing.
  Exact_evaluation() = default;
  /// remembers nothing.
  Exact_evaluation(const Exact_evaluation&) {}
  /// takes the memory of another one.
  Exact_evaluation(Exact_evaluation&&) = default;
  /// forgets everything.
  Exact_evaluation& operator=(const Exact_evaluation&) {
    memory_ = nullptr;
    return *this;
  }
  /// takes the memory of another one.
  Exact_evaluation& operator=(Exact_evaluation&&) = default;
  ~Exact_evaluation() = default;

  /// A slot of a version of a face.
  using Side = Face_side;

  /*!
  \brief returns the sign of an expression in the values of a diamond that is unfolded.
  \param input the input, always the same
  \param diamond the diamond; no triangle is entered by a side without length
  \param expression the expression
  \param better set to intervals that contain the values, about as small as doubles allow, if any were computed
  \param statistics counts how the sign was decided
  */
  Sign sign(const Input_metric& input, const Unfolded_diamond& diamond,
            const Recorded_diamond_expression& expression,
            Diamond_values<Interval_nt<false>>& better, Predicate_statistics& statistics);

  /*!
  \brief returns the sign of an expression in the values of a diamond that is unfolded, which doubles have left open.

  Parameters are as above.
  */
  Sign sign(const Input_metric& input, const Unfolded_diamond& diamond,
            const Recorded_diamond_expression& expression, Predicate_statistics& statistics);

  /*!
  \brief returns the sign of an expression in the values of faces that are unfolded, each the left one of its diamond.
  \param input the input, always the same
  \param faces the faces
  \param expression the expression
  \param better set to intervals that contain the values, about as small as doubles allow
  \param statistics counts how the sign was decided
  */
  Sign sign(const Input_metric& input, const std::vector<Unfolded_diamond>& faces,
            const Recorded_face_expression& expression,
            std::vector<Face_values<Interval_nt<false>>>& better, Predicate_statistics& statistics);

  /*!
  \brief encloses the values of faces that are unfolded.
  \param input the input, always the same
  \param faces the faces
  \param bits 53, 106, 256, or any more
  */
  std::vector<Face_values<Interval_nt<false>>>
  enclosures(const Input_metric& input, const std::vector<Unfolded_diamond>& faces, unsigned bits);

  /// encloses the squared distance of corners i and j of a diamond that is unfolded; see above.
  Interval_nt<false> squared_length(const Input_metric& input, const Unfolded_diamond& diamond,
                                    unsigned bits);

  /// Bits in which the nearest double to any weight is told.
  static constexpr unsigned last_bits = 8192;

  /*!
  \brief returns the double nearest to the cotangent weight of a diamond that is unfolded, if so many bits tell which one
  that is, and it is neither zero nor infinite; with `last_bits` it is returned always.
  \param input, diamond see `sign()`
  \param bits 106, 256, or any more
  */
  std::optional<double> weight(const Input_metric& input, const Unfolded_diamond& diamond,
                               unsigned bits);

  /// returns that of the diamond between two sides, from 512 bits on; see above.
  std::optional<double> weight(const Input_metric& input, const Flip_history& history, Side left,
                               Side right, unsigned bits);

  /// returns that by repeating flips, in 106 bits or 256, unless they are too many in sum; see above.
  std::optional<double> weight_by_flips(const Input_metric& input, const Flip_history& history,
                                        Side left, Side right);

  /*!
  \brief returns the sign of an expression by repeating flips in 106 bits, unless it is zero or not certain, or so many have
  been repeated that all could have been followed instead, to unfold.
  */
  std::optional<Sign> sign_by_flips(const Input_metric& input, const Flip_history& history,
                                    Side left, Side right,
                                    const Recorded_diamond_expression& expression,
                                    Diamond_values<Interval_nt<false>>& better);

  /*!
  \brief returns the sign of an expression in the values of the diamond between two sides.
  \param input the input, always the same
  \param history the flips since, always the same but for new ones
  \param left side on the left
  \param right side on the right, glued to `left`
  \param expression, better, statistics see above
  */
  Sign sign(const Input_metric& input, const Flip_history& history, Side left, Side right,
            const Recorded_diamond_expression& expression,
            Diamond_values<Interval_nt<false>>& better, Predicate_statistics& statistics);

  /// returns the sign of an expression in the values of faces, each from a side on; see above.
  Sign sign(const Input_metric& input, const Flip_history& history, const std::vector<Side>& sides,
            const Recorded_face_expression& expression,
            std::vector<Face_values<Interval_nt<false>>>& better, Predicate_statistics& statistics);

  /// computes intervals that contain the values of faces, each from a side on, in 512 bits at least.
  std::vector<Face_values<Interval_nt<false>>> enclosures(const Input_metric& input,
                                                          const Flip_history& history,
                                                          const std::vector<Side>& sides,
                                                          unsigned bits);

  /// forgets what is remembered of a flip that is undone, the last one.
  void forget_flip(std::uint32_t flip);

private:
  struct Memory;
  Memory& memory(); // made when it is first asked for

  std::shared_ptr<Memory> memory_; // of this object only
};

} // namespace CGAL::Intrinsic_triangulations

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/exact/Exact_evaluation_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_EVALUATION_H
