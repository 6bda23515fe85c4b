// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_BEZIER_MAKE_BEZIER_CURVE_H
#define CGAL_INTRINSIC_GEODESICS_BEZIER_MAKE_BEZIER_CURVE_H

#include <CGAL/Intrinsic_geodesics/bezier/bezier_point.h>
#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_geodesics/curves/insert_point.h>
#include <CGAL/Intrinsic_geodesics/queries/Curve_inserter.h>
#include <CGAL/Intrinsic_geodesics/queries/Lone_curve_finder.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Segment_flipper.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a geodesic Bezier curve: the control polygon after some rounds of subdivision, along edges
  of an intrinsic triangulation.
\tparam Triangulation a model of `GeodesicTriangulation`
*/
template <GeodesicTriangulation Triangulation>
struct Bezier_curve {
  /// `done`; `stalled` if control points are not connected or a vertex cannot be inserted; or the
  /// status of `Geodesic_finder`. There is a curve only if it is `done`.
  Status status = Status::done;
  /// Number of rounds.
  unsigned rounds = 0;
  /// Degree d of the curve.
  std::size_t degree = 0;
  /// Control points after all rounds, d 2^rounds + 1. Number k d is on the curve, at k / 2^rounds.
  std::vector<typename Triangulation::vertex_descriptor> control_points;
  /// The way from the first control point to the last one, through all of them, along edges. It may
  /// cross itself.
  std::vector<typename Triangulation::halfedge_descriptor> halfedges;
  /// Vertices where it crosses itself, without control points. Fix both in a network.
  std::vector<typename Triangulation::vertex_descriptor> crossings;
  /// Length of the control polygon, in the units of the input.
  double length = 0;
  /// The counts of the shortening of its sides.
  Shortening_result shortening;
};

namespace internal {

// Subdivides the control polygon of a curve by geodesics (§5.3 of the course; Morera et al.
// 2008): a round makes two polygons of each, which share its point at 1/2, by de Casteljau's
// triangle of midpoints. The line from a midpoint to the next one is not a new shortest path: it is
// the way along the two halves, made geodesic. So it changes continuously with the control points;
// a shortest path does not.
//
// Each line is found alone and stored over the input. Only at the end all lines become edges of one
// triangulation.
template <class Triangulation>
class Bezier_subdivider {
  using Vertex = typename Triangulation::vertex_descriptor;
  using Side = Curve_side<Triangulation>;
  using Sides = std::vector<Side>;

public:
  explicit Bezier_subdivider(Triangulation& t) : t_(t), finder_(t) {}

  // The sides of the control polygon are shortest paths.
  Status start(const std::vector<Vertex>& control_points, Shortening_result& counts) {
    flip_to_delaunay(t_);
    for (std::size_t i = 0; i + 1 < control_points.size(); ++i) {
      Side side;
      const Status s = finder_.find(control_points[i], control_points[i + 1], side, counts);
      if (s != Status::done) return s;
      sides_.push_back(std::move(side));
    }
    return Status::done;
  }

  // makes two polygons of each one that has `degree` sides
  Status subdivide(std::size_t degree, Shortening_result& counts) {
    Sides all;
    for (std::size_t i = 0; i < sides_.size(); i += degree) {
      const auto first = sides_.begin() + static_cast<std::ptrdiff_t>(i);
      const Status s =
          subdivide(Sides(first, first + static_cast<std::ptrdiff_t>(degree)), all, counts);
      if (s != Status::done) return s;
    }
    sides_ = std::move(all);
    remove_unused_midpoints();
    return Status::done;
  }

  double length() const {
    double sum = 0;
    for (const Side& s : sides_) sum += s.way.length;
    return sum;
  }

  // makes the sides edges, and writes the curve
  Status finish(Bezier_curve<Triangulation>& curve) {
    curve.control_points.assign(1, sides_.front().from);
    Curve_inserter<Triangulation> inserter(t_);
    for (const Side& s : sides_) {
      if (inserter.insert(s.way, s.from, s.to) != Move_status::done) return Status::stalled;
      curve.control_points.push_back(s.to);
    }
    curve.length = 0;
    if (inserter.path().empty()) return Status::done;
    Curve_network<Triangulation> network(t_);
    for (const Vertex v : curve.control_points) network.fix(v);
    curve.crossings = add_crossing_curve(network, inserter.path(), false);
    const Shortening_result r = shorten_curves(network);
    curve.shortening += r;
    curve.halfedges = network.halfedges(0);
    curve.length = network.length();
    return r.status;
  }

private:
  // Up to rounding, they lie on lines that become edges later.
  void remove_unused_midpoints() {
    std::unordered_set<std::uint32_t> used;
    for (const Side& s : sides_) used.insert(t_.index(s.to));
    std::vector<Vertex> kept;
    for (const Vertex v : midpoints_)
      if (used.count(t_.index(v)) != 0 || t_.remove_vertex(v) != Move_status::done)
        kept.push_back(v);
    midpoints_ = std::move(kept);
    flip_to_delaunay(t_); // points are located less accurately in thin faces
  }

