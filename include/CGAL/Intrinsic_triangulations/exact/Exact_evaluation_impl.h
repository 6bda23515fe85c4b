// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_EVALUATION_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_EVALUATION_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/exact/Diamond_zero_test.h>
#include <CGAL/Intrinsic_triangulations/exact/Exact_evaluation.h>
#include <CGAL/Intrinsic_triangulations/exact/History_zero_test.h>
#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.h>
#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals_impl.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/escalation.h>
#include <CGAL/Intrinsic_triangulations/exact/is_mirrored_strip.h>
#include <CGAL/Intrinsic_triangulations/exact/is_tie_of_strip.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Integer_faces.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/nearest_double.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/History_evaluator.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Repeated_flips.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/without_corner.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Gmpfi.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

// what an evaluation keeps between calls, and what it does with it
struct Exact_evaluation::Memory {
  // up to which a test for zero takes less time than 256 bits
  static constexpr std::size_t few_triangles = 12;
  // up to which it is done before 512 bits: over longer strips ties are rare, and the areas of the triangles have many
  // independent square roots
  static constexpr std::size_t many_triangles = 256;
  // entries that are kept between calls, up to a kilobyte each
  static constexpr std::size_t maximal_memory = 50000;

  // intervals of one precision
  struct Intervals {
    Input_face_intervals<Gmpfi> faces;
    History_values<Gmpfi> moves; // faces made next have them as ancestors
  };

  // whether an expression is proven to be zero in integers of fixed size, which takes a microsecond
  static bool is_tie_of_strip(const Input_metric& input, const Unfolded_diamond& diamond,
                              Zero_meaning zero) {
    if (zero == Zero_meaning::other || !diamond.is_in_space(input)) return false;
    if (zero == Zero_meaning::cocircular) return is_cocircular_strip(input, diamond);
    return is_collinear_strip(input, diamond, 2, zero == Zero_meaning::collinear_at_source ? 0 : 1,
                              3);
  }

  // whether an expression is proven to be zero by symmetry
  static bool is_mirrored_tie(const Input_metric& input, const Unfolded_diamond& diamond,
                              Zero_meaning zero) {
    return zero == Zero_meaning::cocircular && is_mirrored_strip(input, diamond);
  }

  // A part of a diamond over which an expression is zero if and only if it is over the diamond, if there is one. Convexity at
  // one end does not depend on where the other one is.
  static std::optional<Unfolded_diamond> decisive_part(const Unfolded_diamond& diamond,
                                                       Zero_meaning zero) {
    if (diamond.triangles.size() <= few_triangles) return std::nullopt;
    if (zero == Zero_meaning::collinear_at_source) return without_corner(diamond, 1);
    if (zero == Zero_meaning::collinear_at_target) return without_corner(diamond, 0);
    return std::nullopt;
  }

  // computes with a memory of input faces in a type of so many bits
  template <class Result, class Compute>
  Result at_precision(unsigned bits, const Compute& compute) {
    if (bits <= 53) return internal::intervals(compute(doubles));
    if (bits <= 106) return internal::intervals(internal::to_nearest(compute, short_balls));
    if (bits <= 256) return internal::intervals(internal::to_nearest(compute, long_balls));
    const Gmpfi_precision precision(bits);
    return internal::intervals(compute(intervals().faces));
  }

  Intervals& intervals() { return by_precision[Gmpfi::get_default_precision()]; }

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

  std::vector<Face_values<Gmpfi>> values(const Input_metric& input, const Flip_history& history,
                                         const std::vector<Side>& sides) {
    auto& [faces, moves] = intervals();
    if (moves.size() > maximal_memory) moves.clear();
    const auto face = faces.of(input);
    return History_evaluator<Gmpfi, decltype(face)>(history, face, moves).faces(sides);
  }

  // of a diamond that is unfolded
  std::optional<double> weight(const Input_metric& input, const Unfolded_diamond& diamond,
                               unsigned bits) {
    const auto compute = [&](auto& numbers) {
      using FT = typename std::decay_t<decltype(numbers)>::Number;
      return nearest_double(cotangent_weight(diamond.values<FT>(numbers.of(input))));
    };
    if (bits <= 106) return internal::to_nearest(compute, short_balls);
    if (bits <= 256) return internal::to_nearest(compute, long_balls);
    const Gmpfi_precision precision(bits);
    return told_weight(cotangent_weight(values(input, diamond)), bits);
  }

