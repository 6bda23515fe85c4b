// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_QUERIES_ADD_GEODESICS_H
#define CGAL_INTRINSIC_GEODESICS_QUERIES_ADD_GEODESICS_H

#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_geodesics/queries/Curve_inserter.h>
#include <CGAL/Intrinsic_geodesics/queries/Lone_curve_finder.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Segment_flipper.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a geodesic along edges of a triangulation.
\tparam Triangulation the type of the triangulation
*/
template <GeodesicTriangulation Triangulation>
struct Inserted_geodesic {
  /// That of `shorten_curves()`; `stalled` if no path exists; `inaccurate`: it is geodesic, but the
  /// search for the shortest one gave up, see `Shortest_path`.
  Status status = Status::done;
  /// Its edges, in its direction. On a cover, an edge may start at another copy of the vertex where
  /// the one before ends.
  std::vector<typename Triangulation::halfedge_descriptor> halfedges;
};

/*!
\brief flips edges until a shortest path between two vertices is a path of edges (§4.4 of the
course).

Most paths are one edge; those through vertices have several. To keep the path in later flips,
constrain its edges.
\tparam Triangulation a model of `GeodesicTriangulation`
\param t the triangulation
\param from, to vertices of it; see `vertex_on_intrinsic()` and `insert_point()`. On a cover, the
shortest path between any copies of them is found
\param np named parameters of `shorten_curves()`, and:
  - `shortest(b)`: if false, the path starts as a shortest one along edges, see `Geodesic_finder`.
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

/*!
\brief is a curve to add: shortest paths from each vertex to the next one.
\tparam Triangulation the type of the triangulation
*/
template <GeodesicTriangulation Triangulation>
struct Curve_through_vertices {
  /// The vertices, at least two; consecutive ones differ. On a cover, a side is a shortest path
  /// between any copies of its ends; where the next one starts from another copy, the curve cannot
  /// move.
  std::vector<typename Triangulation::vertex_descriptor> vertices;
  /// Whether it goes on from the last vertex to the first one.
  bool is_loop = false;
  /// Whether it stays at all of its vertices; else only at its ends.
  bool stays_at_vertices = false;
};

/*!
\brief is the result of `add_geodesics()`.
\tparam Triangulation the type of the triangulation
*/
template <GeodesicTriangulation Triangulation>
struct Added_geodesics {
  /// `done`; `stalled` if vertices are not connected, or the insertion at a crossing fails; or the
  /// status of `shorten_curves()`. If it is not `done`, the network is empty.
  Status status = Status::done;
  /// The curve where it failed.
  std::size_t failed = 0;
  /// The initial shortest paths of each curve; `inaccurate` if a search gave up, and they may be
  /// longer.
  std::vector<Traced_curve> initial;
  /// Vertices where curves cross. They are fixed.
  std::vector<typename Triangulation::vertex_descriptor> crossings;
  /// What was done.
  Shortening_result shortening;
};

namespace internal {

// Fixes the vertices of curves that stay there, and ends that several curves have: junctions.
template <class Triangulation>
void fix_junctions(Curve_network<Triangulation>& network,
                   const std::vector<Curve_through_vertices<Triangulation>>& curves) {
  std::map<std::uint32_t, int> ends;
  for (const Curve_through_vertices<Triangulation>& c : curves) {
    if (c.stays_at_vertices)
      for (const auto v : c.vertices) network.fix(v);
    if (c.is_loop) continue;
    for (const auto v : {c.vertices.front(), c.vertices.back()})
      if (++ends[network.triangulation().index(v)] > 1) network.fix(v);
  }
}

// Finds curves one by one, and makes them edges.
// \tparam NP with the visitor, if there is one
template <class Triangulation, class NP>
class Geodesics_adder {
  using Vertex = typename Triangulation::vertex_descriptor;
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Curve = Curve_through_vertices<Triangulation>;
  using Sides = std::vector<Curve_side<Triangulation>>;

public:
  Geodesics_adder(Curve_network<Triangulation>& network, Flip_log<Triangulation>* log, const NP& np)
      : t_(network.triangulation()), network_(network), log_(log), np_(np), finder_(t_),
        inserter_(t_, log) {}

  Added_geodesics<Triangulation> run(const std::vector<Curve>& curves) {
    for (const Curve& c : curves) {
      if (!find(c)) return fail();
      ++result_.failed;
    }
    result_.failed = 0;
    for (const Sides& sides : found_) {
      if (result_.failed > 0) inserter_.begin_path();
      for (const Curve_side<Triangulation>& s : sides)
        if (inserter_.insert(s.way, s.from, s.to) != Move_status::done) return fail();
      ++result_.failed;
    }
    for (std::size_t i = 0; i < curves.size(); ++i) add(curves[i], i);
    const Shortening_result r = internal::shorten_curves(network_, log_, np_);
    result_.shortening += r;
    result_.status = r.status;
    return result_;
  }

private:
  Added_geodesics<Triangulation> fail() {
    if (result_.status == Status::done) result_.status = Status::stalled;
    return result_;
  }

