// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_ADAPTIVE_REFINEMENT_OPTIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_ADAPTIVE_REFINEMENT_OPTIONS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// What adaptive refinement is to reach: see `adaptive_refine()`.
struct Adaptive_refinement_options {
  double tolerance = 0;
  double bulk = 0.5;
  double minimum_angle = 25;
  std::size_t maximum_vertices = 100000;
  std::size_t maximum_rounds = 100;
};

} // namespace internal

/*!
\brief describes a triangulation on which the error was estimated.
*/
struct Adaptive_refinement_round {
  /// Vertices of the triangulation.
  std::size_t vertices = 0;
  /// Root of the sum of the squares of the indicators.
  double estimated_error = 0;
  /// Faces that have the bulk of the error.
  std::size_t marked_faces = 0;
};

/*!
\brief reports what adaptive refinement did.
*/
struct Adaptive_refinement_result {
  /// `done`: the estimated error is at most the tolerance; `cap`: that on the number of vertices or of
  /// rounds was reached; `stalled`: no vertex could be inserted in the faces of large error; `cancelled`.
  Status status = Status::done;
  /// The triangulations, the one refinement started from first; the last one is that in the end.
  std::vector<Adaptive_refinement_round> rounds;
};

/*!
\brief observes adaptive refinement; the default visitor does nothing.
*/
struct Adaptive_refinement_visitor {
  /*!
  \brief is called after every estimate.
  \return whether to go on
  */
  bool progress(const Adaptive_refinement_round&) { return true; }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_ADAPTIVE_REFINEMENT_OPTIONS_H
