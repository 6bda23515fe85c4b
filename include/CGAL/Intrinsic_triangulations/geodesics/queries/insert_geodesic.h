// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_QUERIES_INSERT_GEODESIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_QUERIES_INSERT_GEODESIC_H

#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/connectivity/parameters.h>
#include <CGAL/Intrinsic_triangulations/geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_triangulations/geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_triangulations/geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_triangulations/geodesics/shortening/shorten_curves.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a geodesic along edges of a triangulation.
\tparam Triangulation the type of the triangulation
*/
template <class Triangulation>
struct Inserted_geodesic {
  /// That of `shorten_curves()`; `stalled` if no path leads from one vertex to the other.
  Status status = Status::done;
  /// Its edges, in its direction.
  std::vector<typename Triangulation::halfedge_descriptor> halfedges;
};

/*!
\brief makes a geodesic between two vertices a path of edges of the triangulation (§4.4 of the course): edges are flipped.

The geodesic is made of a shortest path along edges, see `Geodesic_finder`. Most are one edge; where they pass vertices they are more. To keep it while other
edges are flipped, constrain its edges.
\tparam Triangulation a model of `GeodesicTriangulation`
\param t the triangulation
\param from, to vertices of it; see `vertex_on_intrinsic()` and `insert_point()`
\param np named parameters of `shorten_curves()`
\complexity that of the search, of `shorten_curves()`, and linear in the number of edges
*/
template <GeodesicTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Inserted_geodesic<Triangulation> insert_geodesic(Triangulation& t,
                                                 typename Triangulation::vertex_descriptor from,
                                                 typename Triangulation::vertex_descriptor to,
                                                 const NP& np = parameters::default_values()) {
  const auto way = Edge_path_finder<Triangulation>(t)(from, to);
  if (way.empty()) return {from == to ? Status::done : Status::stalled, {}};
  Curve_network<Triangulation> network(t);
  network.add_path(way);
  const Status status = shorten_curves(network, np).status;
  return {status, network.halfedges(0)};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_QUERIES_INSERT_GEODESIC_H
