// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_REMOVE_FLAT_VERTICES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_REMOVE_FLAT_VERTICES_H

#include <CGAL/Intrinsic_simplification/simplification/Fine_surface.h>
#include <CGAL/Intrinsic_simplification/simplification/Simplification.h>
#include <CGAL/Intrinsic_simplification/simplification/flat_vertices.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Removes the given vertices, by row. \throws Invalid_input if an option is out of range
Simplification remove_vertices(const Fine_surface& fine, const std::vector<char>& may_go,
                               const Simplify_options& options);

} // namespace internal

/*!
\brief removes vertices at which the surface is flat, or the border straight.

With `within` zero, the angles at a vertex must sum to 2 pi, on the border to pi, exactly. That is
decided in integers, on the faces of the input, for all traits: no tolerance. Then the surface stays
the same, and the proven stretch differs from 1 only by the rounding of new lengths. Few vertices of
rounded CAD parts are flat; `within` 1e-6 or so removes the others as `simplify()` does.
\tparam Triangulation a model of `NumberedTriangulation` with Euclid's metric
\param t the triangulation, Delaunay
\param within by how much the angles may differ from the straight ones, in radians; finite and not
  negative
\param options bounds, and what is kept; without a number of vertices, all flat ones go
\return the coarse surface; its status is `done` if all such vertices are gone
\throws Invalid_input as `simplify()`, if `within` is out of range, or if `t` has neither
  correspondence nor points
\complexity O(n log n) for n vertices of bounded degree
*/
template <NumberedTriangulation Triangulation>
Simplification remove_flat_vertices(const Triangulation& t, double within = 0,
                                    const Simplify_options& options = {}) {
  return internal::remove_vertices(internal::fine_surface(t), internal::flat_vertices(t, within),
                                   options);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_REMOVE_FLAT_VERTICES_H
