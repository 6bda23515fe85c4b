// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_MEASURE_H
#define INTRINSIC_STUDY_MEASURE_H

#include "Compared_metric.h"
#include "Cycle_counter.h"
#include "results.h"
#include "run.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/certify_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/support/Stopwatch.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
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
  IT::Stopwatch watch;
  Timed_flips<Triangulation> run{Triangulation(std::move(copy)), {}, 0, 0};
  run.build = watch.lap();
  run.result = IT::flip_to_delaunay(run.triangulation);
  run.flip = watch.lap();
  return run;
}

/// repeats short runs, which other processes disturb most, and takes the least times.
template <class Triangulation>
Timed_flips<Triangulation> fastest_flips(const IT::Intrinsic_input& input) {
  Timed_flips<Triangulation> best = timed_flips<Triangulation>(input);
  for (int done = 1; done < 9 && (best.build + best.flip) * done < 0.2; ++done) {
    const Timed_flips<Triangulation> again = timed_flips<Triangulation>(input);
    best.build = std::min(best.build, again.build);
    best.flip = std::min(best.flip, again.flip);
  }
  return best;
}

/// notes how long it took to build and to flip, how flipping ended and what it did.
void note_flips(Json& findings, double build, double flip,
                const IT::Flip_to_delaunay_result& result);

/// notes how far total area and cone angles have moved.
void note_drift(Study_run& run, const Conserved& after);

/// notes what a result is, exactly.
void note_result(Json& findings, const IT::Delaunay_certificate& certificate);

/// What an arithmetic did beside an exact metric.
struct Comparison {
  std::uint64_t different_decisions, nonconvex_flips, cycles;
  bool is_complete;
};
/// notes where they differ.
void note_comparison(Study_run& run, const Comparison& found);

/// decides what a result is from its integer coordinates and the input, which no flip has touched.
/// Nothing is noted of edges that cross too much of the input to be unfolded.
template <class Triangulation>
void certify(Study_run& run, const Triangulation& t) {
  try {
    note_result(run.findings, IT::certify_delaunay(t));
  } catch (const std::length_error&) {
    return;
  }
  run.emit();
}

/*!
\brief repeats the flips beside an exact metric, and notes where they differ.

The key `comparison` is `complete`, or `until_nonconvex_flip` if the exact metric could not make all
flips.
*/
template <class Traits>
void compare(Study_run& run) {
  using Compared =
      IT::Intrinsic_triangulation<IT::Gluing_map, Compared_traits<Traits>, Cycle_counter>;
  Compared t{IT::Intrinsic_input(run.input)};
  IT::flip_to_delaunay(t);
  note_comparison(run, {t.metric().different_decisions(), t.metric().nonconvex_flips(),
                        t.correspondence().cycles(), t.metric().is_following()});
}

/*!
\brief runs an arithmetic alone, for times and result.
\tparam Triangulation a model of `IntrinsicTriangulation` with `Integer_coordinates`
\param run notes what is found
\param note_more called with the result, to note what else was found while flipping
\return the result
*/
template <class Triangulation, class Note_more>
Triangulation measure(Study_run& run, const Note_more& note_more) {
  Json& findings = run.findings;
  reset_peak_memory();
  Timed_flips<Triangulation> done = fastest_flips<Triangulation>(run.input);
  findings["peak_rss_mib"] = peak_memory_mib();
  note_flips(findings, done.build, done.flip, done.result);
  note_more(done.triangulation);
  findings["result"] = fingerprint(done.triangulation);
  run.emit();
  return std::move(done.triangulation);
}

/// An intrinsic triangulation whose result can be certified.
template <class Traits>
using Measured = IT::Intrinsic_triangulation<IT::Gluing_map, Traits, IT::Integer_coordinates>;

/*!
\brief runs an arithmetic: first alone, then compared with exact decisions.
\tparam Traits a model of `IntrinsicTriangulationTraits`
\param run notes what is found
\param note_more see `measure()`
*/
template <class Traits, class Note_more>
void measure_and_compare(Study_run& run, const Note_more& note_more) {
  {
    const auto t = measure<Measured<Traits>>(run, note_more);
    note_drift(run, conserved(t));
    certify(run, t);
  }
  compare<Traits>(run);
}

/// the same, with nothing more to note
template <class Traits>
void measure_and_compare(Study_run& run) {
  measure_and_compare<Traits>(run, [](const Measured<Traits>&) {});
}

} // namespace program

#endif // INTRINSIC_STUDY_MEASURE_H
