// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_EMBEDDING_RUN_H
#define CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_EMBEDDING_RUN_H

#include <CGAL/Intrinsic_simplification/embedding/embed_convex.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

namespace CGAL::Intrinsic_triangulations::internal {

// Knows the stage, counts Newton's steps, and asks the caller whether to go on.
class Embedding_run {
public:
  Embedding_run(const Embed_options& options, Convex_polyhedron& result)
      : options_(options), result_(result) {}

  void begin(Embedding_stage stage) { result_.stage = stage; }
  void set_curvature_left(double part) { curvature_left_ = part; }
  void count_step() { ++result_.steps; }

  // Asks the caller. Once the answer is no, it stays so.
  bool goes_on() {
    if (!is_cancelled_ && options_.progress)
      is_cancelled_ = !options_.progress({result_.stage, curvature_left_, result_.steps});
    return !is_cancelled_;
  }
  bool is_cancelled() const { return is_cancelled_; }
  bool is_over() const { return is_cancelled_ || is_capped(); }
  // the status of what has failed
  Status status() const {
    return is_cancelled_ ? Status::cancelled : is_capped() ? Status::cap : Status::stalled;
  }

private:
  bool is_capped() const { return result_.steps >= options_.maximum_steps; }

  const Embed_options& options_;
  Convex_polyhedron& result_;
  double curvature_left_ = 1;
  bool is_cancelled_ = false;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_EMBEDDING_RUN_H
