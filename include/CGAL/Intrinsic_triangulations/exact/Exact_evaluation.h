// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_EVALUATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_EVALUATION_H

#include <CGAL/Intrinsic_triangulations/exact/Diamond_zero_test.h>
#include <CGAL/Intrinsic_triangulations/exact/History_zero_test.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/Zero_test.h>
#include <CGAL/Intrinsic_triangulations/exact/escalation.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/History_evaluator.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>

#include <CGAL/Gmpfi.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief decides signs that floating point intervals leave open.

Ties over strips that are folded along parallel lines are found first. Then values are recomputed from the input
by unfolding, in doubles, which may be enough: stored ones carry the errors of all flips before. Most of the
others are zero, which a `Zero_test` tells. If not, values are recomputed in intervals of 128 bits, of 512 bits
along the history where vertices have been inserted, and the precision is doubled until the sign shows, which
must happen if the value is proven not to be zero. One that is only probably zero counts as zero at 1024 bits.
*/
class Exact_evaluation {
public:
  /// A slot of a version of a face.
  using Side = Flip_history::Side;

  /*!
  \brief returns the sign of an expression in the values of the diamond between two sides.
  \param input the input
  \param history the flips since
  \param left side on the left
  \param right side on the right, glued to `left`
  \param expression the expression
  \param better set to intervals that contain the values: about as small as doubles allow, or
  all reals if nothing was computed
  \param statistics counts how the sign was decided
  */
  template <class Expression>
  Sign sign(const Input_metric& input, const Flip_history& history, Side left, Side right,
            const Expression& expression, Diamond_values<Interval_nt<false>>& better,
            Predicate_statistics& statistics) {
    is_zero_.unfold(input, history, left, right);
    bool zero_first = true;
    if (is_unfolded()) {
      const Unfolded_diamond& diamond = *is_zero_.diamond();
      if (const std::optional<Sign> s =
              sign_in_doubles(input, diamond, expression, better, statistics))
        return *s;
      zero_first = internal::tests_zero_first(diamond.triangles.size(), expression(better));
    }
    return internal::escalated_sign(
        first_bits(), [&] { return values(input, history, left, right); }, zero_first,
        [&] { return is_zero_.decide(input, history, left, right, expression); }, expression,
        better, statistics);
  }

  /*!
  \brief returns the sign of an expression in the values of faces, each from a side on.

  Here values are computed in 512 bits first, and tested for zero if the sign does not show.
  \param input the input
  \param history the moves since
  \param sides the first side of each face
  \param expression the expression: `operator()(std::span<const Face_values<Number>>)`
  \param better set to intervals that contain the values, about as small as doubles allow
  \param statistics counts how the sign was decided
  */
  template <class Expression>
  Sign sign(const Input_metric& input, const Flip_history& history, const std::vector<Side>& sides,
            const Expression& expression, std::vector<Face_values<Interval_nt<false>>>& better,
            Predicate_statistics& statistics) {
    Zero_answer answer = Zero_answer::not_zero;
    for (unsigned bits = history_bits; !internal::gives_up(answer, bits); bits *= 2) {
      const Gmpfi_precision precision(bits);
      const std::vector<Face_values<Gmpfi>> faces = values(input, history, sides);
      better = intervals(faces);
      const Uncertain<Sign> s = expression(std::span<const Face_values<Gmpfi>>(faces)).sign();
      if (is_certain(s)) {
        ++statistics.escalations[bits];
        return get_certain(s);
      }
      if (bits > history_bits) continue;
      answer = History_zero_test(input, history, sides).for_faces(expression);
      if (answer == Zero_answer::zero) {
        ++statistics.certified_zero;
        return ZERO;
      }
    }
    ++statistics.probable_zero;
    return ZERO;
  }

  /*!
  \brief computes intervals that contain the values of faces, each from a side on.
  \param input the input
  \param history the moves since
  \param sides the first side of each face
  \param bits the precision: errors grow with the number of moves
  */
  std::vector<Face_values<Interval_nt<false>>> enclosures(const Input_metric& input,
                                                          const Flip_history& history,
                                                          const std::vector<Side>& sides,
                                                          unsigned bits) {
    const Gmpfi_precision precision(bits);
    return intervals(values(input, history, sides));
  }

