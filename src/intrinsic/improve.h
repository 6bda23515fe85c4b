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

#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace program {

/// flips to Delaunay and refines, as options say, and measures.
template <class Triangulation>
Json improve_and_measure(Loaded<Triangulation>& loaded, const Options& options,
                         Progress& progress) {
  if (const std::size_t edges = loaded.metric.changed_edges; edges > 0)
    progress.warn(options.input + ": " + std::to_string(edges) + " edges were shortened where " +
                  options.metric + " violates the triangle inequality");
  const auto constrain = [&](Json&) {
    return constrained_edges(loaded.triangulation, loaded.constraints);
  };
  const auto improve = [&](Json& json, const auto& constrained) {
    if constexpr (std::is_same_v<typename Triangulation::Correspondence, IT::Integer_coordinates>)
      if (options.adaptive.is_asked_for)
        return refine_adaptively(loaded.triangulation, constrained, options, json, progress);
    if (options.refines) refine(loaded, constrained, options, json, progress);
  };
  return flip_and_measure(loaded, !options.no_flip, options, progress, constrain, improve);
}

/// \cond
// declares after `extern template`, or instantiates after `template`, what improves and measures.
#define INTRINSIC_IMPROVEMENTS(prefix, ...)                                                        \
  prefix Json improve_and_measure(Loaded<__VA_ARGS__>&, const Options&, Progress&);                \
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
