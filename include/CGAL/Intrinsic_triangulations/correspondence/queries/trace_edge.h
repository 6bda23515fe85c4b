// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TRACE_EDGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TRACE_EDGE_H

#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Edge_path.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Curve_queries.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <boost/graph/graph_traits.hpp>

#include <cstdint>
#include <vector>

/*!
\file
Traces edges of one triangulation over the other, by any correspondence.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief traces an intrinsic edge over the input.
\tparam Triangulation a model of `CorrespondingTriangulation`
\param t the triangulation
\param e the edge
\return its path, from the source of its halfedge `2 * t.index(e)`
\complexity linear in the number of crossings; with `Integer_coordinates`, in the number of steps of
  `follow_curves()`
*/
template <QueriedTriangulation Triangulation>
Edge_path trace_edge(const Triangulation& t, typename Triangulation::edge_descriptor e) {
  return internal::queries(t).path_on_input(t.index(e));
}

/*!
\brief traces an edge of the input over the intrinsic triangulation.
\tparam Triangulation as for `trace_edge()`
\param t the triangulation
\param x a halfedge of the input, by its number
\return its path, from the source of the halfedge
\complexity linear in the number of crossings, in the degrees of its ends, and with `Signposts` in
  the number of inserted vertices
*/
template <QueriedTriangulation Triangulation>
Edge_path trace_input_edge(const Triangulation& t, std::uint32_t x) {
  return internal::queries(t).path_on_intrinsic(x);
}

/*!
\brief traces an edge of the user's mesh over the intrinsic triangulation.
\param t the triangulation
\param e the edge
\param mesh the mesh that `t` was built from; its faces may be polygons
\return its path, from the source of `halfedge(e, mesh)`
\throws Invalid_input if the mesh is another one
\complexity see the overload without mesh
*/
template <QueriedTriangulation Triangulation, ReadableFaceGraph Mesh>
Edge_path trace_input_edge(const Triangulation& t,
                           typename boost::graph_traits<Mesh>::edge_descriptor e,
                           const Mesh& mesh) {
  return trace_input_edge(
      t, internal::Named_mesh_elements<Mesh>(t.input(), mesh).halfedge_on_input(halfedge(e, mesh)));
}

/*!
\brief returns the points of a path in space, in the type of points of the user's mesh.
\param t the triangulation
\param path what `trace_edge()` or `trace_input_edge()` returned
\param mesh the mesh that `t` was built from; its faces may be polygons
\throws Invalid_input if the mesh is another one
\complexity linear
*/
template <NumberedTriangulation Triangulation, ReadableFaceGraph Mesh>
auto polyline(const Triangulation& t, const Edge_path& path, const Mesh& mesh) {
  const internal::Named_mesh_elements<Mesh> named(t.input(), mesh);
  std::vector<decltype(named.point({}))> points;
  for (const Path_point& p : path.points) points.push_back(named.point(p.on_input));
  return points;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TRACE_EDGE_H
