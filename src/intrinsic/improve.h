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

namespace program {

/// flips to Delaunay and refines, as options say, and measures.
template <class Triangulation>
Json improve_and_measure(Loaded<Triangulation>& loaded, const Options& options,
                         Progress& progress) {
  if (const std::size_t edges = loaded.metric.changed_edges; edges > 0)
    progress.warn(options.input + ": " + std::to_string(edges) + " edges were shortened where " +
                  options.metric + " violates the triangle inequality");
  const auto constrain = [&](Json&) {
    return marked_edges(loaded.triangulation, loaded.constraints);
  };
  const auto improve = [&](Json& json, const auto& constrained) {
    if constexpr (std::is_same_v<typename Triangulation::Correspondence, IT::Integer_coordinates>)
      if (options.adaptive.is_asked_for)
        return refine_adaptively(loaded.triangulation, constrained, options, json, progress);
    if (options.refines) refine(loaded, constrained, options, json, progress);
  };
  return flip_and_measure(loaded, !options.no_flip, options, progress, constrain, improve);
}

/// The triangulations for which improve.cpp has compiled this function, as several programs and the
/// Python module need it.
using Exact_triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                        IT::Integer_coordinates>;
/// With doubles.
using Double_triangulation =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>,
                                IT::Integer_coordinates>;

extern template Json improve_and_measure(Loaded<Exact_triangulation>&, const Options&, Progress&);
extern template Json improve_and_measure(Loaded<Double_triangulation>&, const Options&, Progress&);

} // namespace program

#endif // INTRINSIC_IMPROVE_H
