// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_QUERIES_INSERT_GEODESIC_H
#define CGAL_INTRINSIC_GEODESICS_QUERIES_INSERT_GEODESIC_H

#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_geodesics/queries/starting_path.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/connectivity/parameters.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Flip_log.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Shortening_result.h>

#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a geodesic along edges of a triangulation.
\tparam Triangulation the type of the triangulation
*/
template <class Triangulation>
struct Inserted_geodesic {
  /// That of `shorten_curves()`; `stalled` if no path leads from one vertex to the other;
  /// `inaccurate`: it is geodesic, but the search for the shortest one gave up, see
  /// `Shortest_path`.
  Status status = Status::done;
  /// Its edges, in its direction. On a cover, an edge may start at another copy of the vertex where
  /// the one before ends.
  std::vector<typename Triangulation::halfedge_descriptor> halfedges;
};

/*!
\brief makes a shortest path between two vertices a path of edges of the triangulation (§4.4 of the
course): edges are flipped.

Most are one edge; where they pass vertices they are more. To keep the path while other edges are
flipped, constrain its edges.
\tparam Triangulation a model of `GeodesicTriangulation`
\param t the triangulation
\param from, to vertices of it; see `vertex_on_intrinsic()` and `insert_point()`. On a cover, the
shortest path between any copies of them is found
\param np named parameters of `shorten_curves()`, and:
  - `shortest(b)`: if false, the path is made of a shortest one along edges, see `Geodesic_finder`.
    Default: true, but false with `relative_length` or `minimum_joint_angle`, which stop on the way
    from that path
\throws Invalid_input if a vertex is isolated
\complexity that of the search by `Polyhedral_distance`, or along edges; of `shorten_curves()`, and
linear in the number of edges
*/
template <GeodesicTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Inserted_geodesic<Triangulation> insert_geodesic(Triangulation& t,
                                                 typename Triangulation::vertex_descriptor from,
                                                 typename Triangulation::vertex_descriptor to,
                                                 const NP& np = parameters::default_values()) {
  if (internal::are_copies(t, from, to)) return {};
  Flip_log<Triangulation>* const no_log = nullptr;
  Shortening_result result;
  Edge_path_finder<Triangulation> find(t);
  const auto way = internal::starting_path(t, from, to, find, no_log, result, np);
  if (way.halfedges.empty()) return {way.status, {}};
  Curve_network<Triangulation> network(t);
  network.add_path(way.halfedges);
  const Status status = internal::shorten_curves(network, no_log, np).status;
  return {status == Status::done ? way.status : status, network.halfedges(0)};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_QUERIES_INSERT_GEODESIC_H
