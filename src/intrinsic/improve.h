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

#include <CGAL/Intrinsic_operators/improvement/improve.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace program {

/// Inserts the vertices that a command needs into a triangulation that is done otherwise.
/// It returns whether there were any.
using Insertion = std::function<bool()>;

/// What was done to a triangulation, before it is measured.
struct Improved {
  IT::Improvement done;
  double input_area; ///< see `IT::area_of_points()`
};

/// returns what options ask for.
IT::Improve_options asked_improvement(const Options& options, const std::vector<double>& sizes,
                                      Progress& progress);

/// checks what was done, and warns of what is not.
/// \throws std::runtime_error if rounding has spoilt the triangulation
void check_improvement(const IT::Improvement& done, const Options& options, Progress& progress);

/// checks that flips have kept the area.
/// \throws std::runtime_error if rounding has changed it
void expect_area_kept(double before, double after, const Options& options);
/// checks that the common subdivision covers the input once.
/// \throws std::runtime_error if rounding has spoilt it
void expect_covered(double input_area, double area, const Options& options);

/// flips to Delaunay, refines and inserts vertices, as options say.
/// \param insert called after refinement, which may remove vertices that were inserted before
/// \throws std::runtime_error if rounding has spoilt the triangulation
template <class Triangulation>
Improved improve(Loaded<Triangulation>& loaded, Edge_labels<Triangulation>& constrained,
                 const Options& options, Progress& progress, const Insertion& insert = {}) {
  Triangulation& t = loaded.triangulation;
  if (const std::size_t edges = loaded.metric.changed_edges; edges > 0)
    progress.warn(options.input + ": " + std::to_string(edges) + " edges were shortened where " +
                  options.metric + " violates the triangle inequality");
  Improved result{{}, IT::area_of_points(t, loaded.points)};
  result.done = naming_file(options.input, [&] {
    return IT::improve(t, asked_improvement(options, loaded.sizes, progress), constrained);
  });
  check_improvement(result.done, options, progress);
  if (!insert || !insert()) return result;
  const auto kept = constrained_edges(t, loaded.constraints); // with the parts of edges that split
  for (const auto e : edges(t.mesh())) put(constrained, e, get(kept, e));
  if (!options.no_flip)
    IT::flip_to_delaunay(t, edges(t.mesh()), IT::parameters::edge_is_constrained_map(constrained));
  result.done.statistics = t.metric().statistics();
  return result;
}

/// measures a triangulation, and adds that and what was done to the statistics.
/// \throws std::runtime_error if rounding has changed the area
template <class Triangulation>
void measure(Loaded<Triangulation>& loaded, const Edge_labels<Triangulation>& constrained,
             const Improved& improved, const Options& options, Json& json, Progress& progress) {
  constexpr bool is_exact = Triangulation::Metric::is_exact;
  Triangulation& t = loaded.triangulation;
  add_improvement(json, improved.done, options);
  progress.show("verifying");
  Stopwatch watch;
  // coordinates of inserted vertices are not known to the metric
  const std::vector<Point> none;
  const bool has_points =
      loaded.has_points() && num_vertices(t.mesh()) == t.input().number_of_vertices();
  const IT::Measurements measured =
      IT::measure(t, constrained, has_points ? input_points(loaded) : none);
  const double area = improved.input_area;
  // lengths that were changed have another area than the points
  const bool is_area_known = std::isfinite(area) && area > 0 && options.metric.empty() &&
                             t.report().mollification.kind != IT::Mollification::lengths;
  if (!is_exact)
    expect_area_kept(is_area_known ? area : improved.done.area_before, measured.area, options);
  add_measurements(json, measured, improved.done, loaded.constraints, area, is_exact);
  json["seconds"]["verify"] = watch.lap();
}

/*!
\brief improves as options say, and measures; the common part of all commands.
\param insert see `improve()`
\param constrain called with the statistics before; returns labels of the edges that are kept
\return the statistics so far
*/
template <class Triangulation, class Constrain>
Json improve_and_measure(Loaded<Triangulation>& loaded, const Options& options, Progress& progress,
                         const Insertion& insert, const Constrain& constrain) {
  Json json = loaded_json(loaded, options);
  Edge_labels<Triangulation> constrained = constrain(json);
  const Improved improved = improve(loaded, constrained, options, progress, insert);
  measure(loaded, constrained, improved, options, json, progress);
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
