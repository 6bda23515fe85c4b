// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_PROOF_WATCH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_PROOF_WATCH_H

#include <CGAL/Interval_nt.h>

#include <chrono>
#include <functional>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief lets long proofs of a thread ask whether to go on, for a lifetime. Once the answer is no,
they end undecided.
*/
class Proof_watch {
public:
  /// \param go_on the question, asked with rounding to the nearest, ten times a second at most
  explicit Proof_watch(std::function<bool()> go_on)
      : go_on_(std::move(go_on)), before_(std::exchange(current(), this)) {}
  /// lets them ask as before.
  ~Proof_watch() { current() = before_; }
  Proof_watch(const Proof_watch&) = delete;
  Proof_watch& operator=(const Proof_watch&) = delete;

  /// tells whether the answer was no.
  bool is_stopped() const { return is_stopped_; }

  /// returns whether proofs of this thread may go on.
  static bool goes_on() { return current() == nullptr || current()->ask(); }

private:
  using Clock = std::chrono::steady_clock;

  static Proof_watch*& current() {
    thread_local Proof_watch* watch = nullptr;
    return watch;
  }
  bool ask() {
    const Clock::time_point now = Clock::now();
    if (is_stopped_ || now - last_ < std::chrono::milliseconds(100)) return !is_stopped_;
    last_ = now;
    const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
    is_stopped_ = !go_on_();
    return !is_stopped_;
  }

  std::function<bool()> go_on_;
  Proof_watch* before_;
  Clock::time_point last_ = Clock::now();
  bool is_stopped_ = false;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_PROOF_WATCH_H
