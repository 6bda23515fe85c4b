// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_IMPROVE_H
#define INTRINSIC_IMPROVE_H

#include "constraints.h"
#include "load.h"
#include "options.h"
#include "statistics.h"
#include "support/naming_file.h"
#include "support/progress.h"
#include "support/warnings.h"

#include <CGAL/Intrinsic_operators/improvement/improve_and_measure.h>
#include <CGAL/Intrinsic_operators/improvement/reports.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/support/Report.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace program {

/// Inserts the vertices that a command needs into a triangulation that is done otherwise.
/// It returns whether there were any.
using Insertion = std::function<bool()>;

/// returns what options ask for.
IT::Improve_options asked_improvement(const Options& options, const std::vector<double>& sizes,
                                      Progress& progress);

/// checks that the common subdivision covers the input once.
/// \throws std::runtime_error if rounding has spoilt it
void expect_covered(double input_area, double area, const Options& options);

/// calls a function, and puts the name of the input before what rounding has spoilt.
template <class Function>
auto naming_spoilt(const Options& options, const Function& function) {
  try {
    return naming_file(options.input, function);
  } catch (const IT::Rounding_error& e) {
    throw std::runtime_error(options.input + ": " + e.what());
  }
}

/*!
\brief flips to Delaunay, refines and inserts vertices as options say, and measures; the common part
of all commands.
\param insert called after refinement, which may remove vertices that were inserted before
\param constrain called with the statistics before; returns labels of the edges that are kept
\return the statistics so far
\throws std::runtime_error if rounding has spoilt the triangulation
*/
template <class Triangulation, class Constrain>
Json improve_and_measure(Loaded<Triangulation>& loaded, const Options& options, Progress& progress,
                         const Insertion& insert, const Constrain& constrain) {
  Triangulation& t = loaded.triangulation;
  Json json = loaded_json(loaded, options);
  Edge_labels<Triangulation> constrained = constrain(json);
  if (const std::size_t edges = loaded.metric.changed_edges; edges > 0)
    warn(std::to_string(edges) + " edges were shortened where " + options.metric +
         " violates the triangle inequality");
  const IT::Improve_options asked = asked_improvement(options, loaded.sizes, progress);
  IT::Improved_surface improved = naming_spoilt(
      options, [&] { return IT::improve_soundly(t, loaded.points, asked, constrained); });
  if (const std::string what = improved.shortcoming(); !what.empty()) warn(what);
  if (insert && insert()) {
    // with the parts of edges that split
    const auto kept = constrained_edges(t, loaded.constraints);
    for (const auto e : edges(t.mesh())) put(constrained, e, get(kept, e));
    if (asked.flips)
      IT::flip_to_delaunay(t, edges(t.mesh()),
                           IT::parameters::edge_is_constrained_map(constrained));
    improved.done.statistics = t.metric().statistics();
  }
  progress.show("verifying");
  naming_spoilt(options, [&] {
    IT::measure_improved(t, loaded.points, constrained, !options.metric.empty(), improved);
  });
  const Constraints& c = loaded.constraints;
  IT::Report report;
  IT::report_improvement(report, improved, asked,
                         c.is_asked_for ? std::optional(c.count) : std::nullopt);
  json.update(json_of(report), true);
  return json;
}

/// the same, with the edges that options keep.
template <class Triangulation>
Json improve_and_measure(Loaded<Triangulation>& loaded, const Options& options, Progress& progress,
                         const Insertion& insert = {}) {
  return improve_and_measure(loaded, options, progress, insert, [&](Json&) {
    return constrained_edges(loaded.triangulation, loaded.constraints);
  });
}

} // namespace program

#endif // INTRINSIC_IMPROVE_H