  // in the end that nearest to a lower bound: the number is in the middle between two doubles, or beyond all of them
  static std::optional<double> told_weight(const Gmpfi& weight, unsigned bits) {
    if (bits < last_bits) return nearest_double(weight);
    return weight.inf().to_double(std::round_to_nearest);
  }

  Diamond_zero_test is_zero;
  Input_face_intervals<Interval_nt<false>> doubles;
  Input_face_intervals<Ball<Double_double>> short_balls;
  Repeated_flips<Ball<Double_double>> short_flips;
  Repeated_flips<Ball<Mpfr_number>> long_flips;
  Input_face_intervals<Ball<Mpfr_number>> long_balls; // of 256 bits
  std::map<Gmpfi::Precision_type, Intervals> by_precision;

  // of an expression in the values of a diamond, which doubles have left open
  Sign sign_beyond_doubles(const Input_metric& input, const Unfolded_diamond& diamond,
                           const Recorded_diamond_expression& expression,
                           Diamond_values<Interval_nt<false>>& better,
                           Predicate_statistics& statistics) {
    const Zero_meaning zero = expression.zero_meaning();
    const std::optional<Unfolded_diamond> decisive = decisive_part(diamond, zero);
    const Unfolded_diamond& part = decisive ? *decisive : diamond;
    const std::size_t size = part.triangles.size();
    if (is_tie_of_strip(input, part, zero) || is_mirrored_tie(input, part, zero)) {
      ++statistics.certified_zero;
      return ZERO;
    }
    const auto in_balls = [&](auto& faces, unsigned bits) {
      using FT = typename std::decay_t<decltype(faces)>::Number;
      return internal::sign_in_balls(
          bits, [&] { return diamond.values<FT>(faces.of(input)); }, expression, better,
          statistics);
    };
    const auto [sign, seems_zero] = in_balls(short_balls, 106);
    if (sign) return *sign;
    const auto zero_answer = [&] { return is_zero(input, part, expression); };
    std::optional<Zero_answer> answer;
    if (seems_zero && size <= few_triangles) answer = zero_answer();
    if (answer == Zero_answer::zero) {
      ++statistics.certified_zero;
      return ZERO;
    }
    if (const auto s = in_balls(long_balls, 256).first) return *s;
    return internal::escalated_sign([&] { return values(input, diamond); }, size <= many_triangles,
                                    [&] { return answer ? *answer : zero_answer(); }, expression,
                                    better, statistics);
  }
};

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Exact_evaluation::Memory& Exact_evaluation::memory() {
  if (memory_ == nullptr) memory_ = std::make_shared<Memory>();
  return *memory_;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Sign Exact_evaluation::sign(
    const Input_metric& input, const Unfolded_diamond& diamond,
    const Recorded_diamond_expression& expression, Predicate_statistics& statistics) {
  Diamond_values<Interval_nt<false>> better;
  return memory().sign_beyond_doubles(input, diamond, expression, better, statistics);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Sign Exact_evaluation::sign(
    const Input_metric& input, const Unfolded_diamond& diamond,
    const Recorded_diamond_expression& expression, Diamond_values<Interval_nt<false>>& better,
    Predicate_statistics& statistics) {
  better = diamond.values<Interval_nt<false>>(memory().doubles.of(input));
  if (const auto s = internal::counted(CGAL::sign(expression(better)), 53, statistics)) return *s;
  return memory().sign_beyond_doubles(input, diamond, expression, better, statistics);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Sign Exact_evaluation::sign(
    const Input_metric& input, const std::vector<Unfolded_diamond>& faces,
    const Recorded_face_expression& expression,
    std::vector<Face_values<Interval_nt<false>>>& better, Predicate_statistics& statistics) {
  better = Memory::face_values<Interval_nt<false>>(memory().doubles.of(input), faces);
  if (const auto s = internal::counted(CGAL::sign(expression(better)), 53, statistics)) return *s;
  const auto in_balls = [&](auto& numbers, unsigned bits) {
    using FT = typename std::decay_t<decltype(numbers)>::Number;
    return internal::sign_in_balls(
        bits, [&] { return Memory::face_values<FT>(numbers.of(input), faces); }, expression, better,
        statistics);
  };
  if (const auto s = in_balls(memory().short_balls, 106).first) return *s;
  if (const auto s = in_balls(memory().long_balls, 256).first) return *s;
  return internal::escalated_sign(
      [&] { return Memory::face_values<Gmpfi>(memory().intervals().faces.of(input), faces); },
      false, [&] { return memory().is_zero.of_faces(input, faces, expression); }, expression,
      better, statistics);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::vector<Face_values<Interval_nt<false>>>
Exact_evaluation::enclosures(const Input_metric& input, const std::vector<Unfolded_diamond>& faces,
                             unsigned bits) {
  using Result = std::vector<Face_values<Interval_nt<false>>>;
  return memory().at_precision<Result>(bits, [&](auto& numbers) {
    using FT = typename std::decay_t<decltype(numbers)>::Number;
    return Memory::face_values<FT>(numbers.of(input), faces);
  });
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Interval_nt<false>
Exact_evaluation::squared_length(const Input_metric& input, const Unfolded_diamond& diamond,
                                 unsigned bits) {
  return memory().at_precision<Interval_nt<false>>(bits, [&](auto& numbers) {
    using FT = typename std::decay_t<decltype(numbers)>::Number;
    return diamond.squared_length<FT>(numbers.of(input));
  });
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::optional<double>
Exact_evaluation::weight(const Input_metric& input, const Unfolded_diamond& diamond,
                         unsigned bits) {
  return memory().weight(input, diamond, bits);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::optional<double>
Exact_evaluation::weight(const Input_metric& input, const Flip_history& history, Side left,
                         Side right, unsigned bits) {
  const Gmpfi_precision precision(std::max(bits, internal::first_bits));
  return Memory::told_weight(cotangent_weight(memory().values(input, history, left, right)), bits);
}

// Unfolding, all flips have to be followed first: in integers, each in a fifth of the time that it takes in balls of 256 bits.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::optional<double>
Exact_evaluation::weight_by_flips(const Input_metric& input, const Flip_history& history, Side left,
                                  Side right) {
  const auto compute = [&](auto& repeated, std::size_t most) -> std::optional<double> {
    const auto values = repeated.diamond(input, history, left, right, most);
    if (!values) return std::nullopt;
    return nearest_double(cotangent_weight(*values));
  };
  const std::size_t flips = history.number_of_flips();
  return internal::to_nearest([&] {
    const auto weight = compute(memory().short_flips, 2 * flips);
    return weight ? weight : compute(memory().long_flips, flips / 16);
  });
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::optional<Sign>
Exact_evaluation::sign_by_flips(const Input_metric& input, const Flip_history& history, Side left,
                                Side right, const Recorded_diamond_expression& expression,
                                Diamond_values<Interval_nt<false>>& better) {
  auto& repeated = memory().short_flips;
  repeated.count(); // ties are not told so: there must not be too many
  std::optional<Diamond_values<Ball<Double_double>>> values;
  const Uncertain<Sign> s = internal::to_nearest([&]() -> Uncertain<Sign> {
    values = repeated.diamond(input, history, left, right, history.number_of_flips() / 8);
    return values ? expression(*values).sign() : Uncertain<Sign>::indeterminate();
  });
  if (!is_certain(s) || get_certain(s) == ZERO) return std::nullopt;
  better = internal::intervals(*values);
  return get_certain(s);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Sign Exact_evaluation::sign(
    const Input_metric& input, const Flip_history& history, Side left, Side right,
    const Recorded_diamond_expression& expression, Diamond_values<Interval_nt<false>>& better,
    Predicate_statistics& statistics) {
  return internal::escalated_sign(
      [&] { return memory().values(input, history, left, right); }, true,
      [&] { return History_zero_test(input, history, left, right)(expression); }, expression,
      better, statistics);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Sign Exact_evaluation::sign(
    const Input_metric& input, const Flip_history& history, const std::vector<Side>& sides,
    const Recorded_face_expression& expression,
    std::vector<Face_values<Interval_nt<false>>>& better, Predicate_statistics& statistics) {
  return internal::escalated_sign(
      [&] { return memory().values(input, history, sides); }, false,
      [&] { return History_zero_test(input, history, sides).for_faces(expression); }, expression,
      better, statistics);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::vector<Face_values<Interval_nt<false>>>
Exact_evaluation::enclosures(const Input_metric& input, const Flip_history& history,
                             const std::vector<Side>& sides, unsigned bits) {
  const Gmpfi_precision precision(std::max(bits, internal::first_bits));
  return internal::intervals(memory().values(input, history, sides));
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Exact_evaluation::forget_flip(std::uint32_t flip) {
  if (memory_ == nullptr) return;
  memory_->short_flips.forget(flip);
  memory_->long_flips.forget(flip);
  for (auto& [bits, intervals] : memory_->by_precision) intervals.moves.erase(flip);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_EVALUATION_IMPL_H
