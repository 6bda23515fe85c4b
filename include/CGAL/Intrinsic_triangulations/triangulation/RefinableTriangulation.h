// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_REFINABLETRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_REFINABLETRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/triangulation/MeasuredTriangulation.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Move_status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/NumberedTriangulation.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/enum.h>

#include <array>
#include <concepts>
#include <span>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief asks for what algorithms that insert, remove and move vertices need of a triangulation.

Syntax of \ref ::RefinableTriangulation, where its meaning is described.
*/
template <class Triangulation>
concept RefinableTriangulation = IntrinsicTriangulation<Triangulation> &&
    MeasuredTriangulation<Triangulation> && NumberedTriangulation<Triangulation> &&
    requires(const Triangulation& t, typename Triangulation::Session& s,
             typename Triangulation::vertex_descriptor v,
             typename Triangulation::halfedge_descriptor h, const std::array<double, 3>& weights,
             std::span<const Indexed_face> faces, double x) {
  { t.sign(faces, Long_side_expression()) } -> std::same_as<Sign>;
  { s.insert_vertex(h, weights).status } -> std::convertible_to<Move_status>;
  { s.insert_vertex(h, weights).vertex } -> std::convertible_to<decltype(v)>;
  { s.split_edge(h, x).status } -> std::convertible_to<Move_status>;
  { s.split_edge(h, x).vertex } -> std::convertible_to<decltype(v)>;
  { s.remove_vertex(v) } -> std::same_as<Move_status>;
  { s.reposition_vertex(v, h, weights).vertex } -> std::convertible_to<decltype(v)>;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_REFINABLETRIANGULATION_H
