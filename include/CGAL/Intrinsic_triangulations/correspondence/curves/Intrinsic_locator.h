// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_INTRINSIC_LOCATOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_INTRINSIC_LOCATOR_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/formulas/Development.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

/*!
\file
Maps points of the input to points of the intrinsic triangulation, by integer coordinates.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// finds where a curve starts among the halfedges counterclockwise from `first`
template <class View, CurveCoordinates Coordinates>
std::optional<Curve_end> find_curve_around(const View& view, const Coordinates& coordinates,
                                           std::uint32_t first, std::uint32_t x) {
  for (std::uint32_t h = first;;) {
    const std::uint32_t slot = coordinates.roundabout(h);
    if (slot == Gluing::none) return std::nullopt;
    if (coordinates.normal_coordinate(h / 2) < 0 && coordinates.fans().halfedge(slot) == x)
      return Curve_end{h, -1};
    if (view.is_border(h)) return std::nullopt;
    const Normal_coordinate n = corner_coordinates(view, coordinates, h).emanating[0];
    for (Normal_coordinate i = 0; i < n; ++i)
      if (input_halfedge(coordinates, Curve_end{h, i}) == x) return Curve_end{h, i};
    h = view.next(view.next(h)) ^ 1U;
    if (h == first) return std::nullopt;
  }
}

} // namespace internal

/*!
\brief finds where a curve starts from a vertex.
\param view the intrinsic triangulation
\param coordinates its normal coordinates and roundabouts
\param vertex the vertex
\param x the input halfedge along which the curve runs
\return the corner from which it starts and the number of curves from there before it, -1 if it is
the first side itself; nothing if no curve along `x` starts there
\complexity linear in the degree of the vertex; where several fans of faces meet, linear
*/
template <NumberedComplex View, CurveCoordinates Coordinates>
std::optional<Curve_end> find_curve(const View& view, const Coordinates& coordinates,
                                    std::uint32_t vertex, std::uint32_t x) {
  const auto found =
      internal::find_curve_around(view, coordinates, view.outgoing_halfedge(vertex), x);
  if (found || coordinates.is_inserted(vertex)) return found;
  const auto& fans = coordinates.fans();
  const std::uint32_t in_fan = view.find_halfedge([&](std::uint32_t h) {
    const std::uint32_t slot = coordinates.roundabout(h);
    return slot != Gluing::none && view.source(h) == vertex &&
           fans.distance(slot, fans.slot(x)) != Gluing::none;
  });
  if (in_fan == Gluing::none) return std::nullopt;
  std::uint32_t first = in_fan; // or on the right border of the fan
  while (!view.is_border(first ^ 1U)) {
    first = view.next(first ^ 1U);
    if (first == in_fan) break;
  }
  return internal::find_curve_around(view, coordinates, first, x);
}

namespace internal {

/// A point of an intrinsic face, and the direction of its halfedge in the frame that the walk began
/// with.
struct Walked {
  Surface_point point;
  Plane_vector<double> direction; // not a unit vector
};

/// Finds the point of the intrinsic triangulation at a point of the input.
template <class Triangulation, CurveCoordinates Coordinates>
class Intrinsic_locator {
  using View = Intrinsic_view<Triangulation>;
  using Point = Plane_vector<double>;

public:
  Intrinsic_locator(const Triangulation& t, const Coordinates& coordinates)
      : view_(t), coordinates_(coordinates) {}

  /// finds a point of the input.
  std::optional<Mapped_point> locate(const Surface_point& p) const {
    // from the longest side on which the perpendicular through the point stands
    const auto& input = coordinates_.input();
    const Geodesic_face face(input, p.halfedge);
    std::array<unsigned, 3> sides{0, 1, 2};
    std::sort(sides.begin(), sides.end(), [&](unsigned a, unsigned b) {
      return input.squared_length(face.side[a] / 2) > input.squared_length(face.side[b] / 2);
    });
    for (const unsigned k : sides)
      if (const auto q = locate_from(face.side[k], seen_from(input, p, face.side[k]))) {
        const double length = std::hypot(q->direction.x, q->direction.y);
        return Mapped_point{
            q->point,
            face.from_relative_to(k, {1, 0}), // the side, and the same seen from there
            {q->direction.x / length, -q->direction.y / length}};
      }
    return std::nullopt;
  }

private:
  std::optional<Walked> locate_from(std::uint32_t x, const Surface_point& p) const {
    const Point apex = apex_above_side(coordinates_.input(), x);
    const Point point{p.weights[1] + p.weights[2] * apex.x, p.weights[2] * apex.y};
    std::uint32_t vertex = coordinates_.input().source(x);
    double from = 0;
    for (;;) { // over the parts of the input edge
      const std::optional<Curve_end> start = find_curve(view_, coordinates_, vertex, x);
      if (!start) return std::nullopt;
      std::optional<Curve_strip> strip;
      if (start->index >= 0) strip.emplace(view_, coordinates_, *start);
      const std::uint32_t end =
          strip ? view_.source(strip->end.halfedge) : view_.target(start->halfedge);
      const double to = parameter_on_halfedge(coordinates_, end, x, false);
      if (point.x <= to || !coordinates_.is_inserted(end)) {
        const double scale = 1 / (to - from);
        const Point q{(point.x - from) * scale, point.y * scale};
        return strip ? beside_strip(*strip, q) : beside_edge(start->halfedge, q);
      }
      vertex = end;
      from = to;
    }
  }

