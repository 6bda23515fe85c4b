// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_OPTIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_OPTIONS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>

#include <cstdint>
#include <limits>
#include <optional>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// What the optimisation is to reach: see `odt_optimize()`.
struct Odt_options {
  double maximum_edge_length = std::numeric_limits<double>::infinity();
  unsigned number_of_iterations = 100;
  std::optional<std::uint64_t> maximum_insertions = std::nullopt;
  double convergence = 1e-3;
};

} // namespace internal

/*!
\brief reports what the optimisation did.
*/
struct Odt_result {
  /// `done`: no edge is longer than asked, and the energy hardly changes; `cap`: that on iterations,
  /// insertions or, with inexact numbers, flips was reached; or `cancelled`.
  Status status = Status::cap;
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
