// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CURVES_GEODESICTRIANGULATION_H
#define CGAL_INTRINSIC_GEODESICS_CURVES_GEODESICTRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/enum.h>

#include <concepts>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief requires numbers, lengths, comparisons of angles with pi, and flips that can be undone: what
curves on edges need.

Syntax of \ref ::GeodesicTriangulation, which describes the meaning.
*/
template <class Triangulation>
concept GeodesicTriangulation = IntrinsicTriangulation<Triangulation> &&
    NumberedTriangulation<Triangulation> &&
    requires(const Triangulation& t, typename Triangulation::Session& s,
             typename Triangulation::halfedge_descriptor h,
             typename Triangulation::edge_descriptor e,
             const typename Triangulation::Session::Before_flip& before) {
  { t.length(e) } -> std::same_as<double>;
  { t.numbers().vertex_capacity(t.mesh()) } -> std::same_as<std::uint32_t>;
  { s.compare_angle_to_pi(h, h) } -> std::same_as<Comparison_result>;
  { s.flip_status(h) } -> std::same_as<Move_status>;
  { s.flip_convex_edge(h) } -> std::same_as<Move_status>;
  { s.before_flip(h) } -> std::same_as<typename Triangulation::Session::Before_flip>;
  s.undo_flip(h, before);
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_CURVES_GEODESICTRIANGULATION_H
