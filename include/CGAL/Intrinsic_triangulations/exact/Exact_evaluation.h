// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_EVALUATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_EVALUATION_H

#include <CGAL/Intrinsic_triangulations/exact/Diamond_zero_test.h>
#include <CGAL/Intrinsic_triangulations/exact/History_zero_test.h>
#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/escalation.h>
#include <CGAL/Intrinsic_triangulations/exact/is_cocircular_strip.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Integer_faces.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/History_evaluator.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolding.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Gmpfi.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief decides signs that floating point intervals leave open, of expressions of any degree.

A diamond is unfolded from the input, along the history of moves or by who asks. Ties over strips that are folded
along parallel lines are found first. Then values are computed in doubles, which may be enough: stored ones carry
the errors of all flips before. Most of the others are zero, which a `Diamond_zero_test` tells. If not, values are
computed in intervals of 128 bits, and the precision is doubled until the sign shows, which must happen if the
value is proven not to be zero. One that is only probably zero counts as zero at 1024 bits.

Where a diamond or a face cannot be unfolded, or inserted vertices are defined by many others, values are computed
by the moves instead, from 512 bits on, since errors grow with the moves. They are remembered, so that every move
is evaluated once, as a rule.
*/
class Exact_evaluation {
public:
  /// A slot of a version of a face.
  using Side = Face_side;

  /*!
  \brief returns the sign of an expression in the values of the diamond between two sides.
  \param input the input, always the same
  \param history the moves since, always the same but for new moves
  \param left side on the left
  \param right side on the right, glued to `left`
  \param expression a model of `DiamondExpression`
  \param better set to intervals that contain the values, about as small as doubles allow, if any were computed
  \param statistics counts how the sign was decided
  */
  template <class Expression>
  Sign sign(const Input_metric& input, const Flip_history& history, Side left, Side right,
            const Expression& expression, Diamond_values<Interval_nt<false>>& better,
            Predicate_statistics& statistics) {
    unfold(input, history, left, right);
    if (!diamond_)
      return internal::escalated_sign(
          history_bits, [&] { return values(input, history, left, right); }, true,
          [&] { return decide(input, history, left, right, expression); }, expression, better,
          statistics);
    if (is_tie_of_strip(input, *diamond_, expression)) {
      ++statistics.certified_zero;
      return ZERO;
    }
    const auto in_doubles = diamond_->values<Interval_nt<false>>(doubles_.of(input));
    const Interval_nt<false> value = expression(in_doubles);
    const Uncertain<Sign> s = CGAL::sign(value);
    if (is_certain(s)) {
      better = in_doubles;
      ++statistics.escalations[53];
      return get_certain(s);
    }
    const bool is_short_ = is_short(*diamond_);
    return internal::escalated_sign(
        is_short_ ? first_bits : history_bits,
        [&] { return is_short_ ? values(input, *diamond_) : values(input, history, left, right); },
        internal::tests_zero_first(diamond_->triangles.size(), value),
        [&] { return is_zero_(input, *diamond_, expression); }, expression, better, statistics);
  }

  /*!
  \brief returns the sign of an expression in the values of a diamond that is unfolded, which doubles have left open.
  \param input the input, always the same
  \param diamond the diamond; no triangle is entered by a side without length
  \param expression a model of `DiamondExpression`
  \param statistics counts how the sign was decided
  */
  // not inline: see `extern template`
  template <class Expression>
  Sign sign(const Input_metric& input, const Unfolded_diamond& diamond,
            const Expression& expression, Predicate_statistics& statistics);

