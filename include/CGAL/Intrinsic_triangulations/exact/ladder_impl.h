// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_LADDER_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_LADDER_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/exact/Diamond_zero_test.h>
#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.h>
#include <CGAL/Intrinsic_triangulations/exact/Zero_answer.h>
#include <CGAL/Intrinsic_triangulations/exact/escalation.h>
#include <CGAL/Intrinsic_triangulations/exact/flat_diamond_sign.h>
#include <CGAL/Intrinsic_triangulations/exact/input_diamond_sign.h>
#include <CGAL/Intrinsic_triangulations/exact/is_mirrored_strip.h>
#include <CGAL/Intrinsic_triangulations/exact/ladder.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/nearest_double.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/without_corner.h>

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

// what is remembered of the input, in each precision
struct Exact_ladder::Memory {
  // up to which a test for zero takes less time than 256 bits
  static constexpr std::size_t few_triangles = 12;
  // up to which it is done before 512 bits: over longer strips ties are rare, and the areas of the triangles have many
  // independent square roots
  static constexpr std::size_t many_triangles = 256;

  // in numbers of so many bits
  template <class Result, class Compute>
  Result at_precision(unsigned bits, const Compute& compute) {
    if (bits <= 53) return internal::intervals(compute(doubles));
    if (bits <= 106) return internal::intervals(internal::to_nearest(compute, short_balls));
    const Mpfr_precision precision(bits);
    return internal::intervals(internal::to_nearest(compute, long_balls[bits]));
  }

  template <class FT, class Figure>
  static auto values(const Input_metric& input, const Figure& figure,
                     Input_face_intervals<FT>& faces) {
    return figure.template values<FT>(faces.of(input));
  }

  Diamond_zero_test is_zero;
  Input_face_intervals<Interval_nt<false>> doubles;
  Input_face_intervals<Ball<Double_double>> short_balls;
  std::map<unsigned, Input_face_intervals<Ball<Mpfr_number>>> long_balls; // by precision
};

namespace internal {

// A part of a figure over which an expression is zero if and only if it is over the figure, if there is one. Convexity at
// one end does not depend on where the other one is.
template <class Figure, class Expression>
const Figure& decisive_part(const Figure& figure, const Expression&, std::optional<Figure>&) {
  return figure;
}
inline const Unfolded_diamond& decisive_part(const Unfolded_diamond& diamond,
                                             const Recorded_diamond_expression& expression,
                                             std::optional<Unfolded_diamond>& part) {
  const Zero_meaning zero = expression.zero_meaning();
  if (zero == Zero_meaning::collinear_at_source) part = without_corner(diamond, 1);
  if (zero == Zero_meaning::collinear_at_target) part = without_corner(diamond, 0);
  return part ? *part : diamond;
}

template <class Figure, class Expression>
bool is_mirrored_tie(const Input_metric& input, const Figure& figure,
                     const Expression& expression) {
  if constexpr (std::is_same_v<Figure, Unfolded_diamond>)
    return expression.zero_meaning() == Zero_meaning::cocircular &&
           is_mirrored_strip(input, figure);
  else
    return false;
}

// The ladder; see `Exact_ladder`.
template <class Memory, class Figure, class Expression, class Values>
Sign decide(Memory& memory, const Input_metric& input, const Figure& figure,
            const Expression& expression, Values& better, Predicate_statistics& statistics) {
  if constexpr (std::is_same_v<Figure, Input_diamond>)
    if (const auto s = input_diamond_sign(input, figure, expression)) {
      ++(*s == ZERO ? statistics.certified_zero : statistics.integer);
      return *s;
    }
  better = memory.values(input, figure, memory.doubles);
  if (const auto s = counted(CGAL::sign(expression(better)), 53, statistics)) return *s;
  std::optional<Figure> other;
  const Figure& part = figure.size() > Memory::few_triangles
                           ? decisive_part(figure, expression, other)
                           : figure;
  if (is_mirrored_tie(input, part, expression)) return counted_zero(statistics);
  const auto in_balls = [&](auto& faces, unsigned bits) {
    return sign_in_balls(
        bits, [&] { return memory.values(input, figure, faces); }, expression, better, statistics);
  };
  const auto [sign, seems_zero] = in_balls(memory.short_balls, 106);
  if (sign) return *sign;
  std::optional<Zero_answer> answer;
  if (seems_zero && part.size() <= Memory::few_triangles)
    answer = memory.is_zero(input, part, expression);
  for (unsigned bits = 256;; bits *= 2) {
    if (bits == (part.size() <= Memory::many_triangles ? 512U : 1024U) && !answer)
      answer = memory.is_zero(input, part, expression);
    if (answer == Zero_answer::zero) return counted_zero(statistics);
    if (answer && gives_up(*answer, bits)) {
      ++statistics.probable_zero;
      return ZERO;
    }
    const Mpfr_precision precision(bits);
    if (const auto s = in_balls(memory.long_balls[bits], bits).first) return *s;
  }
}

} // namespace internal

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Exact_ladder::Memory& Exact_ladder::memory() {
  if (memory_ == nullptr) memory_ = std::make_shared<Memory>();
  return *memory_;
}

template <class Figure, class Expression, class Values>
Sign Exact_ladder::sign(const Input_metric& input, const Figure& figure,
                        const Expression& expression, Values& better,
                        Predicate_statistics& statistics) {
  if constexpr (std::is_same_v<Figure, Flat_diamond>)
    return flat_diamond_sign(input, figure, expression, better, statistics);
  else
    return internal::decide(memory(), input, figure, expression, better, statistics);
}

template <class Faces>
std::vector<Face_values<Exact_ladder::FT>>
Exact_ladder::enclosures(const Input_metric& input, const Faces& faces, unsigned bits) {
  return memory().at_precision<std::vector<Face_values<FT>>>(
      bits, [&](auto& numbers) { return Memory::values(input, faces, numbers); });
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Exact_ladder::FT
Exact_ladder::squared_length(const Input_metric& input, const Unfolded_diamond& diamond,
                             unsigned bits) {
  return memory().at_precision<FT>(bits, [&](auto& numbers) {
    using Number = typename std::decay_t<decltype(numbers)>::Number;
    return diamond.squared_length<Number>(numbers.of(input));
  });
}

template <class Figure>
std::optional<double> Exact_ladder::weight(const Input_metric& input, const Figure& diamond,
                                           unsigned bits) {
  const auto nearest = [&](auto& numbers) -> std::optional<double> {
    const auto weight = cotangent_weight(Memory::values(input, diamond, numbers));
    // in the end it is in the middle between two doubles, or beyond all of them
    return bits < last_bits ? nearest_double(weight) : std::optional(weight.to_double());
  };
  if (bits <= 106) return internal::to_nearest(nearest, memory().short_balls);
  const Mpfr_precision precision(bits);
  return internal::to_nearest(nearest, memory().long_balls[bits]);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_LADDER_IMPL_H
