// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_ADAPTIVE_REFINEMENT_OPTIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_ADAPTIVE_REFINEMENT_OPTIONS_H

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief says what adaptive refinement is to reach, and how.
*/
struct Adaptive_refinement_options {
  /// Estimated error at which it ends.
  double tolerance = 0;
  /// Share of the squared estimated error that the faces refined in a round have at least (Dörfler 1996):
  /// the larger, the fewer rounds; the smaller, the fewer vertices. Above 0, at most 1.
  double bulk = 0.5;
  /// Least angle of faces, in degrees; see `Refinement_options::minimum_angle`.
  double minimum_angle = 25;
  /// Cap on the number of vertices, those of the input included.
  std::size_t maximum_vertices = 100000;
  /// Cap on the number of rounds of refinement.
  std::size_t maximum_rounds = 100;
};

/// How adaptive refinement ended.
enum class Adaptive_refinement_status {
  done,      ///< the estimated error is at most the tolerance
  vertices,  ///< the cap on the number of vertices was reached
  rounds,    ///< the cap on the number of rounds was reached
  stalled,   ///< no vertex could be inserted in the faces of large error
  cancelled, ///< the visitor asked to stop
};

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
  /// How it ended.
  Adaptive_refinement_status status = Adaptive_refinement_status::done;
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
