// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_QUERIES_GEODESIC_FINDER_H
#define CGAL_INTRINSIC_GEODESICS_QUERIES_GEODESIC_FINDER_H

#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_geodesics/curves/insert_point.h>
#include <CGAL/Intrinsic_geodesics/queries/Lone_curve_finder.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Segment_flipper.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a geodesic between points, over the input.
*/
struct Geodesic_path : Traced_curve {
  /// Length of the initial path, in the units of the input: a shortest path, from its search, or a
  /// path along edges.
  double initial_length = 0;
  /// The counts of its shortening.
  Shortening_result shortening;
};

/*!
\brief finds shortest paths between points, or other geodesics (§5.1 of the course, Algorithm 7),
and leaves the triangulation unchanged.

By default a path is a shortest one: a search for the exact distance, see `Polyhedral_distance`,
finds its faces. With `shortest(false)` a query shortens a shortest path along edges to a geodesic
of its homotopy class: locally shortest, and often longer. That is faster, since its cost is local.
In both cases a query flips edges, reads the path, and undoes the flips. Queries are faster on
Delaunay triangulations.
\tparam Triangulation a model of `GeodesicTriangulation` and of `CorrespondingTriangulation`
*/
template <GeodesicTriangulation Triangulation>
class Geodesic_finder {
public:
  /// Vertex of the triangulation.
  using vertex_descriptor = typename Triangulation::vertex_descriptor;
  /// Halfedge of the triangulation.
  using halfedge_descriptor = typename Triangulation::halfedge_descriptor;

  /// prepares queries. \param t the triangulation; it must outlive the finder, and not change
  /// between queries \complexity linear
  explicit Geodesic_finder(Triangulation& t) : t_(t), finder_(t) {}

  /*!
  \brief finds a shortest path between two vertices.
  \param from, to vertices of the triangulation; `vertex_on_intrinsic()` finds those of the user's
  mesh. On a cover, the path is the shortest between any copies, and may pass from one copy of a
  vertex to another
  \param np named parameters of `shorten_curves()`, and:
    - `shortest(b)`: whether to search for the shortest path, or to start from one along edges.
      Default: true, but false with `relative_length` or `minimum_joint_angle`, which stop on the
      way from a path along edges
  \return its way over the input. The status is that of `shorten_curves()`, `stalled` if no path
  exists, `inaccurate` if the path is geodesic but the search for the shortest one gave up, or
  `not_traceable`
  \throws Invalid_input if a vertex is isolated
  \complexity that of the search, and of `shorten_curves()`
  */
  template <NamedParameters NP = parameters::Parameters<>>
  Geodesic_path operator()(vertex_descriptor from, vertex_descriptor to,
                           const NP& np = parameters::default_values()) {
    return (*this)(std::vector<vertex_descriptor>{from, to}, np);
  }

  /*!
  \brief finds shortest paths from each of several vertices to the next one, as one path; see above.
  \param vertices the vertices, two at least; where the path passes one it may turn
  \param np see above
  */
  template <NamedParameters NP = parameters::Parameters<>>
  Geodesic_path operator()(const std::vector<vertex_descriptor>& vertices,
                           const NP& np = parameters::default_values()) {
    Geodesic_path result;
    for (std::size_t i = 0; i + 1 < vertices.size() && result.status == Status::done; ++i) {
      internal::Curve_side<Triangulation> side;
      const Status s = finder_.find(vertices[i], vertices[i + 1], side, result.shortening, np);
      if (side.way.points.empty() && s != Status::done) result = {};
      internal::append(side.way, result);
      result.initial_length += side.initial_length;
      result.status = s == Status::done ? side.search : s;
    }
    return result;
  }

  /*!
  \brief finds shortest paths from each of several points to the next one, as one path. It inserts
  vertices for them, and removes these again.
  \param points points of the input, two at least; `surface_point()` finds those of the user's
  mesh. On a cover, they are on all sheets
  \param np see above
  \return see above; `stalled`, too, if a vertex cannot be inserted
  */
  template <NamedParameters NP = parameters::Parameters<>>
  Geodesic_path operator()(const std::vector<Surface_point>& points,
                           const NP& np = parameters::default_values()) requires
      RefinableTriangulation<Triangulation> {
    std::vector<vertex_descriptor> vertices, inserted;
    Geodesic_path result;
    for (const Surface_point& p : points) {
      const auto copies = insert_point_on_sheets(t_, p);
      vertices.push_back(copies.front().vertex);
      for (const Vertex_at_point<Triangulation>& v : copies)
        if (v.status != Move_status::done)
          result.status = Status::stalled;
        else if (v.is_new)
          inserted.push_back(v.vertex);
    }
    if (result.status == Status::done) result = (*this)(vertices, np);
    for (; !inserted.empty(); inserted.pop_back()) t_.remove_vertex(inserted.back());
    return result;
  }

private:
  Triangulation& t_;
  internal::Lone_curve_finder<Triangulation> finder_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_QUERIES_GEODESIC_FINDER_H
