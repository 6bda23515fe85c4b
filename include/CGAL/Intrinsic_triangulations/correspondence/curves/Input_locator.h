// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_INPUT_LOCATOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_INPUT_LOCATOR_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Edge_path.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/CurveCoordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Curve_strip.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Face_region.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/weights_above_side.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

/*!
\file
From points of the intrinsic triangulation to points of the input, by integer coordinates (§3.5.4 of
the course, "Face Split").
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

/// A point of an intrinsic face, and where it is on the input.
struct Located {
  Face_region region; ///< the region of the face
  Mapped_point place; ///< the place on the input
};

} // namespace internal

/// returns the input halfedge along which a curve starts.
template <CurveCoordinates Coordinates>
std::uint32_t input_halfedge(const Coordinates& coordinates, const Curve_end& start) {
  const std::uint32_t h = start.halfedge;
  const std::uint32_t on_it = coordinates.normal_coordinate(h / 2) < 0 ? 1 : 0;
  return coordinates.fans().halfedge(coordinates.fans().advance(
      coordinates.roundabout(h), on_it + static_cast<std::uint32_t>(start.index)));
}

/*!
\brief returns where a vertex is along an input halfedge that it lies on: 0 at its source, 1 at its
target.
\param coordinates a correspondence that knows the location of inserted vertices
\param vertex an intrinsic vertex
\param halfedge an input halfedge, of which a part starts or ends at the vertex
\param starts whether a part of it starts from the vertex
*/
template <class Coordinates>
double parameter_on_halfedge(const Coordinates& coordinates, std::uint32_t vertex,
                             std::uint32_t halfedge, bool starts) {
  if (!coordinates.is_inserted(vertex)) return starts ? 0 : 1;
  const Surface_point& p = coordinates.location(vertex);
  return p.halfedge == halfedge ? p.weights[1] : p.weights[0];
}

/*!
\brief returns a point of the input that lies beside an input halfedge.
\param input the input
\param halfedge the halfedge
\param x distance along the halfedge, in units of its length
\param y distance to the left of it, in the same units
\return the point in the face on the left if `y` is positive or there is no other, else on the right;
rounding does not get it out of that face
*/
template <class Input>
Surface_point point_beside_halfedge(const Input& input, std::uint32_t halfedge, double x,
                                    double y) {
  if ((y < 0 && !input.is_border(halfedge ^ 1U)) || input.is_border(halfedge)) {
    halfedge ^= 1U;
    x = 1 - x;
    y = -y;
  }
  return {halfedge, weights_above_side({x, y}, apex_above_side(input, halfedge))};
}

/*!
\brief describes a point of the input from another halfedge of the same face.
\pre `base` and the halfedge of `p` have one face
*/
template <class Input>
Surface_point seen_from(const Input& input, const Surface_point& p, std::uint32_t base) {
  const std::array<double, 3>& w = p.weights;
  if (p.halfedge == base) return p;
  if (p.halfedge == input.next(base)) return {base, {w[2], w[0], w[1]}};
  return {base, {w[1], w[2], w[0]}};
}

/// returns the vector from a point of the input to another one of the same face, in the frame of the first.
template <class Input>
Planar_vector<double> vector_between(const Input& input, const Surface_point& from,
                                     const Surface_point& to) {
  const Geodesic_face face(input, from.halfedge);
  const Planar_vector<double> a = face.to_corner(from.weights, 0),
                              b = face.to_corner(seen_from(input, to, from.halfedge).weights, 0);
  return {a[0] - b[0], a[1] - b[1]};
}

/*!
\brief returns the point of the input at a corner of an intrinsic face, in the input face in which the
corner begins, counterclockwise from its first side.
\param view the intrinsic triangulation
\param coordinates the correspondence
\param side first side of the corner
*/
template <class View, CurveCoordinates Coordinates>
Surface_point corner_on_input(const View& view, const Coordinates& coordinates,
                              std::uint32_t side) {
  const std::uint32_t slot = coordinates.roundabout(side), vertex = view.source(side);
  if (slot == Gluing::none) return coordinates.location(vertex);
  const std::uint32_t h = coordinates.fans().halfedge(slot);
  const double x = parameter_on_halfedge(coordinates, vertex, h, true);
  return coordinates.normal_coordinate(side / 2) < 0 ? Surface_point{h, {1 - x, x, 0}}
                                                     : Surface_point{h ^ 1U, {x, 1 - x, 0}};
}

