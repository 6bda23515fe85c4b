// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_CURVE_QUERIES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_CURVE_QUERIES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Edge_path.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Edge_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Intrinsic_locator.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Unfolded_face.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The path of intrinsic halfedge 2e over the input.
template <class Triangulation, CurveCoordinates Coordinates>
Edge_path trace_edge_by_curves(const Triangulation& t, const Coordinates& coordinates,
                               std::uint32_t edge) {
  const Intrinsic_view<Triangulation> view(t);
  const auto& input = coordinates.input();
  const std::uint32_t h = 2 * edge;
  Edge_path path;
  const auto add = [&](const Surface_point& p, double x) {
    path.points.push_back({p, point_on_halfedge(view, h, x), x});
  };
  if (coordinates.normal_coordinate(edge) < 0) {
    const std::uint32_t g = path.along = coordinates.fans().halfedge(coordinates.roundabout(h));
    for (const double x : {0., 1.})
      add(point_on_halfedge(input, g, location_on_side(view, coordinates, h, x).weights[1]), x);
    return path;
  }
  const std::vector<std::uint32_t> entered = find_entered(view, coordinates, h);
  Edge_strip strip(input);
  if (!entered.empty()) strip.unfold(view, coordinates, h, entered);
  path.points.reserve(entered.size() + 2);
  add(corner_on_input(view, coordinates, h), 0);
  double last = 0;
  for (std::size_t i = 0; i < entered.size(); ++i) {
    const double x = strip.parameter(i);
    last = std::max(last, strip.along(i, x)); // keeps the order despite rounding
    add({entered[i], {1 - x, x, 0}}, last);
  }
  add(corner_on_input(view, coordinates, h ^ 1U), 1);
  return path;
}

// Adds the crossings of a part of an input halfedge, which follows a strip, with intrinsic edges.
template <class View, class Add>
void add_crossings_of_strip(const View& view, const Curve_strip& strip, const Add& add) {
  const std::vector<Point> z = strip.develop(view);
  const Straight_line line{z.front(), z.back()};
  for (std::size_t n = 1; n < strip.faces.size(); ++n) {
    const Development<>::Triangle& t = strip.faces[n];
    const Point &a = z[t.point[0]], &b = z[t.point[1]];
    const double x = line.parameter(a, b);
    add({t.side, {1 - x, x, 0}}, line.along(a + x * (b - a)));
  }
}

// The path of an input halfedge over the intrinsic triangulation: part by part, between the
// vertices inserted on it.
template <class Triangulation, CurveCoordinates Coordinates>
Edge_path trace_input_edge_by_curves(const Triangulation& t, const Coordinates& coordinates,
                                     std::uint32_t x) {
  const Intrinsic_view<Triangulation> view(t);
  const auto& input = coordinates.input();
  Edge_path path;
  std::uint32_t vertex = input.source(x), parts = 0;
  double from = 0;
  for (bool is_at_end = false; !is_at_end; ++parts) {
    const std::optional<Curve_end> start = find_curve(view, coordinates, vertex, x);
    if (!start) return {Status::not_traceable, Gluing::none, {}};
    std::optional<Curve_strip> strip;
    if (start->index >= 0) strip.emplace(view, coordinates, *start);
    const std::uint32_t h = start->halfedge;
    vertex = strip ? view.source(strip->end.halfedge) : view.target(h);
    is_at_end = !coordinates.is_inserted(vertex);
    const double to = parameter_on_halfedge(coordinates, vertex, x, false);
    double last = from;
    const auto add = [&](const Surface_point& p, double along) {
      last = std::max(last, from + along * (to - from));
      path.points.push_back({point_on_halfedge(input, x, last), p, last});
    };
    if (parts == 0) add(point_on_halfedge(view, h, 0), 0);
    if (strip) add_crossings_of_strip(view, *strip, add);
    add(strip ? Surface_point{strip->end.halfedge, {1, 0, 0}} : point_on_halfedge(view, h, 1), 1);
    path.along = !strip && parts == 0 && is_at_end ? h : Gluing::none;
    from = to;
  }
  return path;
}

// ---- Directions at vertices: the integers give the sector, the geometry of the input gives the
// angle within it; its error does not grow with the number of moves

// The direction of an intrinsic halfedge that starts at a vertex of the input: from an input
// halfedge there.
template <class Triangulation, CurveCoordinates Coordinates>
Corner_direction direction_on_input(const Triangulation& t, const Coordinates& coordinates,
                                    std::uint32_t h) {
  const Intrinsic_view<Triangulation> view(t);
  const auto& input = coordinates.input();
  const std::uint32_t after = coordinates.fans().halfedge(coordinates.roundabout(h));
  if (coordinates.normal_coordinate(h / 2) < 0) return {after, 0};
  const std::uint32_t first = input.next(after ^ 1U); // before `h`, counterclockwise
  const std::vector<std::uint32_t> entered = find_entered(view, coordinates, h);
  Surface_point p = corner_on_input(view, coordinates, h ^ 1U); // in that face, or beyond it
  if (entered.empty()) {
    p = seen_from(input, p, first);
  } else {
    Edge_strip strip(input);
    strip.unfold(view, coordinates, h, entered);
    p = {first, {0, strip.parameter(0), 1 - strip.parameter(0)}};
  }
  const Plane_vector<double> v = Geodesic_face(input, first).position(p.weights);
  return {first, std::atan2(std::max(0.0, v[1]), v[0])};
}

