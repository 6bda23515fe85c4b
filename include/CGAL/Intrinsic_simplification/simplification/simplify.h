// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_SIMPLIFY_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_SIMPLIFY_H

#include <CGAL/Intrinsic_simplification/simplification/Fine_surface.h>
#include <CGAL/Intrinsic_simplification/simplification/Simplification.h>
#include <CGAL/Intrinsic_simplification/simplification/removal_costs.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// \throws Invalid_input if an option is out of range
Simplification simplify(const Fine_surface& fine, const Simplify_options& options,
                        Asked_cost& cost);

} // namespace internal

/*!
\brief makes a surface with fewer vertices, and proves by how much lengths change.

A vertex is removed as by Liu, Gillespie, Chislett, Sharp, Jacobson and Crane, Surface
Simplification using Intrinsic Error Metrics (2023): the lengths of the edges at it are multiplied
by one factor until the angles at it sum to 2 pi, on the border to pi; then its star is flat, and
other triangles take its place. The triangulation stays Delaunay for all factors between: an edge is
flipped where its faces become inscribed in one circle, where the flips of Euclid and Ptolemy are
the same. Hence on a surface without border one factor fits each vertex.

The map from the fine to the coarse surface is linear in pieces. Each coarse face has two quadratic
forms, proven bounds of the lengths of tangent vectors of the fine surface at all of its points. A
factor at a vertex changes the lengths of a face, but not the values of the forms on its sides; new
faces get forms that bound those of all old faces that they overlap. Bounds are in intervals, so
that they are theorems of the surface that the input's doubles define.

\tparam Triangulation a model of `NumberedTriangulation` with Euclid's metric
\tparam Cost a model of `RemovalCost`
\param t the triangulation, Delaunay; with exact traits all bounds are proven, with others they hold
  for its doubles
\param options what is asked for
\param cost vertices with low costs are removed first; one whose cost is not finite stays
\return the coarse surface, also if it has more vertices than you asked for: see its status
\throws Invalid_input if a vertex or an edge that shall stay does not exist, or a bound is out of
  range
\complexity O(n log n) for n vertices of bounded degree
*/
template <NumberedTriangulation Triangulation, RemovalCost Cost = Stretch_cost>
Simplification simplify(const Triangulation& t, const Simplify_options& options = {},
                        Cost cost = {}) {
  internal::Asked_cost_of<Cost> asked(std::move(cost));
  return internal::simplify(internal::fine_surface(t), options, asked);
}

/// simplifies the Delaunay triangulation of a mesh, see above.
/// \tparam FaceGraph a model of `FaceListGraph` with a point map of its own, or `Triangle_soup`
/// \tparam Cost a model of `RemovalCost`
template <class FaceGraph, RemovalCost Cost = Stretch_cost>
  requires internal::Surface_in_space<FaceGraph> Simplification
  simplify(const FaceGraph& mesh, const Simplify_options& options = {}, Cost cost = {}) {
    return simplify(delaunay_triangulation(mesh), options, std::move(cost));
  }

/// \cond
template <class Surface, internal::Not_a_cost Cost>
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_COST(simplify)
internal::Refused_call simplify(const Surface&, const Simplify_options&, const Cost&);
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_SIMPLIFY_H