/*!
\brief returns the point of the input at a point of an intrinsic face that no curve enters.
\param view the intrinsic triangulation
\param coordinates the correspondence
\param sides the sides of the face
\param weights barycentric coordinates of the point
*/
template <class View, CurveCoordinates Coordinates>
Surface_point point_between_corners(const View& view, const Coordinates& coordinates,
                                    const std::array<std::uint32_t, 3>& sides,
                                    const std::array<double, 3>& weights) {
  Surface_point p{corner_on_input(view, coordinates, sides[0]).halfedge, {0, 0, 0}};
  for (unsigned k = 0; k < 3; ++k) {
    const Surface_point corner =
        seen_from(coordinates.input(), corner_on_input(view, coordinates, sides[k]), p.halfedge);
    for (std::size_t i = 0; i < 3; ++i) p.weights[i] += weights[k] * corner.weights[i];
  }
  return p;
}

/*!
\brief returns the point of the input at a point of an intrinsic edge that runs along an input edge.
\param view the intrinsic triangulation
\param coordinates the correspondence
\param h a halfedge of the edge, with a face
\param parameter 0 at the source of `h`, 1 at its target
\return a point on a halfedge of the input with the direction of `h`
*/
template <class View, CurveCoordinates Coordinates>
Surface_point location_on_side(const View& view, const Coordinates& coordinates, std::uint32_t h,
                               double parameter) {
  const std::uint32_t x = coordinates.fans().halfedge(coordinates.roundabout(h));
  const double from = parameter_on_halfedge(coordinates, view.source(h), x, true);
  const double to = parameter_on_halfedge(coordinates, view.target(h), x, false);
  const double along = from + parameter * (to - from);
  return {x, {1 - along, along, 0}};
}

namespace internal {

/// Finds the region of a face that contains a point, and the point of the input.
template <class Triangulation, CurveCoordinates Coordinates>
class Input_locator {
public:
  Input_locator(const Triangulation& t, const Coordinates& coordinates, std::uint32_t h,
                const std::array<double, 3>& weights)
      : metric_(t.metric()), view_(t), coordinates_(coordinates), sides_(sides_of_face(view_, h)),
        weights_(weights), corners_(corner_coordinates(view_, coordinates, h)) {}

  Located locate() const {
    const Face_region r =
        find_region(corners_, sides_, [this](const Curve_crossing& c) { return side(c); });
    return {r, place_in_region(r)};
  }

private:
  struct Placed_curve {
    std::uint32_t halfedge; // of the input
    double x, y;            // of the point, in units of the halfedge
    Plane_point<double> direction;
  };

  // With inexact arithmetic no point counts as one on a curve.
  Sign side(const Curve_crossing& c) const {
    const Curve_strip strip(view_, coordinates_, sides_, c);
    const Sign s = metric_.sign(strip.faces(), Side_of_curve_expression(strip, weights_));
    return s == ZERO && !Triangulation::Metric::is_exact ? POSITIVE : s;
  }

  // the point beside the input halfedge along which a curve leaves the face
  Placed_curve place(const Curve_crossing& c) const {
    const Curve_strip strip(view_, coordinates_, sides_, c);
    metric_.sharpen(strip.faces());
    const std::vector<Plane_point<double>> points = strip.unfold_approximately(view_);
    const Plane_point<double> u = points[strip.first()], d = points[strip.last()] - u;
    const Plane_point<double> p{weights_[1] + weights_[2] * points[2].x - u.x,
                                weights_[2] * points[2].y - u.y};
    const double squared = dot(d, d);
    const std::uint32_t h = input_halfedge(coordinates_, strip.start());
    const double from =
        parameter_on_halfedge(coordinates_, view_.source(strip.start().halfedge), h, true);
    const double to =
        parameter_on_halfedge(coordinates_, view_.source(strip.end().halfedge), h, false);
    return {h, from + dot(d, p) / squared * (to - from), cross(d, p) / squared * (to - from), d};
  }

