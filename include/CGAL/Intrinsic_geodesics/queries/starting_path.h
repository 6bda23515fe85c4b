// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_QUERIES_STARTING_PATH_H
#define CGAL_INTRINSIC_GEODESICS_QUERIES_STARTING_PATH_H

#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/connectivity/parameters.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Flip_log.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Segment_flipper.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Shortening_result.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Wedge_flipper.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A path of edges from one vertex to another.
template <class Triangulation>
struct Edge_way {
  Status status = Status::done; // else: there is none, or it is not known to be near the shortest
  std::vector<typename Triangulation::halfedge_descriptor> halfedges;
  double length = 0; // in the units of the input
};

// A straight piece of a shortest path, between two vertices: the edges that it crosses, or the one
// that it runs along; neither between copies of a vertex on a cover.
template <class Triangulation>
struct Straight_piece {
  std::vector<typename Triangulation::halfedge_descriptor> crossed;
  std::optional<typename Triangulation::halfedge_descriptor> along;
};

// Divides a shortest path between two vertices at all vertices that it goes through.
template <class Triangulation>
std::vector<Straight_piece<Triangulation>> straight_pieces(const Triangulation& t,
                                                           const std::vector<Surface_point>& path) {
  using Halfedge = typename Triangulation::halfedge_descriptor;
  const auto& mesh = t.mesh();
  std::vector<Straight_piece<Triangulation>> result;
  Halfedge start = t.numbers().halfedge_at(path.front().halfedge); // from the last vertex
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (path[i].weights[0] == 1) {
      start = t.numbers().halfedge_at(path[i].halfedge);
      result.emplace_back();
    }
    const Surface_point& p = path[i + 1];
    const Halfedge h = t.numbers().halfedge_at(p.halfedge);
    if (p.weights[0] != 1) {
      result.back().crossed.push_back(opposite(h, mesh));
    } else if (result.back().crossed.empty() &&
               !are_copies(t, source(start, mesh), source(h, mesh))) {
      // both sides of a face may lead there
      const Halfedge other = opposite(next(next(start, mesh), mesh), mesh);
      const bool is_first = target(start, mesh) == source(h, mesh);
      const bool is_other = target(other, mesh) == source(h, mesh);
      if (is_first) result.back().along = start;
      if (is_other && (!is_first || t.length(edge(other, mesh)) < t.length(edge(start, mesh))))
        result.back().along = other;
    }
  }
  return result;
}

// Whether halfedges follow each other from one vertex to another, or to copies of them.
template <class Triangulation>
bool leads(const Triangulation& t, typename Triangulation::vertex_descriptor from,
           typename Triangulation::vertex_descriptor to,
           const std::vector<typename Triangulation::halfedge_descriptor>& way) {
  for (const auto h : way) {
    if (!are_copies(t, source(h, t.mesh()), from)) return false;
    from = target(h, t.mesh());
  }
  return are_copies(t, from, to);
}

// Flips edges until a shortest path between two vertices is one of edges, up to rounding: where it
// passes a vertex very closely, it is to be straightened there. Where that is not possible, the
// path is empty.
template <GeodesicTriangulation Triangulation>
Edge_way<Triangulation>
flip_to_shortest_path(Triangulation& t, typename Triangulation::vertex_descriptor from,
                      typename Triangulation::vertex_descriptor to, Flip_log<Triangulation>* log,
                      std::uint64_t most, Shortening_result& result) {
  const Shortest_path path =
      Polyhedral_distance<Triangulation>(t, from, parameters::targets(to)).shortest_path(to);
  Edge_way<Triangulation> way{path.status, {}, path.length};
  if (path.status != Status::done) return way;
  const auto pieces = straight_pieces(t, path.points);
  if (pass_faces_once(t, pieces, &Straight_piece<Triangulation>::crossed)) {
    typename Triangulation::Session session(t);
    Wedge_flipper<Triangulation> flip(t, session, log);
    Segment_flipper<Triangulation> flip_to_segment(t, session, flip);
    const std::uint64_t last = result.flips + most;
    for (const Straight_piece<Triangulation>& piece : pieces) {
      if (!piece.along && piece.crossed.empty()) continue;
      const auto edges =
          piece.along ? std::vector{*piece.along}
                      : flip_to_segment(piece.crossed, last - result.flips, result, [](auto) {});
      way.halfedges.insert(way.halfedges.end(), edges.begin(), edges.end());
    }
    if (leads(t, from, to, way.halfedges)) return way;
  }
  return {Status::inaccurate, {}, path.length};
}

// The path along edges that is to be made geodesic: a shortest path, for which edges are flipped,
// or a shortest one along edges.
template <GeodesicTriangulation Triangulation, class NamedParameters>
Edge_way<Triangulation>
starting_path(Triangulation& t, typename Triangulation::vertex_descriptor from,
              typename Triangulation::vertex_descriptor to, Edge_path_finder<Triangulation>& find,
              Flip_log<Triangulation>* log, Shortening_result& result, const NamedParameters& np) {
  expect_shortening_names<tags::shortest>(np);
  expect_no_isolated_vertex(t, from);
  expect_no_isolated_vertex(t, to);
  constexpr bool is_flow = Has_parameter<tags::relative_length, NamedParameters> ||
                           Has_parameter<tags::minimum_joint_angle, NamedParameters>;
  Edge_way<Triangulation> way;
  if (value_or<tags::shortest>(np, !is_flow))
    way = flip_to_shortest_path(t, from, to, log, maximum_flips(t, np), result);
  if (!way.halfedges.empty() || way.status == Status::stalled) return way;
  way.halfedges = find(copies_of_vertex(t, from), copies_of_vertex(t, to));
  if (way.halfedges.empty()) way.status = Status::stalled;
  way.length = 0;
  for (const auto h : way.halfedges) way.length += t.length(edge(h, t.mesh()));
  return way;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_QUERIES_STARTING_PATH_H
