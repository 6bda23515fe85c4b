// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_INTRINSIC_LOCATOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_INTRINSIC_LOCATOR_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/CurveCoordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

/*!
\file
From points of the input to points of the intrinsic triangulation, by integer coordinates.
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
\return the corner from which it starts and the number of curves from there before it, -1 if it is the
first side itself; nothing if no curve along `x` starts there
\complexity linear in the degree of the vertex; where several fans of faces meet, linear
*/
template <class View, CurveCoordinates Coordinates>
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

/// A face in the plane: its halfedge runs from source to target.
struct Placed_face {
  std::uint32_t halfedge;
  Plane_vector<double> source, target, apex;
};

/// returns twice the signed area of a triangle
inline double orientation(const Plane_vector<double>& a, const Plane_vector<double>& b,
                          const Plane_vector<double>& c) {
  return cross(b - a, c - a);
}

/// A point of an intrinsic face, and the direction of its halfedge in the frame that the walk began with.
struct Walked {
  Surface_point point;
  Plane_vector<double> direction; // not a unit vector
};

/// Walks over the intrinsic triangulation, unfolding faces into the plane.
template <class View>
class Plane_walk {
public:
  using Point = Plane_vector<double>;

  explicit Plane_walk(const View& view) : view_(view) {}

  /// places the face of a halfedge on the left of a segment.
  Placed_face place(std::uint32_t h, const Point& source, const Point& target) const {
    return {h, source, target, source + (target - source) * apex_above_side(view_, h)};
  }

  /// walks straight from a point of a face to another point, and returns the latter's face.
  ///
  /// The walk never goes back over the side by which it came, and ends where the point is outside by no
  /// more than rounding: else a point on an edge, or at a vertex, could be sent to and fro for ever.
  /// \return the point; where rounding leads over the border, the last point before it
  Walked walk(Placed_face f, const Point& from, const Point& to) const {
    for (std::size_t steps = 0; steps < maximal_steps; ++steps) {
      const std::array<Point, 3> p{f.source, f.target, f.apex};
      const std::array<std::uint32_t, 3> sides = sides_of_face(view_, f.halfedge);
      unsigned exit = 3;
      double least = 0;
      for (unsigned k = steps == 0 ? 0 : 1; k < 3; ++k) { // side 0 is that by which it came
        // crosses side k outwards, and leaves its start on the right and its end on the left
        const Point &a = p[k], &b = p[(k + 1) % 3];
        if (orientation(a, b, to) >= -rounding(a, b, to)) continue;
        const double through = std::min(orientation(from, to, b), -orientation(from, to, a));
        if (exit == 3 || through > least) {
          exit = k;
          least = through;
        }
      }
      if (exit == 3 || view_.is_border(sides[exit] ^ 1U)) return weights(f, to);
      f = place(sides[exit] ^ 1U, p[(exit + 1) % 3], p[exit]);
    }
    return weights(f, to);
  }

  /// returns a point of a face, moved into it if rounding has put it outside.
  static Walked weights(const Placed_face& f, const Point& p) {
    const Point side = f.target - f.source;
    if (!(dot(side, side) > 0)) return {{f.halfedge, {1, 0, 0}}, {1, 0}};
    return {{f.halfedge, weights_in_triangle(p, f.source, f.target, f.apex)}, side};
  }

private:
  static constexpr std::size_t maximal_steps = std::size_t(1) << 24U;

  // bounds the error of `orientation(a, b, c)` for points whose coordinates have some errors of one ulp
  static double rounding(const Point& a, const Point& b, const Point& c) {
    const auto size = [](const Point& x) { return std::abs(x.x) + std::abs(x.y); };
    return 0x1p-50 * size(b - a) * (size(a) + size(c));
  }

  const View& view_;
};

/// Finds the point of the intrinsic triangulation at a point of the input.
template <class Triangulation, CurveCoordinates Coordinates>
class Intrinsic_locator {
  using View = Intrinsic_view<Triangulation>;
  using Point = Plane_vector<double>;

public:
  Intrinsic_locator(const Triangulation& t, const Coordinates& coordinates)
      : view_(t), coordinates_(coordinates), walk_(view_) {}

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
    const Placed_face f = walk_.place(h, {0, 0}, {1, 0});
    return walk_.walk(f, {foot(p), 0}, p);
  }

  // From where on the segment from 0 to 1 to walk to a point. At an end it would be open which way
  // round the vertex to go.
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
    while (++n < strip.faces.size() && orientation(point(0), point(1), from) >= 0) {
    }
    --n; // the last face that is entered before
    return walk_.walk({strip.faces[n].side, point(0), point(1), point(2)}, from, p);
  }

  View view_;
  const Coordinates& coordinates_;
  Plane_walk<View> walk_;
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_INTRINSIC_LOCATOR_H
