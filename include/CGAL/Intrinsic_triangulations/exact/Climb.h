// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_CLIMB_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_CLIMB_H

#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/thresholds.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/Question.h>

#include <CGAL/enum.h>

#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// Puts one question to proofs, until one of them tells the sign, and counts which one that was.
template <class Asked>
class Climb {
public:
  // all outlive this object
  Climb(const Asked& question, Predicate_statistics& statistics)
      : question_(question), statistics_(statistics) {}

  // Asks a proof. Whether the sign is known now; it is not if the proof does not understand the
  // question.
  template <class Proof>
  bool ask(Proof&& proof) {
    using P = std::remove_reference_t<Proof>;
    if constexpr (ProofOf<P, Asked>) {
      const Answer a = proof(question_);
      if (a != Answer::open) answer_ = a;
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

  // Whether a value that no proof has got through is taken for zero instead of computing it in so
  // many bits.
  bool gives_up(unsigned bits) {
    if (answer_ == Answer::open && bits > thresholds::probable_bits) {
      ++statistics_.probable_zero;
      answer_ = Answer::zero;
      return true;
    }
    if (bits <= Mpfr_number::most_bits) return false;
    throw std::logic_error("a value that was proven not to be zero shows no sign in " +
                           std::to_string(Mpfr_number::most_bits) +
                           " bits; please report this with the mesh");
  }

  Sign sign() const {
    return answer_ == Answer::zero ? ZERO : answer_ == Answer::positive ? POSITIVE : NEGATIVE;
  }

private:
  bool is_sign_known() const {
    return answer_ == Answer::zero || answer_ == Answer::positive || answer_ == Answer::negative;
  }

  const Asked& question_;
  Predicate_statistics& statistics_;
  Answer answer_ = Answer::open;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_CLIMB_H
