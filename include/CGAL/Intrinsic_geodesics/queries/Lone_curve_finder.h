// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_QUERIES_LONE_CURVE_FINDER_H
#define CGAL_INTRINSIC_GEODESICS_QUERIES_LONE_CURVE_FINDER_H

#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_geodesics/queries/Curve_inserter.h>
#include <CGAL/Intrinsic_geodesics/queries/starting_path.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/connectivity/parameters.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Flip_log.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Shortening_result.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Move_status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A geodesic over the input, with its ends.
template <class Triangulation>
struct Curve_side {
  typename Triangulation::vertex_descriptor from, to;
  Traced_curve way;
  Status search = Status::done; // `inaccurate` if the search for the shortest path gave up
  double initial_length = 0;    // of what it was made of
};

// Finds geodesics, each alone on the surface, and leaves the triangulation as it was.
template <class Triangulation>
class Lone_curve_finder {
  using Vertex = typename Triangulation::vertex_descriptor;
  using Side = Curve_side<Triangulation>;

public:
  explicit Lone_curve_finder(Triangulation& t) : t_(t), find_(t), network_(t) {}

  // A shortest path between any copies of two vertices, which become the ends of the side; where
  // the search for that gives up, another geodesic.
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

  // What a curve of sides, each from the end of the one before, is shortened to while its ends
  // stay; a loop as a whole. The result is
  // a geodesic in the same class of curves. `stalled` if the curve crosses itself.
  Status join(const std::vector<Side>& sides, bool is_loop, Side& joined,
              Shortening_result& counts) {
    Flip_log<Triangulation> log;
    Curve_inserter<Triangulation, false> inserter(t_, &log);
    Status status = Status::stalled;
    Side result{sides.front().from, sides.back().to, {}};
    if (insert(sides, inserter))
      status = shorten(inserter.path(), is_loop, log, result, counts, parameters::default_values());
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