  // One polygon becomes two, with de Casteljau's triangle between them.
  Status subdivide(Sides inner, Sides& all, Shortening_result& counts) {
    Sides right; // from the last one back
    while (!inner.empty()) {
      Sides halves;
      for (const Side& s : inner)
        if (!bisect(s, halves)) return Status::stalled;
      all.push_back(std::move(halves.front()));
      right.push_back(std::move(halves.back()));
      inner.clear();
      for (std::size_t k = 1; k + 1 < halves.size(); k += 2) {
        Side side;
        const Status s = join(halves[k], halves[k + 1], side, counts);
        if (s != Status::done) return s;
        inner.push_back(std::move(side));
      }
    }
    all.insert(all.end(), std::make_move_iterator(right.rbegin()),
               std::make_move_iterator(right.rend()));
    return Status::done;
  }

  // Halves that cross cannot be shortened together: a shortest path replaces them.
  Status join(const Side& first, const Side& second, Side& side, Shortening_result& counts) {
    const Status s = finder_.join({first, second}, false, side, counts);
    return s == Status::stalled ? finder_.find(first.from, second.to, side, counts) : s;
  }

  // The halves of a side, at the vertex in its middle, which is inserted if needed.
  bool bisect(const Side& side, Sides& halves) {
    const Traced_curve& way = side.way;
    if (way.faces.empty()) {
      halves.insert(halves.end(), {side, side});
      return true;
    }
    const Place_on_curve m = place_on_curve(t_.correspondence().input(), way, 0.5);
    const Vertex_at_point<Triangulation> v = insert_point(t_, m.point);
    if (v.status != Move_status::done) return false;
    if (v.is_new) midpoints_.push_back(v.vertex);
    const auto n = static_cast<std::ptrdiff_t>(m.piece) + 1;
    Traced_curve first, second;
    first.points.assign(way.points.begin(), way.points.begin() + n);
    first.points.push_back(m.point);
    first.faces.assign(way.faces.begin(), way.faces.begin() + n);
    second.points.assign(1, m.point);
    second.points.insert(second.points.end(), way.points.begin() + n, way.points.end());
    second.faces.assign(way.faces.begin() + n - 1, way.faces.end());
    first.length = second.length = way.length / 2;
    halves.push_back({side.from, v.vertex, std::move(first)});
    halves.push_back({v.vertex, side.to, std::move(second)});
    return true;
  }

  Triangulation& t_;
  Lone_curve_finder<Triangulation> finder_;
  Sides sides_;
  std::vector<Vertex> midpoints_; // that were inserted
};

} // namespace internal

/*!
\brief makes a geodesic Bezier curve (§5.3 of the course) of any degree among the edges of an
  intrinsic triangulation.

The sides of the control polygon are shortest paths. Each round subdivides it: de Casteljau's
algorithm at 1/2, with midpoints of geodesics, makes two polygons of each, which share the point in
the middle. The polygon converges to the curve. Halves of two sides are shortened to a geodesic; new
shortest paths, and so the curve, could jump from one side of a bump to the other. A shortest path
replaces two halves only if they cross.

Each geodesic is found alone on the surface: no other line blocks it. So in a convex flat part all
control points are those of the plane. At the end the sides of the last polygon become edges, with
new vertices where the polygon crosses itself.

All edges are flipped to Delaunay before and between rounds. Midpoints are inserted as vertices at
half of the length, as a double; exact traits round them as in
`Intrinsic_triangulation::insert_vertex()`. `is_geodesic()` and `certify_geodesic()` decide exactly
whether the sides between them are geodesics, once the control points and `Bezier_curve::crossings`
are fixed in a network.

\tparam Triangulation a model of `GeodesicTriangulation`, of `RefinableTriangulation` and of
  `CorrespondingTriangulation`
\tparam NP a chain of named parameters
\param t the triangulation; vertices are inserted, and edges flipped
\param control_points vertices, two at least
\param np optional named parameters:
  - `maximum_rounds(n)`: number of rounds. Default: 5.
  - `tolerance(x)`: stops when a round shortens the control polygon by at most x, in the units of
    the input. Default: 0.
\return the curve
\throws std::invalid_argument if there are less than two control points
\complexity that of d shortest paths, of `flip_to_delaunay()` r + 1 times for r rounds, and d
  (d - 1) / 2 times 2^r - 1 that of `shorten_curves()`
*/
template <GeodesicTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
  requires RefinableTriangulation<Triangulation> Bezier_curve<Triangulation>
  make_bezier_curve(Triangulation& t,
                    const std::vector<typename Triangulation::vertex_descriptor>& control_points,
                    const NP& np = parameters::default_values()) {
    namespace tags = internal::tags;
    internal::expect_names<tags::maximum_rounds, tags::tolerance>(np);
    if (control_points.size() < 2)
      throw std::invalid_argument("a Bezier curve needs two control points at least");
    const unsigned rounds = internal::value_or<tags::maximum_rounds>(np, 5U);
    const double tolerance = internal::value_or<tags::tolerance>(np, 0.);
    Bezier_curve<Triangulation> curve;
    curve.degree = control_points.size() - 1;
    internal::Bezier_subdivider<Triangulation> subdivider(t);
    curve.status = subdivider.start(control_points, curve.shortening);
    while (curve.status == Status::done && curve.rounds < rounds) {
      const double before = subdivider.length();
      curve.status = subdivider.subdivide(curve.degree, curve.shortening);
      if (curve.status != Status::done) break;
      ++curve.rounds;
      if (before - subdivider.length() <= tolerance) break;
    }
    if (curve.status == Status::done) curve.status = subdivider.finish(curve);
    if (curve.status != Status::done) {
      curve.control_points.clear();
      curve.halfedges.clear();
    }
    return curve;
  }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_BEZIER_MAKE_BEZIER_CURVE_H
