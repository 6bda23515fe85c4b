// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_QUERIES_LONE_CURVE_FINDER_H
#define CGAL_INTRINSIC_GEODESICS_QUERIES_LONE_CURVE_FINDER_H

#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/queries/Curve_inserter.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Segment_flipper.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A path of edges from one vertex to another.
template <class Triangulation>
struct Edge_way {
  Status status = Status::done; // else: there is none, or it may not be near the shortest
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

// Asks a visitor of shortening during a search.
template <class Visitor>
struct Search_of_shortening {
  Visitor* visitor;
  const Shortening_result* counts; // so far
  bool progress(std::uint64_t, double) { return visitor->progress(*counts); }
};

// Flips edges until a shortest path between two vertices is a path of edges, up to rounding: the
// caller straightens it where it passes very close to a vertex. The path is empty if this fails.
template <GeodesicTriangulation Triangulation, class NamedParameters>
Edge_way<Triangulation>
flip_to_shortest_path(Triangulation& t, typename Triangulation::vertex_descriptor from,
                      typename Triangulation::vertex_descriptor to, Flip_log<Triangulation>* log,
                      Shortening_result& result, const NamedParameters& np) {
  auto stored_visitor = object_or<tags::visitor>(np, Shortening_visitor());
  Search_of_shortening observed{&unwrapped(stored_visitor), &result};
  const Polyhedral_distance<Triangulation> search(
      t, from, parameters::targets(to).visitor(std::ref(observed)));
  if (search.status() == Status::cancelled) return {Status::cancelled, {}, 0};
  const Shortest_path path = search.shortest_path(to);
  Edge_way<Triangulation> way{path.status, {}, path.length};
  if (path.status != Status::done) return way;
  const auto pieces = straight_pieces(t, path.points);
  if (pass_faces_once(t, pieces, &Straight_piece<Triangulation>::crossed)) {
    typename Triangulation::Session session(t);
    Segment_flipper<Triangulation> flip_to_segment(t, session, log);
    const std::uint64_t last = result.flips + maximum_flips(t, np);
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

// The initial path along edges: a shortest path, after flips, or a shortest path along edges.
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
    way = flip_to_shortest_path(t, from, to, log, result, np);
  if (!way.halfedges.empty() || way.status == Status::stalled || way.status == Status::cancelled)
    return way;
  way.halfedges = find(copies_of_vertex(t, from), copies_of_vertex(t, to));
  if (way.halfedges.empty()) way.status = Status::stalled;
  way.length = 0;
  for (const auto h : way.halfedges) way.length += t.length(edge(h, t.mesh()));
  return way;
}

// A geodesic over the input, with its ends.
template <class Triangulation>
struct Curve_side {
  typename Triangulation::vertex_descriptor from, to;
  Traced_curve way;
  Status search = Status::done; // `inaccurate` if the search for the shortest path gave up
  double initial_length = 0;    // of what it was made of
};

// Finds geodesics, each alone on the surface, and leaves the triangulation unchanged.
template <class Triangulation>
class Lone_curve_finder {
  using Vertex = typename Triangulation::vertex_descriptor;
  using Side = Curve_side<Triangulation>;

public:
  explicit Lone_curve_finder(Triangulation& t) : t_(t), find_(t), network_(t) {}

  // A shortest path between any copies of two vertices, which become the ends of the side; another
  // geodesic if the search gives up.
  // \param np those of `shorten_curves()`, and `shortest(b)`
  template <class NamedParameters = parameters::Parameters<>>
  Status find(Vertex from, Vertex to, Side& side, Shortening_result& counts,
              const NamedParameters& np = parameters::default_values()) {
    side = {from, to, {}};
    if (are_copies(t_, from, to)) return Status::done;
    Flip_log<Triangulation> log;
    const auto way = starting_path(t_, from, to, find_, &log, counts, np);
    side.search = way.status;
    side.initial_length = way.length;
    Status status = way.status;
    if (!way.halfedges.empty()) status = shorten(way.halfedges, false, log, side, counts, np);
    take_back(log);
    return status;
  }

  // Shortens a curve of consecutive sides with fixed ends, or a loop as a whole, to a geodesic in
  // the same class of curves. `stalled` if the curve crosses itself.
  // \param np those of `shorten_curves()`
  template <class NamedParameters = parameters::Parameters<>>
  Status join(const std::vector<Side>& sides, bool is_loop, Side& joined, Shortening_result& counts,
              const NamedParameters& np = parameters::default_values()) {
    Flip_log<Triangulation> log;
    Curve_inserter<Triangulation, false> inserter(t_, &log);
    Status status = Status::stalled;
    Side result{sides.front().from, sides.back().to, {}};
    if (insert(sides, inserter))
      status = shorten(inserter.path(), is_loop, log, result, counts, np);
    joined = std::move(result);
    take_back(log);
    return status;
  }

private:
  void take_back(Flip_log<Triangulation>& log) {
    network_.clear();
    typename Triangulation::Session session(t_);
    log.undo(session);
  }

  static bool insert(const std::vector<Side>& sides,
                     Curve_inserter<Triangulation, false>& inserter) {
    for (const Side& s : sides)
      if (inserter.insert(s.way, s.from, s.to) != Move_status::done) return false;
    return true;
  }

  template <class NamedParameters>
  Status shorten(const std::vector<typename Triangulation::halfedge_descriptor>& way, bool is_loop,
                 Flip_log<Triangulation>& log, Side& joined, Shortening_result& counts,
                 const NamedParameters& np) {
    if (way.empty()) return Status::done;
    try {
      is_loop ? network_.add_loop(way) : network_.add_path(way);
    } catch (const Invalid_input&) {
      return Status::stalled;
    }
    const Shortening_result r = internal::shorten_curves(network_, &log, np);
    counts += r;
    const auto halfedges = network_.halfedges(0);
    joined.from = network_.start(0);
    joined.to = halfedges.empty() ? joined.from : target(halfedges.back(), t_.mesh());
    joined.way = trace_curve(t_, halfedges);
    return r.status != Status::done ? r.status : joined.way.status;
  }

  Triangulation& t_;
  Edge_path_finder<Triangulation> find_;
  Curve_network<Triangulation> network_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_QUERIES_LONE_CURVE_FINDER_H
