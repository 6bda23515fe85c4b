// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_IS_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_IS_DELAUNAY_H

#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/enum.h>

#include <boost/graph/graph_traits.hpp>

#include <concepts>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief reports which edges are locally Delaunay.
\tparam Edge an edge descriptor
*/
template <std::semiregular Edge>
struct Delaunay_report {
  /// Number of edges whose opposite angles sum to more than pi.
  std::size_t non_delaunay_edges = 0;
  /// Edges whose opposite angles sum to exactly pi: in a Delaunay triangulation, those that are not
  /// edges of the Delaunay tessellation, whose cells are the unions of faces across them.
  std::vector<Edge> cocircular_edges;
};

/*!
\brief tests every edge for the Delaunay property.

With exact traits the answer is exact. If there are no edges that are not Delaunay, removing
the cocircular ones leaves the Delaunay tessellation, which is unique (Bobenko and Springborn 2007).
Edges on the border, or with the same face on both sides, are locally Delaunay.
\tparam Triangulation a model of `IntrinsicTriangulation`
\complexity linear
*/
template <IntrinsicTriangulation Triangulation>
Delaunay_report<typename Triangulation::edge_descriptor> check_delaunay(const Triangulation& t) {
  using Edge = typename Triangulation::edge_descriptor;
  using Halfedge = typename Triangulation::halfedge_descriptor;
  const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
  const auto& mesh = t.mesh();
  const typename Triangulation::Const_session session(t);
  Delaunay_report<Edge> report;
  for (const Edge e : edges(mesh)) {
    const Halfedge h = halfedge(e, mesh), o = opposite(h, mesh);
    if (face(h, mesh) == null || face(o, mesh) == null || face(h, mesh) == face(o, mesh)) continue;
    const Sign s = session.delaunay_sign(h);
    if (s == NEGATIVE) ++report.non_delaunay_edges;
    if (s == ZERO) report.cocircular_edges.push_back(e);
  }
  return report;
}

/*!
\brief tells whether all edges are locally Delaunay.
\tparam Triangulation a model of `IntrinsicTriangulation`
\complexity linear
*/
template <IntrinsicTriangulation Triangulation>
bool is_delaunay(const Triangulation& t) {
  const typename Triangulation::Const_session session(t);
  for (const typename Triangulation::edge_descriptor e : edges(t.mesh()))
    if (!session.is_locally_delaunay(halfedge(e, t.mesh()))) return false;
  return true;
}

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(is_delaunay)
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(check_delaunay)
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_IS_DELAUNAY_H