  /*!
  \brief returns the sign of an expression in the values of faces, each from a side on.

  Here values are tested for zero only if their sign does not show in the first precision.
  \param input the input
  \param history the moves since
  \param sides the first side of each face
  \param expression a model of `FaceExpression`
  \param better set to intervals that contain the values, about as small as doubles allow
  \param statistics counts how the sign was decided
  */
  template <class Expression>
  Sign sign(const Input_metric& input, const Flip_history& history, const std::vector<Side>& sides,
            const Expression& expression, std::vector<Face_values<Interval_nt<false>>>& better,
            Predicate_statistics& statistics) {
    const std::vector<Unfolded_diamond> unfolded = unfold(input, history, sides);
    if (!unfolded.empty()) {
      const auto in_doubles = face_values<Interval_nt<false>>(doubles_.of(input), unfolded);
      const Uncertain<Sign> s = CGAL::sign(expression(std::span(in_doubles)));
      if (is_certain(s)) {
        better = in_doubles;
        ++statistics.escalations[53];
        return get_certain(s);
      }
    }
    return internal::escalated_sign(
        unfolded.empty() ? history_bits : first_bits,
        [&] { return values(input, history, sides, unfolded); }, false,
        [&] { return History_zero_test(input, history, sides).for_faces(expression); },
        [&](const auto& faces) { return expression(std::span(faces.data(), faces.size())); },
        better, statistics);
  }

  /*!
  \brief tells whether an expression in the values of the diamond between two sides is zero, without computing it in
  intervals.

  Parameters are as for `sign()`.
  */
  template <class Expression>
  Zero_answer zero_answer(const Input_metric& input, const Flip_history& history, Side left,
                          Side right, const Expression& expression) {
    unfold(input, history, left, right);
    return decide(input, history, left, right, expression);
  }

  /*!
  \brief computes intervals that contain the values of faces, each from a side on.
  \param input the input
  \param history the moves since
  \param sides the first side of each face
  \param bits the precision; 53: doubles. Faces that cannot be unfolded get 512 at least, as errors grow with the
  number of moves
  */
  std::vector<Face_values<Interval_nt<false>>> enclosures(const Input_metric& input,
                                                          const Flip_history& history,
                                                          const std::vector<Side>& sides,
                                                          unsigned bits) {
    const std::vector<Unfolded_diamond> unfolded = unfold(input, history, sides);
    if (bits == 53 && !unfolded.empty())
      return face_values<Interval_nt<false>>(doubles_.of(input), unfolded);
    const Gmpfi_precision precision(unfolded.empty() ? std::max(bits, history_bits) : bits);
    return internal::intervals(values(input, history, sides, unfolded));
  }

  /*!
  \brief computes intervals that contain the values of the diamond between two sides, about as small
  as doubles allow.
  */
  Diamond_values<Interval_nt<false>> enclosure(const Input_metric& input,
                                               const Flip_history& history, Side left, Side right) {
    unfold(input, history, left, right);
    const bool unfolds = diamond_ && is_short(*diamond_);
    const Gmpfi_precision precision(2 * (unfolds ? first_bits : history_bits));
    return internal::intervals(unfolds ? values(input, *diamond_)
                                       : values(input, history, left, right));
  }

private:
  static constexpr unsigned first_bits = 128, history_bits = 512;
  // entries that are kept between calls, up to a kilobyte each
  static constexpr std::size_t maximal_memory = 50000;

  // intervals of one precision
  struct Intervals {
    Input_face_intervals<Gmpfi> faces;
    History_values<Gmpfi> moves; // faces made next have them as ancestors
  };

  // finds the input triangles over which a diamond lies, if it can be unfolded
  void unfold(const Input_metric& input, const Flip_history& history, Side left, Side right) {
    if (unfolding_.size() > maximal_memory) unfolding_ = {};
    diamond_.reset();
    // the sides of an edge inside one face are told apart by no `Diamond`
    if (left.face != right.face) diamond_ = unfolding_.diamond(history, left, right);
    if (diamond_ && !is_zero_.is_defined(input, *diamond_)) diamond_.reset();
  }

  // unfolds faces, if all of them can be and are short
  std::vector<Unfolded_diamond> unfold(const Input_metric& input, const Flip_history& history,
                                       const std::vector<Side>& sides) {
    if (unfolding_.size() > maximal_memory) unfolding_ = {};
    std::vector<Unfolded_diamond> result;
    for (const Side& s : sides) {
      std::optional<Unfolded_diamond> face = unfolding_.face(history, s);
      if (!face || !is_short(*face) || !is_zero_.is_defined(input, *face)) return {};
      result.push_back(*std::move(face));
    }
    return result;
  }