  Mapped_point beside(const Curve_crossing& c, bool on_left) const {
    Placed_curve p = place(c);
    if (on_left != (p.y > 0)) p.y = on_left ? 0.0 : -0.0;
    const auto& input = coordinates_.input();
    return directed(p, on_left ? point_beside_halfedge(input, p.halfedge, p.x, p.y)
                               : point_beside_halfedge(input, p.halfedge ^ 1U, 1 - p.x, -p.y));
  }

  // the direction is that of the halfedge of the point, which runs along the curve or back
  static Mapped_point directed(const Placed_curve& p, const Surface_point& point) {
    const double length = std::hypot(p.direction.x, p.direction.y);
    const double scale = (point.halfedge == p.halfedge ? 1 : -1) / (length > 0 ? length : 1);
    return {point, {scale * p.direction.x, scale * p.direction.y}, {1, 0}};
  }

  Mapped_point place_in_region(const Face_region& r) const {
    if (r.is_on_curve) return on_curve(r);
    for (unsigned k = 0; k < 3; ++k) // beyond an arc, or on the near side of one
      if (r.cutting[k] < corners_.cutting[k]) return beside({sides_[k], r.cutting[k]}, false);
    if (r.fan_corner < 3) {
      const std::uint32_t side = sides_[(r.fan_corner + 1) % 3];
      const Normal_coordinate first = corners_.cutting[(r.fan_corner + 1) % 3];
      return r.right_of_fan > 0 ? beside({side, first + r.right_of_fan - 1}, true)
                                : beside({side, first}, false);
    }
    for (unsigned k = 0; k < 3; ++k)
      if (r.cutting[k] > 0) return beside({sides_[k], r.cutting[k] - 1}, true);
    return between_corners();
  }

  // in a face that no curve enters: the first side's direction on the input is turned back
  Mapped_point between_corners() const {
    const auto [x, y] =
        vector_between(coordinates_.input(), corner_on_input(view_, coordinates_, sides_[0]),
                       corner_on_input(view_, coordinates_, sides_[1]));
    const double length = std::hypot(x, y);
    return {point_between_corners(view_, coordinates_, sides_, weights_),
            {length > 0 ? x / length : 1, length > 0 ? -y / length : 0},
            {1, 0}};
  }

  Mapped_point on_curve(const Face_region& r) const {
    const unsigned k = r.corner;
    const bool in_fan = k == r.fan_corner;
    const Curve_crossing c =
        in_fan ? Curve_crossing{sides_[(k + 1) % 3], corners_.cutting[(k + 1) % 3] + r.right_of_fan}
               : Curve_crossing{sides_[k], r.cutting[k]};
    const Placed_curve p = place(c);
    const double x = std::clamp(p.x, 0.0, 1.0);
    return directed(p, {p.halfedge, {1 - x, x, 0}});
  }

  const typename Triangulation::Metric& metric_;
  Intrinsic_view<Triangulation> view_;
  const Coordinates& coordinates_;
  std::array<std::uint32_t, 3> sides_;
  std::array<double, 3> weights_;
  Corner_coordinates corners_;
};

// Finds the point of the input at a point of an intrinsic face, and the region of the face in which it lies.
// Complexity: that of following a number of curves logarithmic in the number of crossings of the face.
template <class Triangulation, CurveCoordinates Coordinates>
Located locate_by_curves(const Triangulation& t, const Coordinates& coordinates, std::uint32_t h,
                         const std::array<double, 3>& weights) {
  [[maybe_unused]] const typename Triangulation::Metric::Scope scope;
  return Input_locator<Triangulation, Coordinates>(t, coordinates, h, weights).locate();
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_INPUT_LOCATOR_H