// The angle of an intrinsic halfedge that starts at an inserted vertex, in the frame of the input
// face of `start`, which becomes its source.
template <class Triangulation, CurveCoordinates Coordinates>
double angle_at_inserted_vertex(const Triangulation& t, const Coordinates& coordinates,
                                std::uint32_t h, Surface_point& start) {
  const Intrinsic_view<Triangulation> view(t);
  const auto& input = coordinates.input();
  if (coordinates.normal_coordinate(h / 2) < 0) {
    const std::uint32_t g = coordinates.fans().halfedge(coordinates.roundabout(h));
    start =
        point_on_halfedge(input, g, parameter_on_halfedge(coordinates, view.source(h), g, true));
    return start.halfedge == g ? 0 : std::numbers::pi;
  }
  start = corner_on_input(view, coordinates, h);
  const std::vector<std::uint32_t> entered = find_entered(view, coordinates, h);
  if (entered.empty()) {
    const Unscaled_vector v =
        vector_between(input, start, corner_on_input(view, coordinates, h ^ 1U));
    return std::atan2(v[1], v[0]);
  }
  Edge_strip strip(input);
  strip.unfold(view, coordinates, h, entered);
  start = seen_from(input, start,
                    entered.front() ^ 1U); // whose frame is half a turn from that of the strip
  return std::atan2(-strip.vector().y, -strip.vector().x);
}

// Starts a geodesic on the input from the source of an intrinsic halfedge, at an angle from it.
template <class Triangulation, CurveCoordinates Coordinates>
auto walk_by_curves(const Triangulation& t, const Coordinates& coordinates, std::uint32_t h,
                    double turn) {
  const auto& input = coordinates.input();
  using Walk = Geodesic_walk<std::remove_cvref_t<decltype(input)>>;
  if (!coordinates.is_inserted(Intrinsic_view<Triangulation>(t).source(h))) {
    const Corner_direction d = direction_on_input(t, coordinates, h);
    return Walk(input, Corner_direction{d.halfedge, d.angle + turn});
  }
  Surface_point start;
  const double angle = angle_at_inserted_vertex(t, coordinates, h, start) + turn;
  return Walk(input, start, {std::cos(angle), std::sin(angle)});
}

// The direction of an input halfedge among the intrinsic halfedges at its source; none if the
// coordinates are not those of the triangulation.
template <class Triangulation, CurveCoordinates Coordinates>
std::optional<Corner_direction>
direction_on_intrinsic(const Triangulation& t, const Coordinates& coordinates, std::uint32_t x) {
  const Intrinsic_view<Triangulation> view(t);
  const auto start = find_curve(view, coordinates, coordinates.input().source(x), x);
  if (!start) return std::nullopt;
  if (start->index < 0) return Corner_direction{start->halfedge, 0};
  const Point d = Curve_strip(view, coordinates, *start).develop(view).back(); // from 0
  return Corner_direction{start->halfedge, std::atan2(std::max(0.0, d.y), d.x)};
}

} // namespace internal

/*!
\brief answers all queries of a correspondence, by curves.

A correspondence that does not model `CurveCoordinates` has a member template `queries(t)`, which
returns an object with the same functions: `locate_on_input()` and all other queries use it.
\tparam Triangulation an `Intrinsic_triangulation`
\tparam Coordinates a model of `CurveCoordinates`
*/
template <NumberedTriangulation Triangulation, CurveCoordinates Coordinates>
class Curve_queries {
public:
  /// refers to a triangulation and to its coordinates on the input.
  Curve_queries(const Triangulation& t, const Coordinates& curves) : t_(t), curves_(curves) {}

  /// returns the point of the input at a point of the triangulation, if found.
  std::optional<Mapped_point> on_input(const Surface_point& p) const {
    Unfolded_face<double> face;
    face.unfold(Intrinsic_view<Triangulation>(t_), curves_, p.halfedge,
                approximate_values(curves_.input()));
    return face.locate(p.weights);
  }
  /// returns the point of the triangulation at a point of the input, if found.
  std::optional<Mapped_point> on_intrinsic(const Surface_point& p) const {
    return internal::Intrinsic_locator<Triangulation, Coordinates>(t_, curves_).locate(p);
  }
  /// returns the path of halfedge `2 * edge` of the triangulation over the input.
  Edge_path path_on_input(std::uint32_t edge) const {
    return internal::trace_edge_by_curves(t_, curves_, edge);
  }
  /// returns the path of halfedge `x` of the input over the triangulation.
  Edge_path path_on_intrinsic(std::uint32_t x) const {
    return internal::trace_input_edge_by_curves(t_, curves_, x);
  }
  /// returns the edge of the input along which an edge of the triangulation runs, or none.
  std::uint32_t input_edge_along(std::uint32_t edge) const {
    if (curves_.normal_coordinate(edge) >= 0) return Gluing::none;
    return curves_.fans().halfedge(curves_.roundabout(2 * edge)) / 2;
  }
  /// starts a geodesic on the input from the source of a halfedge of the triangulation, at an angle
  /// from it.
  internal::Geodesic_walk<Input> walk_on_input(std::uint32_t h, double turn) const {
    return internal::walk_by_curves(t_, curves_, h, turn);
  }
  /// returns the direction on the triangulation at an angle from halfedge `x` of the input, at its
  /// source.
  std::optional<Corner_direction> direction_on_intrinsic(std::uint32_t x, double turn) const {
    auto direction = internal::direction_on_intrinsic(t_, curves_, x);
    if (direction) direction->angle += turn;
    return direction;
  }
  /// returns the coordinates for a common subdivision.
  const Coordinates& curves() const { return curves_; }

private:
  const Triangulation& t_;
  const Coordinates& curves_;
};

namespace internal {

// The object that answers queries about a triangulation.
template <class Triangulation>
auto queries(const Triangulation& t) {
  if constexpr (QueriedCorrespondence<Correspondence_of<Triangulation>, Triangulation>)
    return t.correspondence().queries(t);
  else
    return Curve_queries(t, t.correspondence());
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_CURVE_QUERIES_H
