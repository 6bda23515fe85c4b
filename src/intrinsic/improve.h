// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_IMPROVE_H
#define INTRINSIC_IMPROVE_H

#include "adaptive.h"
#include "load.h"
#include "options.h"
#include "refine.h"
#include "statistics.h"
#include "support/progress.h"

#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace program {

/// Inserts the vertices that a command needs into a triangulation that is done otherwise.
/// It returns whether there were any.
using Insertion = std::function<bool()>;

/// inserts vertices, and flips to Delaunay again, if options say so.
template <class Triangulation, class Constrained>
void insert_and_flip(Loaded<Triangulation>& loaded, const Constrained& constrained,
                     const Options& options, const Insertion& insert) {
  if (!insert || !insert()) return;
  Triangulation& t = loaded.triangulation;
  const auto kept = constrained_edges(t, loaded.constraints); // with the parts of edges that split
  for (const auto e : edges(t.mesh())) put(constrained, e, get(kept, e));
  if (!options.no_flip)
    IT::flip_to_delaunay(t, edges(t.mesh()), IT::parameters::edge_is_constrained_map(constrained));
}

/// flips to Delaunay, refines and inserts vertices, as options say, and measures.
/// \param insert called after refinement, which may remove vertices that were inserted before
template <class Triangulation>
Json improve_and_measure(Loaded<Triangulation>& loaded, const Options& options, Progress& progress,
                         const Insertion& insert) {
  if (const std::size_t edges = loaded.metric.changed_edges; edges > 0)
    progress.warn(options.input + ": " + std::to_string(edges) + " edges were shortened where " +
                  options.metric + " violates the triangle inequality");
  const auto constrain = [&](Json&) {
    return constrained_edges(loaded.triangulation, loaded.constraints);
  };
  const auto refine_as_asked = [&](Json& json, const auto& constrained) {
    if constexpr (std::is_same_v<typename Triangulation::Correspondence, IT::Integer_coordinates>)
      if (options.adaptive.is_asked_for)
        return refine_adaptively(loaded.triangulation, constrained, options, json, progress);
    if (options.refines) refine(loaded, constrained, options, json, progress);
  };
  const auto improve = [&](Json& json, const auto& constrained) {
    refine_as_asked(json, constrained);
    insert_and_flip(loaded, constrained, options, insert);
  };
  return flip_and_measure(loaded, !options.no_flip, options, progress, constrain, improve);
}

/// \cond
// declares after `extern template`, or instantiates after `template`, what improves and measures.
#define INTRINSIC_IMPROVEMENTS(prefix, ...)                                                        \
  prefix Json improve_and_measure(Loaded<__VA_ARGS__>&, const Options&, Progress&,                 \
                                  const Insertion&);                                               \
  prefix void refine(Loaded<__VA_ARGS__>&, const Edge_labels<__VA_ARGS__>&, const Options&, Json&, \
                     Progress&);                                                                   \
  prefix Delaunay_check check(__VA_ARGS__&, const Edge_labels<__VA_ARGS__>&);                      \
  prefix IT::Quality quality_of(__VA_ARGS__&, const Delaunay_check&);                              \
  prefix Integrals integrals_of(__VA_ARGS__&, const std::vector<Point>&, const Delaunay_check&);   \
  prefix double input_area(const Loaded<__VA_ARGS__>&);                                            \
  prefix Json loaded_json(const Loaded<__VA_ARGS__>&, const Options&)

INTRINSIC_IMPROVEMENTS(extern template, Exact_triangulation);
INTRINSIC_IMPROVEMENTS(extern template, Double_triangulation);
/// \endcond

} // namespace program

#endif // INTRINSIC_IMPROVE_H
