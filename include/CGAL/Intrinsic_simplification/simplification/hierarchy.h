// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_HIERARCHY_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_HIERARCHY_H

#include <CGAL/Intrinsic_simplification/simplification/Fine_surface.h>
#include <CGAL/Intrinsic_simplification/simplification/Simplification.h>
#include <CGAL/Intrinsic_simplification/simplification/removal_costs.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// \throws Invalid_input if an option is out of range
std::vector<Simplification> hierarchy(const Fine_surface& fine, std::size_t levels, double ratio,
                                      const Simplify_options& options, Asked_cost& cost);

} // namespace internal

/*!
\brief makes coarser and coarser surfaces, in one run of `simplify()`.

Each level is what `simplify()` gives for its number of vertices, and the next one goes on from it:
the vertices of a level are among those of the levels before, and what is kept stays at all levels.
Each element says where the vertices of `t` are, and how far it is stretched from `t`. Vertices of
one level are on the next one where `prolongation(finer, coarser)` says.
\tparam Triangulation see `simplify()`
\param t the triangulation, Delaunay
\param levels how many at most
\param ratio the part of the vertices that stays at each level, between 0 and 1
\param options bounds, and what is kept, at all levels; numbers of vertices are ignored
\param cost see `simplify()`
\return the coarse surfaces, the finest first; fewer where no other vertex can be removed, or it was
  cancelled
\throws Invalid_input as `simplify()`, and if the ratio is out of range
\complexity that of `simplify()`, and linear in the fine surface for each level
*/
template <NumberedTriangulation Triangulation, RemovalCost Cost = Stretch_cost>
std::vector<Simplification> hierarchy(const Triangulation& t, std::size_t levels,
                                      double ratio = 0.25, const Simplify_options& options = {},
                                      Cost cost = {}) {
  internal::Asked_cost_of<Cost> asked(std::move(cost));
  return internal::hierarchy(internal::fine_surface(t), levels, ratio, options, asked);
}

/// \cond
template <class Triangulation, internal::Not_a_cost Cost>
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_COST(hierarchy)
internal::Refused_call
    hierarchy(const Triangulation&, std::size_t, double, const Simplify_options&, const Cost&);
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_HIERARCHY_H
