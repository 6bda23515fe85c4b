// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_DISTANCE_DISTANCE_OPTIONS_H
#define CGAL_INTRINSIC_OPERATORS_DISTANCE_DISTANCE_OPTIONS_H

#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/defaults.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

/*!
\file
What is asked of `Distances`, and what it finds.
*/

namespace CGAL::Intrinsic_triangulations {

/// How distances are found.
enum class Distance_method : std::uint8_t {
  exact, ///< along shortest paths, by `Polyhedral_distance`; on a cover, on the faces below it
  heat   ///< approximately, by `Heat_distance`, which is faster for many calls
};

/// What a search for distances does at the time.
enum class Distance_step : std::uint8_t {
  windows,  ///< looks through the windows of exact distances; how many is counted
  matrices, ///< factors matrices, or solves with them
  parts,    ///< has found columns of distances, or pairs; how many is counted
  cells     ///< divides the surface, see `divide_among()`
};

/// What is asked of distances.
struct Distance_options {
  Distance_method method = Distance_method::exact; ///< how they are found
  /// How far an exact search goes, in the units of the input.
  double maximum_distance = std::numeric_limits<double>::infinity();
  double time_factor = defaults::time_factor; ///< of the flow of heat, see `Heat_distance`
  std::size_t number_of_threads = 0;          ///< for many sets or pairs; 0: as many as processors
  /// Is called with what is done, how much of it, and how much there is, 0 if that is unknown;
  /// returns whether to go on.
  std::function<bool(Distance_step, std::uint64_t, std::uint64_t)> progress{};
};

/// Distances that were found; infinity where no source is reached.
struct Found_distances {
  std::vector<double> by_row;     ///< of each vertex, see `Intrinsic_triangulation::input_vertex()`
  std::vector<double> at_targets; ///< of each target
  Status status = Status::done;   ///< `cap` if an exact search met its cap, or `cancelled`
  /// How far an exact search went, in the units of the input; infinity: everywhere.
  double reached = std::numeric_limits<double>::infinity();
  double time = 0; ///< of the flow of heat, in units of area of the input
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_DISTANCE_DISTANCE_OPTIONS_H
