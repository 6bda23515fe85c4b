// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_SINGLE_SOURCE_FLIP_TO_GEODESIC_TREE_H
#define CGAL_INTRINSIC_GEODESICS_SINGLE_SOURCE_FLIP_TO_GEODESIC_TREE_H

#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_geodesics/single_source/Geodesic_tree.h>
#include <CGAL/Intrinsic_geodesics/single_source/Geodesic_tree_builder.h>
#include <CGAL/Intrinsic_triangulations/connectivity/parameters.h>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief flips edges until a geodesic from a source to every vertex is among them (§5.5 of the course).

Shortest paths are found by windows, see `Polyhedral_distance`, and made edges, the nearest vertex
first. Windows are doubles: where a path is bent by rounding, it is straightened as by
`shorten_curves()`. So every path of the tree has an angle of at least pi on both sides of all its
vertices, or the border there, as the traits decide; that it is a shortest one is as certain as
doubles are.

\tparam Triangulation a model of `GeodesicTriangulation`
\tparam NP a chain of named parameters
\param t the triangulation
\param source the source
\pre the surface is manifold at all vertices
\param np optional named parameters:
  - `maximum_number(n)`: cap on the number of flips. Default: none if the traits are exact, else 100 per edge and a million.
  - `visitor(v)`: see `Shortening_visitor`
\return the tree, which refers to `t`. Its status is `done`, `stalled` if a vertex that is connected with the source has no path as
flips were refused or, if the traits are not exact, all ways to it seem to be bent; `cap` or `cancelled`. What is in the tree is geodesic in any
case.
\complexity that of `Polyhedral_distance`, and linear in the number of flips
*/
template <GeodesicTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Geodesic_tree<Triangulation> flip_to_geodesic_tree(Triangulation& t,
                                                   typename Triangulation::vertex_descriptor source,
                                                   const NP& np = parameters::default_values()) {
  namespace tags = internal::tags;
  internal::expect_names<tags::maximum_number, tags::visitor>(np);
  auto stored_visitor = internal::object_or<tags::visitor>(np, Shortening_visitor());
  auto& observed = internal::unwrapped(stored_visitor);
  const std::uint64_t cap = internal::maximum_flips(t, np);
  typename Triangulation::Session session(t);
  internal::Geodesic_tree_builder<Triangulation> builder(t, session);
  builder.run(source, cap, [&](const Shortening_result& r) { return observed.progress(r); });
  return builder.tree();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_SINGLE_SOURCE_FLIP_TO_GEODESIC_TREE_H