  bool find(const Curve& c) {
    Sides sides;
    Traced_curve initial;
    const std::size_t n = c.vertices.size();
    for (std::size_t i = 0; i + (c.is_loop ? 0 : 1) < n; ++i) {
      Curve_side<Triangulation> side;
      result_.status = finder_.find(i == 0 ? c.vertices[0] : sides.back().to,
                                    c.vertices[(i + 1) % n], side, result_.shortening, np_);
      if (result_.status != Status::done) return false;
      append(side.way, initial);
      if (side.search != Status::done) initial.status = side.search;
      sides.push_back(std::move(side));
    }
    result_.initial.push_back(std::move(initial));
    if (!c.stays_at_vertices && (c.is_loop || n > 2)) straighten(c, sides);
    found_.push_back(std::move(sides));
    return result_.status == Status::done;
  }

  // One side after the other: two geodesics that meet cross less often than all sides. If they
  // do, the sides stay as they are for
  // now: they are shortened with their crossings fixed.
  void straighten(const Curve& c, Sides& sides) {
    Sides joined{sides.front()};
    for (std::size_t i = 1; i < sides.size(); ++i) {
      joined.push_back(sides[i]);
      const bool is_loop = c.is_loop && i + 1 == sides.size();
      Curve_side<Triangulation> both;
      const Status status = finder_.join(joined, is_loop, both, result_.shortening, np_);
      if (status == Status::cancelled) result_.status = status;
      if (status != Status::done) return;
      joined = {std::move(both)};
    }
    sides = std::move(joined);
  }

  void add(const Curve& c, std::size_t i) {
    if (c.stays_at_vertices)
      for (const Curve_side<Triangulation>& s : found_[i])
        for (const Vertex v : {s.from, s.to}) network_.fix(v);
    auto way = inserter_.path(i);
    if (way.empty()) way = there_and_back(found_[i].front().from);
    const auto crossings = add_crossing_curve(network_, way, c.is_loop);
    result_.crossings.insert(result_.crossings.end(), crossings.begin(), crossings.end());
  }

  // a way that has contracted to a vertex
  std::vector<Halfedge> there_and_back(Vertex v) const {
    Halfedge out = opposite(halfedge(v, t_.mesh()), t_.mesh());
    for_each_outgoing(v, t_.mesh(), [&](Halfedge h) {
      if (!network_.is_fixed(target(h, t_.mesh()))) out = h;
    });
    return {out, opposite(out, t_.mesh())};
  }

  Triangulation& t_;
  Curve_network<Triangulation>& network_;
  Flip_log<Triangulation>* log_;
  const NP& np_;
  Lone_curve_finder<Triangulation> finder_;
  Curve_inserter<Triangulation> inserter_;
  std::vector<Sides> found_;
  Added_geodesics<Triangulation> result_;
};

// \param log remembers flips, but not the vertices that are inserted where curves cross
template <class Triangulation>
Added_geodesics<Triangulation>
find_and_add(Curve_network<Triangulation>& network,
             const std::vector<Curve_through_vertices<Triangulation>>& curves,
             Flip_log<Triangulation>* log, Any_shortening_visitor& visitor) {
  const auto np = parameters::visitor(std::ref(visitor));
  return Geodesics_adder<Triangulation, std::remove_const_t<decltype(np)>>(network, log, np)
      .run(curves);
}

// see `Intrinsic_triangulations::add_geodesics()`
template <class Triangulation, class NP>
Added_geodesics<Triangulation>
add_geodesics(Curve_network<Triangulation>& network,
              const std::vector<Curve_through_vertices<Triangulation>>& curves,
              Flip_log<Triangulation>* log, const NP& np) {
  expect_names<tags::visitor>(np);
  auto stored_visitor = object_or<tags::visitor>(np, Shortening_visitor());
  auto& observed = unwrapped(stored_visitor);
  Any_shortening_visitor visitor{[&](const Shortening_result& r) { return observed.progress(r); }};
  return find_and_add(network, curves, log, visitor);
}

} // namespace internal

/*!
\brief finds geodesics through vertices, each alone on the surface, and adds all to a network.

The *sides* of a curve are shortest paths from each of its vertices to the next. A curve that stays
at its vertices consists of them. For any other curve, the sides are shortened, without regard to
other curves: the vertices between its ends only choose its way around handles, holes and peaks. A
fixed vertex is inserted at each crossing of curves.

In contrast, `shorten_curves()` alone never moves a curve across another.
\tparam Triangulation a model of `GeodesicTriangulation`, of `RefinableTriangulation` and of
  `CorrespondingTriangulation`
\param network a network without curves; its fixed vertices stay fixed
\param curves the curves to add; the network numbers them in this order
\param np an optional named parameter, `visitor(v)`: see `Shortening_visitor`
\return the result \complexity that of shortest paths, see `Geodesic_finder`, and of
`shorten_curves()`
*/
template <GeodesicTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
  requires RefinableTriangulation<Triangulation> Added_geodesics<Triangulation>
  add_geodesics(Curve_network<Triangulation>& network,
                const std::vector<Curve_through_vertices<Triangulation>>& curves,
                const NP& np = parameters::default_values()) {
    return internal::add_geodesics(network, curves, static_cast<Flip_log<Triangulation>*>(nullptr),
                                   np);
  }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_QUERIES_ADD_GEODESICS_H
