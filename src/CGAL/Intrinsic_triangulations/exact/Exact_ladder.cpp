// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/Exact_ladder.h>
#include <CGAL/Intrinsic_triangulations/exact/Ladder_memory.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/Question.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/field.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/flat.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/input_integers.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/mirrored.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/prism.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>

#include <boost/config.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

// The order in which exact traits decide signs that the stored intervals of a metric leave open.

namespace CGAL::Intrinsic_triangulations {

template <class Figure, class Expression, class Values>
Sign Exact_ladder::sign(const Input_metric& input, const Figure& figure,
                        const Expression& expression, Values& better,
                        Predicate_statistics& statistics) {
  Memory& known = memory();
  const Question question{input, figure, expression};
  internal::Climb climb(question, statistics);
  const auto in_numbers = [&](unsigned bits) {
    return Memory::In_numbers<Values>{known, better, bits};
  };
  const bool is_decided =
      // Two faces of the input, in integers of fixed size. Most ties of real meshes are of this
      // kind.
      climb.ask(Input_integers_proof()) ||
      // Doubles: stored intervals carry the errors of all flips, a figure has those of its
      // triangles alone.
      climb.ask(in_numbers(53)) ||
      // A plane in space, in integers. On CAD surfaces nearly all flips are of this kind.
      climb.ask(Flat_proof()) ||
      // Cylinders and prisms, in integers: most other ties on CAD surfaces.
      climb.ask(Prism_proof()) ||
      // A tie by symmetry, which may have as many square roots as triangles.
      climb.ask(Mirrored_proof()) ||
      // Nearly all values that are not zero show their sign in 106 bits.
      climb.ask(in_numbers(106)) ||
      // All zeros over cylinders and prisms: positions there need no division, so that this takes
      // less time than 256 bits.
      climb.ask(Prism_in_field_proof()) ||
      // Values still open are almost always zero.
      climb.ask(in_numbers(256)) ||
      // All other zeros, exactly in the field of the square roots.
      climb.ask(Field_proof{known.image_steps_left(input)});
  // Values proven not to be zero show their sign at some precision.
  if (!is_decided) // one step beyond the most bits, where it gives up
    raise_precision(512, 2 * Mpfr_number::most_bits, [&](unsigned bits) {
      return climb.gives_up(bits) || climb.ask(in_numbers(bits));
    });
  return climb.sign();
}

Exact_ladder::Memory& Exact_ladder::memory() {
  if (memory_ == nullptr) memory_ = std::make_shared<Memory>();
  return *memory_;
}

std::vector<Face_values<Exact_ladder::FT>>
Exact_ladder::enclosures(const Input_metric& input, const Unfolded_faces& faces, unsigned bits) {
  return memory().with_numbers(
      bits, [&](auto& numbers) { return Memory::values(input, faces, numbers); },
      [](const auto& values) { return internal::intervals(values); });
}

Exact_ladder::FT Exact_ladder::squared_length(const Input_metric& input,
                                              const Unfolded_diamond& diamond, unsigned bits) {
  return memory().with_numbers(
      bits,
      [&](auto& numbers) {
        using Number = typename std::decay_t<decltype(numbers)>::Number;
        return diamond.squared_length<Number>(numbers.of(input));
      },
      [](const auto& length) { return internal::intervals(length); });
}

namespace internal {

namespace {

// Computes the values of faces of the input. It stores none, since each of many faces is used once.
template <class Number>
auto faces_without_memory(const Input_metric& input) {
  return [&input](std::uint32_t f) { return Input_face_intervals<Number>::face(input, f); };
}

// Hands out intervals of values in portions, for which rounding is changed together.
template <class Number>
class Interval_portions {
public:
  explicit Interval_portions(const Exact_ladder::Visit& visit) : visit_(visit) {}

  void add(const Face_values<Number>& values) {
    portion_.push_back(values);
    if (portion_.size() == most) hand_out();
  }
  void hand_out() {
    const Protect_FPU_rounding<true> upwards;
    for (const auto& values : portion_) visit_(visited_++, intervals(values));
    portion_.clear();
  }

private:
  static constexpr std::size_t most = 1024; // a megabyte in 256 bits

