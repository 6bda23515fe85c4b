// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_SINGLE_SOURCE_FLIP_TO_GEODESIC_TREE_H
#define CGAL_INTRINSIC_GEODESICS_SINGLE_SOURCE_FLIP_TO_GEODESIC_TREE_H

#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_geodesics/single_source/Geodesic_tree_builder.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Segment_flipper.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a tree of edges of an intrinsic triangulation whose paths from a source are geodesics.

It refers to the triangulation: do not flip edges of the tree.
\tparam Triangulation a model of `GeodesicTriangulation`
*/
template <GeodesicTriangulation Triangulation>
class Geodesic_tree {
public:
  /// Vertex of the triangulation.
  using vertex_descriptor = typename Triangulation::vertex_descriptor;
  /// Halfedge of the triangulation.
  using halfedge_descriptor = typename Triangulation::halfedge_descriptor;
  /// \cond
  Geodesic_tree(const Triangulation& t, std::vector<internal::Branch> branches,
                const Shortening_result& counts)
      : t_(&t), branches_(std::move(branches)), counts_(counts) {}
  /// \endcond

  /// returns the counts and the status of its construction.
  const Shortening_result& shortening() const { return counts_; }
  /// returns the length of the path to a vertex, in the units of the input; infinity without a
  /// path. It is a sum in doubles, with their errors from all flips; with exact traits the edges of
  /// `path_to()` have lengths that are right to 1e-12.
  double length(vertex_descriptor v) const { return branches_[t_->index(v)].length; }
  /// returns the last halfedge of the path to a vertex; a null halfedge at the source, and without
  /// a path.
  halfedge_descriptor halfedge_to(vertex_descriptor v) const {
    const std::uint32_t h = branches_[t_->index(v)].halfedge;
    return h == Gluing::none ? boost::graph_traits<typename Triangulation::Mesh>::null_halfedge()
                             : t_->numbers().halfedge_at(h);
  }
  /// returns the halfedges of the path to a vertex, from the source; none without a path.
  /// \complexity linear in their number
  std::vector<halfedge_descriptor> path_to(vertex_descriptor v) const {
    std::vector<halfedge_descriptor> path;
    for (; branches_[t_->index(v)].halfedge != Gluing::none; v = source(path.back(), t_->mesh()))
      path.push_back(halfedge_to(v));
    std::reverse(path.begin(), path.end());
    return path;
  }

private:
  const Triangulation* t_;
  std::vector<internal::Branch> branches_;
  Shortening_result counts_;
};

/*!
\brief flips edges until a geodesic from a source to every vertex is among them (§5.5 of the
  course).

Windows find shortest paths, see `Polyhedral_distance`; they become edges, the nearest vertex first.
Windows are doubles: if rounding bends a path, it is straightened as by `shorten_curves()`. So the
traits decide that every path of the tree has an angle of at least pi, or the border, on both sides
of all its vertices. That it is a shortest path holds up to errors of doubles.

\tparam Triangulation a model of `GeodesicTriangulation`
\tparam NP a chain of named parameters
\param t the triangulation
\param source the source
\pre the surface is manifold at all vertices
\param np optional named parameters:
  - `maximum_number(n)`: cap on the number of flips. Default: none if the traits are exact, else 100
    per edge and a million.
  - `visitor(v)`: see `Shortening_visitor`
\return the tree, which refers to `t`. Its status is `done`; `stalled` if a vertex connected with
the source has no path, since flips failed or, with inexact traits, all ways to it seem bent; `cap`
or `cancelled`. The paths in the tree are geodesic in any case
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
  return {t, builder.branches(), builder.result()};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_SINGLE_SOURCE_FLIP_TO_GEODESIC_TREE_H
