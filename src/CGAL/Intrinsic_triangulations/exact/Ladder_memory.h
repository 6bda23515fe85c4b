// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_LADDER_MEMORY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_LADDER_MEMORY_H

#include <CGAL/Intrinsic_triangulations/exact/Exact_ladder.h>
#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Proof_watch.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/thresholds.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/Question.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/flat.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <chrono>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

inline Interval_nt<false> intervals(const Interval_nt<false>& x) { return x; }
template <class Center>
Interval_nt<false> intervals(const Ball<Center>& x) {
  return x.interval();
}
template <class FT>
Diamond_values<Interval_nt<false>> intervals(const Diamond_values<FT>& d) {
  return {intervals(d.ij), intervals(d.jk),     intervals(d.ki),    intervals(d.im),
          intervals(d.mj), intervals(d.area_f), intervals(d.area_g)};
}
template <class FT>
Face_values<Interval_nt<false>> intervals(const Face_values<FT>& f) {
  const auto& [l, a] = f;
  return {{intervals(l[0]), intervals(l[1]), intervals(l[2])}, intervals(a)};
}
template <class FT>
std::vector<Face_values<Interval_nt<false>>> intervals(const std::vector<Face_values<FT>>& faces) {
  std::vector<Face_values<Interval_nt<false>>> result;
  for (const Face_values<FT>& f : faces) result.push_back(intervals(f));
  return result;
}

inline Uncertain<Sign> sign_of(const Interval_nt<false>& x) { return CGAL::sign(x); }
template <class Center>
Uncertain<Sign> sign_of(const Ball<Center>& x) {
  return x.sign();
}

} // namespace internal

// The stored faces of the input, in each precision.
struct Exact_ladder::Memory {
  // Computes with input faces in numbers of so many bits, with the rounding that these require;
  // converts the result with rounding upwards.
  template <class Compute, class Convert>
  auto with_numbers(unsigned bits, const Compute& compute, const Convert& convert) {
    if (bits <= 53) return convert(compute(doubles));
    if (bits <= 106) return convert(internal::to_nearest(compute, short_balls));
    const Mpfr_precision precision(bits);
    return convert(internal::to_nearest(compute, long_balls[bits]));
  }

  template <class FT, class Figure>
  static auto values(const Input_metric& input, const Figure& figure,
                     Input_face_intervals<FT>& faces) {
    return figure.template values<FT>(faces.of(input));
  }

  // What long proofs in the field may still cost.
  double* image_steps_left(const Input_metric& input) {
    if (!steps_left)
      steps_left = thresholds::all_image_steps +
                   thresholds::image_steps_of_face * static_cast<double>(input.number_of_faces());
    return &*steps_left;
  }

  std::optional<double> steps_left;
  Input_face_intervals<Interval_nt<false>> doubles;
  Input_face_intervals<Short_ball> short_balls;
  std::map<unsigned, Input_face_intervals<Long_ball>> long_balls; // by precision

  // Decides a sign in numbers of so many bits; see `Exact_ladder::sign()`.
  template <class Values>
  struct In_numbers {
    template <class Asked>
    Answer operator()(const Asked& q) {
      if constexpr (std::is_same_v<typename Asked::Figure, Flat_diamond>) {
        if (bits > 53) return Answer::open;
        better = values_in_space(q.input, q.figure);
        return answer(q.expression(better));
      } else {
        return memory.with_numbers(
            bits,
            [&](auto& faces) {
              const auto v = Memory::values(q.input, q.figure, faces);
              return std::pair(v, q.expression(v));
            },
            [&](const auto& result) {
              better = internal::intervals(result.first);
              return answer(result.second);
            });
      }
    }

    template <class FT>
    static Answer answer(const FT& value) {
      const Uncertain<Sign> s = internal::sign_of(value);
      return is_certain(s) ? to_answer(get_certain(s)) : Answer::open;
    }

    Memory& memory;
    Values& better; // set to intervals that contain the values
    unsigned bits;
  };
};

namespace internal {

// Applies proofs to one question until one of them finds the sign, and counts that proof.
template <class Asked>
class Climb {
public:
  // all outlive this object
  Climb(const Asked& question, Predicate_statistics& statistics)
      : question_(question), statistics_(statistics) {}

  // Applies a proof. Returns whether the sign is known now; false if the proof does not accept the
  // question.
  template <class Proof>
  bool ask(Proof&& proof) {
    using P = std::remove_reference_t<Proof>;
    if constexpr (ProofOf<P, Asked>) {
      const Rung rung = rung_of(proof);
      Rung_statistics& counts = statistics_.rungs[static_cast<std::size_t>(rung)];
      const bool is_timed = rung != Rung::integers;
      if (is_timed && last_ == Clock::time_point()) last_ = Clock::now();
      const Answer a = proof(question_);
      if (a != Answer::open) answer_ = a;
      ++counts.asked;
      counts.decided += is_sign_known();
      counts.zeros += a == Answer::zero;
      if (is_timed) {
        const Clock::time_point before = std::exchange(last_, Clock::now());
        counts.seconds += std::chrono::duration<double>(last_ - before).count();
      }
      if (a == Answer::zero)
        ++statistics_.certified_zero;
      else if (is_sign_known()) {
        if constexpr (requires { proof.bits; })
          ++statistics_.escalations[proof.bits];
        else
          ++statistics_.integer;
      }
    }
    return is_sign_known();
  }

  // Whether to assume that a value without proof is zero, instead of computing it in the given
  // bits.
  bool gives_up(unsigned bits) {
    if (answer_ == Answer::open && (bits > thresholds::probable_bits || !Proof_watch::goes_on())) {
      ++statistics_.probable_zero;
      answer_ = Answer::zero;
      return true;
    }
    if (bits <= Mpfr_number::most_bits) return false;
    throw Invalid_input(Element_kind::none, 0,
                        "a value that is not zero shows no sign in " +
                            std::to_string(Mpfr_number::most_bits) +
                            " bits, as sizes on the surface differ by hundreds of powers of ten; "
                            "set the smallest ones to zero, such as coordinates near 1e-300");
  }

  Sign sign() const {
    return answer_ == Answer::zero ? ZERO : answer_ == Answer::positive ? POSITIVE : NEGATIVE;
  }

private:
  using Clock = std::chrono::steady_clock;

  template <class Proof>
  static Rung rung_of(const Proof& proof) {
    if constexpr (requires { Proof::rung; })
      return Proof::rung;
    else
      return proof.bits <= 53    ? Rung::doubles
             : proof.bits <= 106 ? Rung::bits_106
             : proof.bits <= 256 ? Rung::bits_256
                                 : Rung::more_bits;
  }
  bool is_sign_known() const {
    return answer_ == Answer::zero || answer_ == Answer::positive || answer_ == Answer::negative;
  }

  const Asked& question_;
  Predicate_statistics& statistics_;
  Answer answer_ = Answer::open;
  Clock::time_point last_; // when the last rung ended
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_LADDER_MEMORY_H
