// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_MEASURE_H
#define INTRINSIC_STUDY_MEASURE_H

#include "progress.h"
#include "study_compared_metric.h"
#include "study_cycle_counter.h"
#include "study_results.h"
#include "study_run.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/metric/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/flip_to_delaunay.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace program {

/// A triangulation that was built and flipped, and how long that took.
template <class Triangulation>
struct Timed_flips {
  Triangulation triangulation;
  IT::Flip_to_delaunay_result result;
  double build = 0, flip = 0; ///< seconds
};

/// builds the triangulation and flips it to Delaunay.
template <class Triangulation>
Timed_flips<Triangulation> timed_flips(const IT::Intrinsic_input& input) {
  IT::Intrinsic_input copy = input;
  Stopwatch watch;
  Timed_flips<Triangulation> run{Triangulation(std::move(copy)), {}, 0, 0};
  run.build = watch.lap();
  run.triangulation.metric().statistics() = {};
  run.result = IT::flip_to_delaunay(run.triangulation);
  run.flip = watch.lap();
  return run;
}

/// repeats what is too short for one measurement, and takes the shortest times.
template <class Triangulation>
Timed_flips<Triangulation> fastest_flips(const IT::Intrinsic_input& input) {
  Timed_flips<Triangulation> best = timed_flips<Triangulation>(input);
  for (int repetitions = 1; repetitions < 9 && best.flip < 1e-3; ++repetitions) {
    const Timed_flips<Triangulation> again = timed_flips<Triangulation>(input);
    best.build = std::min(best.build, again.build);
    best.flip = std::min(best.flip, again.flip);
  }
  return best;
}

/// notes how flipping ended and what it did.
inline void note_flips(Json& findings, const IT::Flip_to_delaunay_result& result) {
  findings["status"] = result.status == IT::Flip_to_delaunay_status::done ? "done" : "cap";
  findings["flips"] = result.flips;
  findings["checks"] = result.checks;
  findings["refused_flips"] = result.refused_flips;
}

/// notes how far total area and cone angles have moved.
template <class Triangulation>
void note_drift(Study_run& run, const Triangulation& t) {
  const Conserved after = conserved(t);
  const long double area = run.before.quadruple_area;
  run.findings["area_drift"] =
      static_cast<double>(std::abs(after.quadruple_area - area) / (area > 0 ? area : 1));
  long double largest = 0;
  for (std::size_t v = 0; v < after.cone_angles.size(); ++v)
    largest = std::max(largest, std::abs(after.cone_angles[v] - run.before.cone_angles[v]));
  run.findings["cone_angle_drift"] = static_cast<double>(largest);
}

/// counts edges of the result that are not Delaunay, and ties.
/// \param sign returns the exact sign of pi minus the angles opposite the edge of a halfedge
template <class Triangulation, class Exact_sign>
void note_result(Json& findings, const Triangulation& t, const Exact_sign& sign) {
  const auto& mesh = t.mesh();
  const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
  std::size_t non_delaunay = 0, cocircular = 0;
  for (const auto e : edges(mesh)) {
    const auto h = halfedge(e, mesh), o = opposite(h, mesh);
    if (face(h, mesh) == null || face(o, mesh) == null || face(h, mesh) == face(o, mesh)) continue;
    const CGAL::Sign s = sign(h);
    if (s == CGAL::NEGATIVE) ++non_delaunay;
    if (s == CGAL::ZERO) ++cocircular;
  }
  findings["non_delaunay_edges"] = non_delaunay;
  findings["cocircular_edges"] = cocircular;
}

/*!
\brief repeats the flips beside an exact metric, and notes where they differ.

The key `comparison` is `complete`, or `until_nonconvex_flip` if the exact metric could not follow to the end:
then nothing is said of the result.
*/
template <class Traits>
void compare(Study_run& run) {
  using Compared =
      IT::Intrinsic_triangulation<IT::Gluing_map, Compared_traits<Traits>, Cycle_counter>;
  Compared t{IT::Intrinsic_input(run.input)};
  IT::flip_to_delaunay(t);
  run.findings["different_decisions"] = t.metric().different_decisions();
  run.findings["nonconvex_flips"] = t.metric().nonconvex_flips();
  run.findings["cycles"] = t.correspondence().cycles();
  if (t.metric().is_following())
    note_result(run.findings, t,
                [&t](auto h) { return t.metric().exact_delaunay_sign(t.diamond(h)); });
  run.findings["comparison"] = t.metric().is_following() ? "complete" : "until_nonconvex_flip";
}

/*!
\brief runs an arithmetic alone, for times and result.
\tparam Traits a model of `IntrinsicTriangulationTraits`
\param run notes what is found
\param note_decisions called with findings and the statistics of the metric
\return the result
*/
template <class Traits, class Note_decisions>
auto measure(Study_run& run, const Note_decisions& note_decisions) {
  using Triangulation =
      IT::Intrinsic_triangulation<IT::Gluing_map, Traits, IT::Integer_coordinates>;
  Json& findings = run.findings;
  reset_peak_memory();
  Timed_flips<Triangulation> done = fastest_flips<Triangulation>(run.input);
  findings["peak_rss_mib"] = peak_memory_mib();
  findings["seconds"] = {{"build", done.build}, {"flip", done.flip}};
  note_flips(findings, done.result);
  note_decisions(findings, done.triangulation.metric().statistics());
  findings["result"] = fingerprint(done.triangulation);
  if constexpr (std::is_same_v<typename Traits::FT, CGAL::Interval_nt<false>>)
    findings["largest_interval_width"] = largest_interval_width(done.triangulation);
  run.emit();
  note_drift(run, done.triangulation);
  run.emit();
  return std::move(done.triangulation);
}

/*!
\brief runs an arithmetic: first alone, then compared with exact decisions.
\tparam Traits a model of `IntrinsicTriangulationTraits`
*/
template <class Traits>
void measure_and_compare(Study_run& run) {
  measure<Traits>(run, [](Json&, const IT::Predicate_statistics&) {});
  compare<Traits>(run);
  run.emit();
}

} // namespace program

#endif // INTRINSIC_STUDY_MEASURE_H