  Walked beside_edge(std::uint32_t h, const Point& p) const {
    return walk(h, {{0, 0}, {1, 0}}, {foot(p), 0}, p);
  }

  // Start of the walk to a point, on the segment from 0 to 1. Not an end: from there the way around
  // the vertex would be ambiguous.
  static double foot(const Point& p) { return p.x >= 0 && p.x <= 1 ? p.x : 0.5; }

  // the curve from 0 to 1: first the face at the foot of the perpendicular, then up
  Walked beside_strip(const Curve_strip& strip, const Point& p) const {
    std::vector<Point> z = strip.develop(view_);
    const Point d = z.back();
    const double squared = dot(d, d);
    for (Point& q : z) q = q * Point{d.x / squared, -d.y / squared};
    const Point from{foot(p), 0};
    std::size_t n = 0;
    const auto point = [&](unsigned k) { return z[strip.faces[n].point[k]]; };
    while (++n < strip.faces.size() && side_of(point(0), point(1), from) >= 0) {
    }
    --n; // the last face that is entered before
    return walk(strip.faces[n].side, {point(0), point(1), point(2)}, from, p);
  }

  // Walks straight from a point of the face of a halfedge to another point, and returns the
  // latter's face. `z`: where the face is in the plane.
  //
  // The walk never goes back over the side by which it came, and ends if the point is outside only
  // by rounding: otherwise it might not end for a point on an edge or at a vertex. If rounding
  // leads over the border, it returns the last point before it.
  Walked walk(std::uint32_t halfedge, std::vector<Point> z, const Point& from,
              const Point& to) const {
    Development<> faces;
    faces.start(halfedge);
    for (;;) {
      faces.develop(z, approximate_values(view_));
      const auto& [h, point, beyond] = faces[faces.last()];
      const std::array<Point, 3> p{z[point[0]], z[point[1]], z[point[2]]};
      const std::array<std::uint32_t, 3> sides = sides_of_face(view_, h);
      unsigned exit = 3;
      double least = 0;
      for (unsigned k = faces.size() == 1 ? 0 : 1; k < 3; ++k) { // side 0 is that by which it came
        // crosses side k outwards, and leaves its start on the right and its end on the left
        const Point &a = p[k], &b = p[(k + 1) % 3];
        if (side_of(a, b, to) >= -rounding(a, b, to)) continue;
        const double through = std::min(side_of(from, to, b), -side_of(from, to, a));
        if (exit == 3 || through > least) {
          exit = k;
          least = through;
        }
      }
      if (exit == 3 || view_.is_border(sides[exit] ^ 1U) || faces.size() > maximal_steps)
        return in_face(h, p, to);
      faces.enter(faces.last(), exit, sides[exit] ^ 1U);
    }
  }

  // a point of a face, moved into it if rounding has put it outside
  static Walked in_face(std::uint32_t h, const std::array<Point, 3>& face, const Point& p) {
    const Point side = face[1] - face[0];
    if (!(dot(side, side) > 0)) return {{h, {1, 0, 0}}, {1, 0}};
    return {{h, weights_in_triangle(p, face[0], face[1], face[2])}, side};
  }

  // twice the signed area of a triangle
  static double side_of(const Point& a, const Point& b, const Point& c) {
    return cross(b - a, c - a);
  }
  // bounds its error for points whose coordinates have some errors of one ulp
  static double rounding(const Point& a, const Point& b, const Point& c) {
    const auto size = [](const Point& x) { return std::abs(x.x) + std::abs(x.y); };
    return 0x1p-50 * size(b - a) * (size(a) + size(c));
  }

  // more faces mean that rounding leads in circles
  static constexpr std::size_t maximal_steps = std::size_t(1) << 22U;

  View view_;
  const Coordinates& coordinates_;
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_INTRINSIC_LOCATOR_H
