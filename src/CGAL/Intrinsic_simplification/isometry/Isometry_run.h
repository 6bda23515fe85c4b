// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_ISOMETRY_RUN_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_ISOMETRY_RUN_H

#include <CGAL/Intrinsic_simplification/isometry/Canonical_form.h>
#include <CGAL/Intrinsic_simplification/isometry/Square_root_field.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Proof_watch.h>

namespace CGAL::Intrinsic_triangulations::internal {

inline constexpr const char* search_ended = "the caller has ended the search";

// Long loops call it. \throws Undecidable if the caller of this thread's run has ended it
inline void expect_to_go_on() {
  if (!Proof_watch::goes_on()) throw Undecidable(search_ended);
}

// Knows the stage, and lets all that runs in this thread during its lifetime ask the caller.
class Isometry_run {
public:
  explicit Isometry_run(const Isometry_options& options) : options_(options) {}

  // \throws Undecidable if the caller ends the run
  void begin(Isometry_stage stage) {
    now_.stage = stage;
    if (!ask()) throw Undecidable(search_ended);
  }
  bool ask() {
    is_ended_ = is_ended_ || (options_.progress && !options_.progress(now_));
    return !is_ended_;
  }
  bool is_ended() const { return is_ended_; }

private:
  const Isometry_options& options_;
  Isometry_progress now_;
  bool is_ended_ = false;
  Proof_watch watch_{[this] { return ask(); }};
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_ISOMETRY_RUN_H
