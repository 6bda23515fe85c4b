// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "study_measure.h"

#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Interval_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Predicate_statistics.h>

namespace program {

void study_interval(Study_run& run) {
  measure<IT::Interval_traits>(run, [](Json& findings, const IT::Predicate_statistics& s) {
    findings["undecided"] = s.undecided;
  });
  compare<IT::Interval_traits>(run);
  run.emit();
}

namespace {

void note_exact_decisions(Json& findings, const IT::Predicate_statistics& statistics) {
  findings["filter_failures"] = statistics.filter_failures;
  Json& escalations = findings["escalations"] = Json::object();
  for (const auto& [bits, count] : statistics.escalations)
    escalations[std::to_string(bits)] = count;
  findings["integer"] = statistics.integer;
  findings["certified_zero"] = statistics.certified_zero;
  findings["probable_zero"] = statistics.probable_zero;
}

} // namespace

// Exact decisions need not be compared with themselves.
void study_exact(Study_run& run) {
  using Traits = IT::Exact_euclidean_traits;
  auto t = measure<Traits>(run, note_exact_decisions);
  {
    decltype(t)::Session session(t);
    note_result(run.findings, t, [&session](auto h) { return session.delaunay_sign(h); });
  }
  run.findings["different_decisions"] = 0;
  run.findings["nonconvex_flips"] = 0;
  run.emit();
  IT::Intrinsic_triangulation<IT::Gluing_map, Traits, Cycle_counter> counted{
      IT::Intrinsic_input(run.input)};
  IT::flip_to_delaunay(counted);
  run.findings["cycles"] = counted.correspondence().cycles();
  run.findings["comparison"] = "complete";
  run.emit();
}

} // namespace program
