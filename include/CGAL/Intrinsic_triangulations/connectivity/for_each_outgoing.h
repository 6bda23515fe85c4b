// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_FOR_EACH_OUTGOING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_FOR_EACH_OUTGOING_H

#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>

#include <boost/graph/graph_traits.hpp>

#include <concepts>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief calls a function with the halfedges that start at a vertex, counterclockwise.

On the border the first has no face on its right, and the last none on its left: the vertex's
halfedge is on the border there, as in every mesh of this package. At a vertex that is not manifold
these are the halfedges of one fan. A loop is met in both directions.
\tparam Mesh a mesh of triangles
\tparam Function a functor with halfedges as argument, which must not change the mesh
\param v the vertex \pre it is not isolated
\param mesh the mesh
\param f the functor
\complexity linear in the degree
*/
template <ReadableFaceGraph Mesh,
          std::invocable<typename boost::graph_traits<Mesh>::halfedge_descriptor> Function>
void for_each_outgoing(typename boost::graph_traits<Mesh>::vertex_descriptor v, const Mesh& mesh,
                       Function f) {
  using Traits = boost::graph_traits<Mesh>;
  const typename Traits::halfedge_descriptor first = opposite(halfedge(v, mesh), mesh);
  typename Traits::halfedge_descriptor h = first;
  do {
    f(h);
    if (face(h, mesh) == Traits::null_face()) return;
    h = opposite(next(next(h, mesh), mesh), mesh);
  } while (h != first);
}

/// calls a function with the halfedges that start at the source of `h` and are in the same fan of
/// faces, in some order; see above.
template <ReadableFaceGraph Mesh,
          std::invocable<typename boost::graph_traits<Mesh>::halfedge_descriptor> Function>
void for_each_outgoing_in_fan(typename boost::graph_traits<Mesh>::halfedge_descriptor h,
                              const Mesh& mesh, Function f) {
  const auto null = boost::graph_traits<Mesh>::null_face();
  const auto first = h;
  do {
    f(h);
    if (face(h, mesh) == null) break;
    h = opposite(next(next(h, mesh), mesh), mesh);
  } while (h != first);
  if (face(h, mesh) != null) return;
  for (h = first; face(opposite(h, mesh), mesh) != null;) f(h = next(opposite(h, mesh), mesh));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_FOR_EACH_OUTGOING_H
