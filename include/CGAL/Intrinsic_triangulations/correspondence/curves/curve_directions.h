// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CURVE_DIRECTIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CURVE_DIRECTIONS_H

#include <CGAL/Intrinsic_triangulations/correspondence/Edge_path.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Crossing_parameters.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/CurveCoordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Input_locator.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/trace_by_curves.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <type_traits>
#include <vector>

/*!
\file
Directions at vertices, by correspondences that store none: the integers tell the sector, the input's geometry
the angle within it. The error does not grow with the number of moves.
*/

namespace CGAL::Intrinsic_triangulations::internal {

// The point of the first input face of a halfedge that starts between two input halfedges: where it
// leaves that face, or its end. The halfedge crosses the input halfedges `entered`, from that with
// the number 2e; `first` is the side of the face that starts at its source.
template <class View, CurveCoordinates Coordinates>
Surface_point end_in_first_face(const View& view, const Coordinates& coordinates, std::uint32_t h,
                                const std::vector<std::uint32_t>& entered, std::uint32_t first) {
  const std::uint32_t even = h & ~1U;
  const auto& input = coordinates.input();
  if (entered.empty())
    return seen_from(input, corner_on_input(coordinates, h ^ 1U, view.target(h)), first);
  Edge_strip strip(input);
  strip.unfold(corner_on_input(coordinates, even, view.source(even)),
               corner_on_input(coordinates, even ^ 1U, view.target(even)), entered);
  // the weight of the end of the side that `first` points to
  if (h == even) return {first, {0, strip.parameter(0), 1 - strip.parameter(0)}};
  const double last = strip.parameter(entered.size() - 1);
  return {first, {0, 1 - last, last}};
}

// The direction of an intrinsic halfedge that starts at a vertex of the input: from an input halfedge there.
template <class Triangulation, CurveCoordinates Coordinates>
Corner_direction direction_on_input(const Triangulation& t, const Coordinates& coordinates,
                                    std::uint32_t h) {
  const Intrinsic_view<Triangulation> view(t);
  const auto& input = coordinates.input();
  const std::uint32_t after = coordinates.fans().halfedge(coordinates.roundabout(h));
  if (coordinates.normal_coordinate(h / 2) < 0) return {after, 0};
  const std::uint32_t first = input.next(after ^ 1U); // before `h`, counterclockwise
  const Surface_point p =
      end_in_first_face(view, coordinates, h, entered_on(t, coordinates, h / 2), first);
  const Planar_vector<double> back = Geodesic_face(input, first).to_corner(p.weights, 0);
  return {first, std::atan2(std::max(0.0, -back[1]), -back[0])};
}

// The angle of an intrinsic halfedge that starts at an inserted vertex, in the frame of the input face of
// `start`, which becomes its source.
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
  start = corner_on_input(coordinates, h, view.source(h));
  const Surface_point end = corner_on_input(coordinates, h ^ 1U, view.target(h));
  std::vector<std::uint32_t> entered = entered_on(t, coordinates, h / 2);
  if (entered.empty()) {
    const Planar_vector<double> v = vector_between(input, start, end);
    return std::atan2(v[1], v[0]);
  }
  if (h % 2 != 0) {
    std::reverse(entered.begin(), entered.end());
    for (std::uint32_t& g : entered) g ^= 1U;
  }
  Edge_strip strip(input);
  strip.unfold(start, end, entered);
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

// The direction of an input halfedge among the intrinsic halfedges at its source; none if the coordinates are
// not those of the triangulation.
template <class Triangulation, CurveCoordinates Coordinates>
std::optional<Corner_direction>
direction_on_intrinsic(const Triangulation& t, const Coordinates& coordinates, std::uint32_t x) {
  const Intrinsic_view<Triangulation> view(t);
  const auto start = find_curve(view, coordinates, coordinates.input().source(x), x);
  if (!start) return std::nullopt;
  if (start->index < 0) return Corner_direction{start->halfedge, 0};
  const Curve_strip strip(view, coordinates, sides_of_face(view, start->halfedge),
                          first_crossing(view, coordinates, *start));
  const std::vector<Point> points = strip.unfold_approximately(view);
  const Point d = points[strip.last()] - points[strip.first()];
  return Corner_direction{start->halfedge, std::atan2(std::max(0.0, d.y), d.x)};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CURVE_DIRECTIONS_H
