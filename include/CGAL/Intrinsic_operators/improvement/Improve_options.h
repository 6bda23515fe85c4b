// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_IMPROVE_OPTIONS_H
#define CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_IMPROVE_OPTIONS_H

#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_result.h>
#include <CGAL/Intrinsic_triangulations/support/defaults.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

/*!
\file
What is asked of `improve()`.
*/

namespace CGAL::Intrinsic_triangulations {

/// returns the order with a name: "largest", "worst", or else "first".
inline Refinement_order refinement_order(std::string_view name) {
  return name == "largest" ? Refinement_order::largest_first
         : name == "worst" ? Refinement_order::worst_first
                           : Refinement_order::first_come;
}

/// Which faces refinement splits. Lengths are in the units of the input.
struct Refine_criteria {
  /// In degrees; up to 30 refinement always ends.
  double minimum_angle = defaults::min_angle;
  double maximum_circumradius = std::numeric_limits<double>::infinity(); ///< of faces
  double maximum_edge_length = std::numeric_limits<double>::infinity();  ///< of all edges
  /// How long edges may be at each of the user's vertices, linear between them; empty: anything.
  /// It needs a correspondence.
  std::vector<double> lengths{};
  std::optional<std::uint64_t> maximum_insertions = std::nullopt; ///< see `delaunay_refine()`
  Refinement_order order = refinement_order(defaults::order);     ///< in which faces are split
  bool is_conforming = false; ///< whether kept edges that are not Delaunay are split
  /// Length of edges to which inserted vertices are moved then, by `odt_optimize()`; 0: they stay.
  double odt_length = 0;
};

/// For which function refinement has small errors: one with a pole at a vertex.
struct Adapt_criteria {
  std::uint32_t source = 0; ///< the vertex, by its row in the input
  /// Of the heat kernel there, in squares of the mean edge; 0: the harmonic Green's function.
  double heat_time = 0;
  /// In units of the root of the area, or of the norm of the kernel.
  double tolerance = defaults::tolerance;
  std::size_t maximum_vertices = defaults::max_vertices; ///< where refinement ends
  double minimum_angle = defaults::min_angle;            ///< of faces, in degrees
};

/// What `improve()` does at the time, and what it counts.
enum class Improve_step : std::uint8_t {
  flipping, ///< flips to Delaunay; counts flips
  refining, ///< counts vertices that were inserted
  moving,   ///< moves inserted vertices; counts iterations
  adapting  ///< refines for a function; counts vertices
};

/// What `improve()` is asked for.
struct Improve_options {
  bool flips = true;                       ///< to Delaunay, before all else
  std::optional<Refine_criteria> refine{}; ///< if faces are refined
  std::optional<Adapt_criteria> adapt{};   ///< in place of that
  /// Is called with a step and its count, and returns whether to go on.
  std::function<bool(Improve_step, std::uint64_t)> progress{};
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_IMPROVE_OPTIONS_H
