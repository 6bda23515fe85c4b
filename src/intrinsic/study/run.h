// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_RUN_H
#define INTRINSIC_STUDY_RUN_H

#include "lines.h"
#include "results.h"

#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

namespace program {

/// One arithmetic at work on one mesh: what it starts from, and what is found.
struct Study_run {
  /// The input, with the same mollification for all arithmetics.
  IT::Intrinsic_input input;
  /// What flips conserve, before any.
  Conserved before;
  /// What has been found so far.
  Json findings;

  /// sends what has been found so far to the parent: it counts even if the process is killed later.
  void emit() const;
};

/// sets the peak of resident memory back to what is resident now, where the system can.
void reset_peak_memory();

/// returns the peak of resident memory since `reset_peak_memory()`, in MiB.
double peak_memory_mib();

} // namespace program

#endif // INTRINSIC_STUDY_RUN_H