  // Whether inserted vertices that are defined by inserted vertices are few enough to be computed each time
  // they are met, and not once for all.
  static bool is_short(const Unfolded_diamond& d) {
    return d.combinations.size() <= std::max<std::size_t>(32, 2 * d.triangles.size());
  }

  template <class Expression>
  Zero_answer decide(const Input_metric& input, const Flip_history& history, Side left, Side right,
                     const Expression& expression) {
    if (!diamond_) return History_zero_test(input, history, left, right)(expression);
    if (is_tie_of_strip(input, *diamond_, expression)) return Zero_answer::zero;
    return is_zero_(input, *diamond_, expression);
  }

  // whether an expression is proven to be zero in integers of fixed size, which takes a microsecond
  template <class Expression>
  static bool is_tie_of_strip(const Input_metric& input, const Unfolded_diamond& diamond,
                              const Expression&) {
    if constexpr (std::is_same_v<Expression, Delaunay_expression>)
      return Integer_faces::is_in_space(input) && is_cocircular_strip(input, diamond);
    else
      return false;
  }

  Intervals& intervals() { return intervals_[Gmpfi::get_default_precision()]; }

  Diamond_values<Gmpfi> values(const Input_metric& input, const Unfolded_diamond& diamond) {
    return diamond.values<Gmpfi>(intervals().faces.of(input));
  }

  Diamond_values<Gmpfi> values(const Input_metric& input, const Flip_history& history, Side left,
                               Side right) {
    const auto faces = values(input, history, {left, right});
    return diamond_values(faces[0], faces[1]);
  }

  // each face is the one on the left of its diamond
  template <class FT, class Values>
  static std::vector<Face_values<FT>> face_values(const Values& input,
                                                  const std::vector<Unfolded_diamond>& faces) {
    std::vector<Face_values<FT>> result;
    for (const Unfolded_diamond& f : faces) {
      const Diamond_values<FT> v = f.values<FT>(input);
      result.push_back({{v.ij, v.jk, v.ki}, v.area_f});
    }
    return result;
  }

  // of faces that were unfolded, or not
  std::vector<Face_values<Gmpfi>> values(const Input_metric& input, const Flip_history& history,
                                         const std::vector<Side>& sides,
                                         const std::vector<Unfolded_diamond>& unfolded) {
    return unfolded.empty() ? values(input, history, sides)
                            : face_values<Gmpfi>(intervals().faces.of(input), unfolded);
  }

  std::vector<Face_values<Gmpfi>> values(const Input_metric& input, const Flip_history& history,
                                         const std::vector<Side>& sides) {
    auto& [faces, moves] = intervals();
    if (moves.size() > maximal_memory) moves = {};
    const auto face = faces.of(input);
    return History_evaluator<Gmpfi, decltype(face)>(history, face, moves).faces(sides);
  }

  Unfolding unfolding_;
  std::optional<Unfolded_diamond> diamond_; // that was unfolded last
  Diamond_zero_test is_zero_;
  Input_face_intervals<Interval_nt<false>> doubles_;
  std::map<Gmpfi::Precision_type, Intervals> intervals_;
};

template <class Expression>
Sign Exact_evaluation::sign(const Input_metric& input, const Unfolded_diamond& diamond,
                            const Expression& expression, Predicate_statistics& statistics) {
  const auto is_zero = [&] {
    return is_tie_of_strip(input, diamond, expression) ? Zero_answer::zero
                                                       : is_zero_(input, diamond, expression);
  };
  Diamond_values<Interval_nt<false>> better;
  return internal::escalated_sign(
      first_bits, [&] { return values(input, diamond); },
      internal::tests_zero_first(diamond.triangles.size()), is_zero, expression, better,
      statistics);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_EVALUATION_H
