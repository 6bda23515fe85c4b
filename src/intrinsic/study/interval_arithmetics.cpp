// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "arithmetics.h"
#include "measure.h"

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Interval_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace program {

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

void note_agreement(Study_run& run, std::uint64_t cycles) {
  note_comparison(run, {0, 0, cycles, true});
}

using Counted_exact =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Cycle_counter>;

void study_interval(Study_run& run) {
  measure_and_compare<IT::Interval_traits>(run, [&run](const auto& t) {
    run.findings["undecided"] = t.metric().statistics().undecided;
    run.findings["largest_interval_width"] = largest_interval_width(t);
  });
}

// Exact decisions need not be compared with themselves.
void study_exact(Study_run& run) {
  using Traits = IT::Exact_euclidean_traits;
  {
    const auto t = measure<Measured<Traits>>(run, [&run](const auto& done) {
      note_exact_decisions(run.findings, done.metric().statistics());
      run.findings["largest_interval_width"] = largest_interval_width(done);
    });
    note_drift(run, conserved(t));
    certify(run, t);
  }
  Counted_exact counted{IT::Intrinsic_input(run.input)};
  IT::flip_to_delaunay(counted);
  note_agreement(run, counted.correspondence().cycles());
}

// The ends of all edges that are no ties: what does not depend on the order of flips.
template <class Triangulation>
std::vector<std::pair<std::uint32_t, std::uint32_t>> edges_without_ties(const Triangulation& t) {
  const typename Triangulation::Const_session session(t);
  const IT::Intrinsic_view<Triangulation> view(t);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
  for (const auto e : edges(t.mesh())) {
    const auto h = halfedge(e, t.mesh());
    const std::uint32_t n = t.numbers().halfedge(h);
    if (!view.is_border(n) && !view.is_border(n ^ 1U) && session.delaunay_sign(h) == CGAL::ZERO)
      continue;
    result.push_back(std::minmax({view.source(n), view.target(n)}));
  }
  std::sort(result.begin(), result.end());
  return result;
}

// Exact traits store lengths and so flip in another order; they must come to the same tessellation.
void study_exact_integer(Study_run& run) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
  measure<IT::Integer_only_triangulation<>>(run, [&run, &found](const auto& done) {
    note_exact_decisions(run.findings, done.metric().statistics());
    found = edges_without_ties(done);
  });
  Counted_exact expected{IT::Intrinsic_input(run.input)};
  IT::flip_to_delaunay(expected);
  if (edges_without_ties(expected) != found) {
    run.findings["comparison"] = "complete";
    run.findings["message"] = "came to another result than exact";
    run.emit();
    return;
  }
  const auto report = IT::check_delaunay(expected);
  note_result(run.findings, {.non_delaunay_edges = report.non_delaunay_edges,
                             .ties = report.cocircular_edges.size(),
                             .statistics = {}});
  note_agreement(run, expected.correspondence().cycles());
}

} // namespace

std::vector<Arithmetic> interval_arithmetics() { return {{"interval", study_interval}}; }

std::vector<Arithmetic> certified_arithmetics() {
  return {{"exact", study_exact}, {"exact-integer", study_exact_integer}};
}

} // namespace program
