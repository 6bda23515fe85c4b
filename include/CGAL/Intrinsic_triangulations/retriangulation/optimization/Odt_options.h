// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_OPTIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_OPTIONS_H

#include <cstdint>
#include <limits>
#include <optional>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief says what `odt_optimize()` is to reach, and how long it may take.
*/
struct Odt_options {
  /// Edges that are longer are split, in the units of the input. Default: none is.
  double target_length = std::numeric_limits<double>::infinity();
  /// Cap on the number of iterations, each of which splits long edges, then moves every vertex once.
  unsigned maximum_iterations = 100;
  /// Cap on the number of vertices inserted. Default: a million and ten per face.
  std::optional<std::uint64_t> maximum_insertions = std::nullopt;
  /// It has converged when an iteration without splits lowers the energy by less than this fraction.
  double convergence = 1e-3;
};

/// How the optimisation ended.
enum class Odt_status {
  converged, ///< no edge is longer than the target, and the energy hardly changes
  cap,       ///< the cap on iterations, insertions or, with inexact numbers, flips was reached
  cancelled  ///< the visitor asked to stop
};

/*!
\brief reports what the optimisation did.
*/
struct Odt_result {
  /// How it ended.
  Odt_status status = Odt_status::cap;
  /// Iterations done.
  unsigned iterations = 0;
  /// Edges split.
  std::uint64_t splits = 0;
  /// Vertices moved, those of all iterations together.
  std::uint64_t moves = 0;
  /// Moves and splits that the triangulation refused.
  std::uint64_t refused = 0;
  /// Edges flipped to keep the triangulation Delaunay, those of moves not counted.
  std::uint64_t flips = 0;
  /// The energy before, see `odt_energy()`, in the units of the input to the fourth power.
  double energy_before = 0;
  /// The energy after.
  double energy_after = 0;
};

/*!
\brief observes the optimisation; the default visitor does nothing.
*/
struct Odt_visitor {
  /*!
  \brief is called after every iteration, and about every 256 moves.
  \return whether to go on
  */
  bool progress(const Odt_result&) { return true; }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_OPTIONS_H
