// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_IMPROVEMENT_H
#define CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_IMPROVEMENT_H

#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/optimization/odt_optimize.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_result.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/adaptive_refine.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <array>
#include <cstddef>
#include <numeric>
#include <optional>

/*!
\file
What `improve()` has done.
*/

namespace CGAL::Intrinsic_triangulations {

/// What refinement did.
struct Refined_faces {
  Status status = Status::done; ///< see `Refinement_result`
  Refinement_counts counts{};   ///< see there
  std::size_t points = 0;       ///< vertices that are not the user's, with those inserted before
  Quality quality_before{};     ///< of the Delaunay triangulation
  double minimum_angle = 0;     ///< of all faces, in degrees
  double satisfied_minimum_angle = 0; ///< of the faces that meet the criteria
  /// Numbers of faces that do not, by the `Unsatisfied_reason`.
  std::array<std::size_t, 4> unsatisfied{};
  /// Greatest ratio of the length of an edge to that wanted there, if lengths were given.
  std::optional<double> longest_side{};
  std::optional<Odt_result> odt{};        ///< if vertices were moved
  double seconds = 0;                     ///< that it took
  double seconds_of_odt = 0;              ///< that moves took

  /// returns the number of faces that do not meet the criteria.
  std::size_t unsatisfied_faces() const {
    return std::accumulate(unsatisfied.begin(), unsatisfied.end(), std::size_t{0});
  }
};

/// What adaptive refinement did.
struct Adapted_faces {
  Adaptive_refinement_result result{}; ///< with errors in units of the input
  /// What the tolerance is given in: the root of the area, or the norm of the kernel.
  double unit = 1;
  double seconds = 0; ///< that it took
};

/// What `improve()` has done.
struct Improvement {
  Flip_to_delaunay_result flips{};        ///< `cap`: rounding did not let flips end
  Predicate_statistics statistics{};      ///< of all predicates
  std::optional<Refined_faces> refined{}; ///< if faces were refined
  std::optional<Adapted_faces> adapted{}; ///< if they were for a function
  std::optional<Inaccuracy> inaccuracy{}; ///< how rounding has spoilt the triangulation, if it has
  double area_before = 0;                 ///< see `stored_area()`
  double seconds_of_flips = 0;            ///< that the first flips took
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_IMPROVEMENT_H