  /*!
  \brief computes intervals that contain the values of the diamond between two sides, about as small
  as doubles allow.
  */
  Diamond_values<Interval_nt<false>> enclosure(const Input_metric& input,
                                               const Flip_history& history, Side left, Side right) {
    is_zero_.unfold(input, history, left, right);
    const Gmpfi_precision precision(2 * first_bits());
    return internal::intervals(values(input, history, left, right));
  }

private:
  // Without inserted vertices values are computed anew, by unfolding; with them by the moves, whose values
  // are remembered, so that every move is evaluated once, as a rule. Errors grow with the moves.
  static constexpr unsigned history_bits = 512;
  bool is_unfolded() const {
    return is_zero_.diamond() && is_zero_.diamond()->combinations.empty();
  }
  unsigned first_bits() const { return is_unfolded() ? 128 : history_bits; }

  // Unfolded anew, values carry no error of the flips before: doubles may do.
  template <class Expression>
  std::optional<Sign> sign_in_doubles(const Input_metric& input, const Unfolded_diamond& diamond,
                                      const Expression& expression,
                                      Diamond_values<Interval_nt<false>>& better,
                                      Predicate_statistics& statistics) {
    if (Diamond_zero_test::is_tie_of_strip(input, diamond, expression)) {
      better = internal::unknown_values();
      ++statistics.certified_zero;
      return ZERO;
    }
    if (intervals_.size() > maximal_memory) intervals_.clear();
    better = diamond.values<Interval_nt<false>>(
        [&](std::uint32_t f) -> const Interval_face& { return interval_face(input, f); });
    const Uncertain<Sign> s = CGAL::sign(expression(better));
    if (!is_certain(s)) return std::nullopt;
    ++statistics.escalations[53];
    return get_certain(s);
  }

  using Interval_face = std::pair<std::array<Interval_nt<false>, 3>, Interval_nt<false>>;

  // squared lengths and quadruple area of an input face; the reference stays valid
  const Interval_face& interval_face(const Input_metric& input, std::uint32_t f) {
    using FT = Interval_nt<false>;
    const auto found = intervals_.find(f);
    if (found != intervals_.end()) return found->second;
    return intervals_
        .emplace(f, Interval_face({input.squared_length<FT>(f, 0), input.squared_length<FT>(f, 1),
                                   input.squared_length<FT>(f, 2)},
                                  quadruple_area<FT>(input, f)))
        .first->second;
  }

  // entries that are kept between calls, about a kilobyte each
  static constexpr std::size_t maximal_memory = 100000;

  Diamond_values<Gmpfi> values(const Input_metric& input, const Flip_history& history, Side left,
                               Side right) {
    if (is_unfolded()) return is_zero_.diamond()->values<Gmpfi>(faces_.of(input));
    const auto faces = values(input, history, {left, right});
    return diamond_values(faces[0], faces[1]);
  }

  std::vector<Face_values<Gmpfi>> values(const Input_metric& input, const Flip_history& history,
                                         const std::vector<Side>& sides) {
    const auto face = faces_.of(input);
    History_values<Gmpfi>& memory = memory_[Gmpfi::get_default_precision()];
    if (memory.size() > maximal_memory) memory = {};
    return History_evaluator<Gmpfi, decltype(face)>(history, face, memory).faces(sides);
  }

  static std::vector<Face_values<Interval_nt<false>>>
  intervals(const std::vector<Face_values<Gmpfi>>& faces) {
    std::vector<Face_values<Interval_nt<false>>> result;
    for (const Face_values<Gmpfi>& f : faces)
      result.push_back(
          {{internal::interval(f.squared_lengths[0]), internal::interval(f.squared_lengths[1]),
            internal::interval(f.squared_lengths[2])},
           internal::interval(f.quadruple_area)});
    return result;
  }

  Zero_test is_zero_;
  internal::Gmpfi_faces faces_;
  std::unordered_map<std::uint32_t, Interval_face> intervals_;
  // values of each precision so far: faces made next have them as ancestors
  std::map<Gmpfi::Precision_type, History_values<Gmpfi>> memory_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_EVALUATION_H