  const Exact_ladder::Visit& visit_;
  std::vector<Face_values<Number>> portion_;
  std::size_t visited_ = 0;
};

// A call: compilers move what they inline to where rounding has changed again.
BOOST_NOINLINE std::optional<double> nearest_weight_of(const Diamond_values<Short_ball>& diamond) {
  return nearest_double(weight_in_106_bits(diamond));
}

template <class Number>
void replay_in_intervals(const Input_metric& input, const Replayed_faces& faces,
                         const Exact_ladder::Visit& visit) {
  Interval_portions<Number> portions(visit);
  to_nearest([&] {
    faces.for_each_face<Number>(faces_without_memory<Number>(input),
                                [&](const Face_values<Number>& v) { portions.add(v); });
  });
  portions.hand_out();
}

} // namespace

} // namespace internal

void Exact_ladder::for_each_enclosure(const Input_metric& input, const Replayed_faces& faces,
                                      unsigned bits, const Visit& visit) {
  if (bits <= 106) return internal::replay_in_intervals<Short_ball>(input, faces, visit);
  const Mpfr_precision precision(bits);
  internal::replay_in_intervals<Long_ball>(input, faces, visit);
}

Replayed_values<Short_ball> Exact_ladder::values(const Input_metric& input, Replayed_faces faces) {
  return internal::to_nearest([&] {
    return std::move(faces).known_values<Short_ball>(
        internal::faces_without_memory<Short_ball>(input));
  });
}

std::optional<double> Exact_ladder::nearest_weight(const Diamond_values<Short_ball>& diamond) {
  return internal::to_nearest([&] { return internal::nearest_weight_of(diamond); });
}

template <class Figure>
std::optional<double> Exact_ladder::weight(const Input_metric& input, const Figure& diamond,
                                           Predicate_statistics& statistics, double error,
                                           unsigned most_bits, unsigned first_bits) {
  std::optional<double> result;
  raise_precision(first_bits, most_bits, [&](unsigned bits) {
    const auto find_nearest = [&](auto& numbers) {
      const auto weight = cotangent_weight(Memory::values(input, diamond, numbers));
      // in the end it is in the middle between two doubles, or beyond all of them
      result = bits < Mpfr_number::most_bits ? nearest_double(weight)
                                             : std::optional(weight.to_double());
      if (!result && weight.is_narrow(error)) result = weight.to_double();
    };
    ++statistics.sharpenings[bits];
    if (bits == 106) {
      internal::to_nearest(find_nearest, memory().short_balls);
    } else {
      const Mpfr_precision precision(bits);
      internal::to_nearest(find_nearest, memory().long_balls[bits]);
    }
    return result.has_value();
  });
  return result;
}

// the figures on which it climbs
template Sign Exact_ladder::sign(const Input_metric&, const Input_diamond&,
                                 const Recorded_diamond_expression&,
                                 Diamond_values<Interval_nt<false>>&, Predicate_statistics&);
template Sign Exact_ladder::sign(const Input_metric&, const Flat_diamond&,
                                 const Recorded_diamond_expression&,
                                 Diamond_values<Interval_nt<false>>&, Predicate_statistics&);
template Sign Exact_ladder::sign(const Input_metric&, const Unfolded_diamond&,
                                 const Recorded_diamond_expression&,
                                 Diamond_values<Interval_nt<false>>&, Predicate_statistics&);
template Sign Exact_ladder::sign(const Input_metric&, const Replayed_diamond&,
                                 const Recorded_diamond_expression&,
                                 Diamond_values<Interval_nt<false>>&, Predicate_statistics&);
template Sign Exact_ladder::sign(const Input_metric&, const Unfolded_faces&,
                                 const Recorded_face_expression&,
                                 std::vector<Face_values<Interval_nt<false>>>&,
                                 Predicate_statistics&);
template Sign Exact_ladder::sign(const Input_metric&, const Replayed_faces&,
                                 const Recorded_face_expression&,
                                 std::vector<Face_values<Interval_nt<false>>>&,
                                 Predicate_statistics&);
template std::optional<double> Exact_ladder::weight(const Input_metric&, const Unfolded_diamond&,
                                                    Predicate_statistics&, double, unsigned,
                                                    unsigned);
template std::optional<double> Exact_ladder::weight(const Input_metric&, const Replayed_diamond&,
                                                    Predicate_statistics&, double, unsigned,
                                                    unsigned);

} // namespace CGAL::Intrinsic_triangulations
