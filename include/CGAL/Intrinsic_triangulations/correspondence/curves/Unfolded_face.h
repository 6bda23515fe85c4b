// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_UNFOLDED_FACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_UNFOLDED_FACE_H

#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Edge_path.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Face_development.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Turned_positions.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/formulas/Development.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief places points of an intrinsic face on the input triangles over which it lies.

These are developed into the plane, such that the first side of the first triangle runs from 0 to 1.
\tparam FT `double`, `Interval_nt<false>` or a `Ball`
*/
template <FieldNumber FT>
class Unfolded_face {
public:
  /// A point of the plane.
  using Point = Plane_vector<FT>;
  /// A point of the face.
  using Place = Place_in_face;
  /// Relative distance within which a point is put on a curve: a few roundings of a circumcenter.
  static constexpr double usual_nearness = 0x1p-40;
  /// The unit of weights.
  static constexpr double least_nearness = 0x1p-52;

  /*!
  \brief unfolds the face of a halfedge.
  \tparam Input_values a functor from an input halfedge to the `Face_values<FT>` of its face from it
  \param values the functor; it and the coordinates must live as long as points are placed
  \complexity see `Face_development`
  */
  template <NumberedTriangles Complex, CurveCoordinates Coordinates, class Input_values>
  void unfold(const Complex& complex, const Coordinates& coordinates, std::uint32_t h,
              const Input_values& values) {
    face_.unfold(complex, coordinates, h);
    z_.develop(face_.triangles(), coordinates.input(), coordinates.fans(), values);
  }
  /// unfolds a face that was unfolded in other numbers.
  template <FieldNumber Other, class Input_values>
  void unfold(const Unfolded_face<Other>& face, const Input_values& values) {
    face_ = face.development();
    z_.develop(face_.triangles(), face.positions().input(), face.positions().fans(), values);
  }

  /// returns the triangles under the face, and how they were found.
  const Face_development& development() const { return face_; }
  /// returns where the points of these triangles are.
  const internal::Turned_positions<FT>& positions() const { return z_; }

  /*!
  \brief places a point of the face on the input: finds the triangle that contains it, and rounds
  its barycentric coordinates there, which then define it. A point within rounding of a curve is put
  on it.
  \param weights barycentric coordinates of the point in the face, approximately
  \param nearness distance from a curve within which a point is put on it, relative to the height of
    the triangle; what is represented beside it is at least `least_nearness` away
  \return the place; nothing if it is within rounding of a vertex of the input
  */
  std::optional<Place> place(const std::array<double, 3>& weights,
                             double nearness = usual_nearness) const {
    const Rounded p = in_face(weights);
    Place result = region_of(p);
    const std::array<double, 3> w = weights_in_triangle(result.triangle, p);
    return rounded(w, nearness, result) ? std::optional(result) : std::nullopt;
  }

  /*!
  \brief places a point of the first side, which runs along an input edge.
  \param input the input
  \param location a point of the input halfedge that runs beside the face, approximately
  \return the place; nothing if it is within rounding of an end
  */
  std::optional<Place> place_on_side(const Input& input, const Surface_point& location) const {
    Place result;
    result.region = face_.region_beside_first_side();
    result.triangle = face_.beside_first_side();
    const double along = std::floor(location.weights[1] * 0x1p52) * 0x1p-52;
    if (!(along > 0 && along < 1)) return std::nullopt;
    result.location = {location.halfedge, {1 - along, along, 0}};
    result.weights = seen_from(input, result.location, halfedge(result.triangle)).weights;
    for (unsigned k = 0; k < 2; ++k) // not at an end, which may be inside the input edge
      if (approximate(to_corner(result, k)) == Rounded{0, 0}) return std::nullopt;
    return result;
  }

  /*!
  \brief places a point whose place on the input is known.
  \param input the input
  \param wanted the place: multiples of 2^-52; on an edge if the last weight is zero
  \param weights barycentric coordinates of the point in the face, approximately: they select the
    place if the face lies twice over an input triangle
  \return the place; nothing if the place is not under the face, or its edge runs along a side of
  the face
  */
  std::optional<Place> place_at(const Input& input, const Surface_point& wanted,
                                const std::array<double, 3>& weights) const {
    const Rounded near = in_face(weights);
    double least = std::numeric_limits<double>::infinity();
    Place result;
    for (std::uint32_t t = 0; t <= face_.last(); ++t) {
      const std::optional<Surface_point> p = seen_in(input, t, wanted);
      if (!p) continue;
      const Rounded d = in_triangle(t, p->weights) - near;
      if (!(dot(d, d) < least)) continue;
      least = dot(d, d);
      result.triangle = t;
      result.location = *p;
    }
    if (least == std::numeric_limits<double>::infinity()) return std::nullopt;
    return at(result.triangle, result.location);
  }

  /// tells whether errors of points are too large for the middles of their intervals.
  template <class Interval = FT> // other numbers have no bounds
  bool is_vague() const {
    return z_.template is_vague<Interval>();
  }

  /*!
  \brief computes the values at a vertex that is inserted at a place.
  \return squared lengths of ip, jp, kp and quadruple areas of ijp, jkp, kip, which are positive if
  and only if the place is in the face
  */
  Vertex_move_values<FT> values(const Place& p) const {
    std::array<Point, 3> to;
    Vertex_move_values<FT> result;
    const FT unit = z_.unit();
    for (unsigned k = 0; k < 3; ++k) {
      to[k] = to_corner(p, k);
      result.squared_lengths[k] = unit * dot(to[k], to[k]);
    }
    for (unsigned k = 0; k < 3; ++k)
      result.quadruple_areas[k] = (unit + unit) * cross(to[k], to[(k + 1) % 3]);
    return result;
  }

  /// returns the values of the face, from its first side on.
  Face_values<FT> face_values() const {
    const Point i = position(face_.corner(0)), ij = position(face_.corner(1)) - i,
                ik = position(face_.corner(2)) - i, jk = ik - ij;
    const FT unit = z_.unit();
    return {{unit * dot(ij, ij), unit * dot(jk, jk), unit * dot(ik, ik)},
            (unit + unit) * cross(ij, ik)};
  }

  /// returns the corner that is farthest from a place: its direction is the most accurate one.
  Seen_corner farthest_corner(const Input& input, const Place& p) const {
    const Rounded axis = along(input, p);
    Seen_corner result;
    double farthest = 0;
    for (unsigned k = 0; k < 3; ++k) {
      const Rounded to = approximate(to_corner(p, k));
      if (!(dot(to, to) > farthest)) continue;
      farthest = dot(to, to);
      result = {k, std::atan2(cross(axis, to), dot(axis, to))};
    }
    return result;
  }

  /*!
  \brief finds the point of the input at a point of the face, without rounding it.
  \param weights barycentric coordinates of the point in the face
  \return the point, and the direction of its halfedge from the first side of the face
  */
  Mapped_point locate(const std::array<double, 3>& weights) const {
    const Rounded p = in_face(weights);
    const std::uint32_t t = region_of(p).triangle;
    const Rounded d = rounded_point(t, 1) - rounded_point(t, 0),
                  side = approximate(position(face_.corner(1))) -
                         approximate(position(face_.corner(0)));
    return {{halfedge(t), weights_in_triangle(t, p)},
            in_frame(side, d) / std::sqrt(dot(d, d) * dot(side, side)),
            {1, 0}};
  }

private:
  using Corner = Face_development::Corner;
  using Rounded = Plane_vector<double>;

  std::uint32_t halfedge(std::uint32_t t) const { return face_.triangles()[t].side; }
  Point point(std::uint32_t t, std::size_t k) const { return z_[face_.triangles()[t].point[k]]; }
  static Rounded approximate(const Point& p) {
    if constexpr (requires { p.x.to_double(); })
      return {p.x.to_double(), p.y.to_double()};
    else
      return {CGAL::to_double(p.x), CGAL::to_double(p.y)};
  }
  Rounded rounded_point(std::uint32_t t, std::size_t k) const { return approximate(point(t, k)); }

  Point position(const Corner& c) const {
    const Point o = point(c.triangle, 0);
    if (c.weights[0] == 1) return o;
    if (c.weights[1] == 1) return point(c.triangle, 1);
    const Point a = point(c.triangle, 1) - o, b = point(c.triangle, 2) - o;
    const FT s(c.weights[1]), t(c.weights[2]);
    return {o.x + s * a.x + t * b.x, o.y + s * a.y + t * b.y};
  }

  // from a place to a corner of the face; in one triangle differences of weights are exact
  Point to_corner(const Place& from, unsigned k) const {
    Corner to = face_.corner(k);
    if (from.triangle != to.triangle) {
      const std::optional<unsigned> shared = face_.shared_corner(from.triangle, to);
      if (!shared) return position(to) - position({from.triangle, from.weights});
      to = {from.triangle, {}};
      to.weights[*shared] = 1;
    }
    const Point o = point(from.triangle, 0);
    const Point a = point(from.triangle, 1) - o, b = point(from.triangle, 2) - o;
    const FT s(to.weights[1] - from.weights[1]), t(to.weights[2] - from.weights[2]);
    return {s * a.x + t * b.x, s * a.y + t * b.y};
  }

  // the combination of three points
  template <class Point_at>
  static Rounded combination(const std::array<double, 3>& weights, const Point_at& at) {
    Rounded p{0, 0};
    for (unsigned k = 0; k < 3; ++k) p = p + weights[k] * at(k);
    return p;
  }
  Rounded in_face(const std::array<double, 3>& weights) const {
    return combination(weights, [&](unsigned k) { return approximate(position(face_.corner(k))); });
  }
  Rounded in_triangle(std::uint32_t t, const std::array<double, 3>& weights) const {
    return combination(weights, [&](unsigned k) { return rounded_point(t, k); });
  }
  std::array<double, 3> weights_in_triangle(std::uint32_t t, const Rounded& p) const {
    return Intrinsic_triangulations::weights_in_triangle(p, rounded_point(t, 0),
                                                         rounded_point(t, 1), rounded_point(t, 2));
  }

  // the region and the triangle of a point
  Place region_of(const Rounded& p) const {
    Place result;
    const auto is_beyond = [&](std::uint32_t t) {
      const Rounded a = rounded_point(t, 0);
      return cross(rounded_point(t, 1) - a, p - a) > 0;
    };
    result.triangle = face_.find_region(is_beyond, result.region);
    return result;
  }

  // a place on the input from the first side of a triangle, if it is in it
  std::optional<Surface_point> seen_in(const Input& input, std::uint32_t t,
                                       const Surface_point& p) const {
    const std::uint32_t h = halfedge(t), o = p.halfedge ^ 1U;
    if (input.face(p.halfedge) == input.face(h)) return seen_from(input, p, h);
    if (p.weights[2] != 0 || input.face(o) != input.face(h)) return std::nullopt;
    return seen_from(input, {o, {p.weights[1], p.weights[0], 0}}, h);
  }

  // a point of a triangle, from its first side on
  std::optional<Place> at(std::uint32_t t, const Surface_point& p) const {
    constexpr double inwards = 0x1p-20; // so far that the walk ends in the triangle
    std::array<double, 3> w = p.weights;
    for (double& x : w) x += inwards * (1. / 3 - x);
    Place result = region_of(in_triangle(t, w));
    if (result.triangle != t) return std::nullopt;
    const auto zero = std::find(p.weights.begin(), p.weights.end(), 0.);
    if (zero != p.weights.end()) {
      const auto opposite = static_cast<unsigned>(zero - p.weights.begin());
      const std::uint32_t child = face_.entered_over(t, opposite);
      if (child == Development<>::none || !put_on_curve(child, opposite, p.weights, result))
        return std::nullopt;
      return result;
    }
    result.weights = p.weights;
    result.location = p;
    return result;
  }

  // the direction of the halfedge of the location, on the side of the edge where the place is
  Rounded along(const Input& input, const Place& p) const {
    const bool is_on_edge = p.location.weights[2] == 0;
    const auto is_side = [&](std::uint32_t side, std::size_t k) {
      return side / 2 == p.location.halfedge / 2 && !(is_on_edge && p.weights[(k + 2) % 3] != 0);
    };
    std::uint32_t side = halfedge(p.triangle);
    std::size_t k = 0;
    for (; k < 2 && !is_side(side, k); ++k) side = input.next(side);
    const Rounded a = rounded_point(p.triangle, k), b = rounded_point(p.triangle, (k + 1) % 3);
    return side == p.location.halfedge ? b - a : a - b;
  }

  bool rounded(std::array<double, 3> w, double nearness, Place& result) const {
    const std::uint32_t t = result.triangle;
    if (t > 0 && w[2] < nearness) return put_on_curve(t, 2, w, result);
    for (const std::uint32_t child : face_.children(t)) {
      const unsigned opposite = (face_.triangles().exit_to(child) + 2) % 3;
      if (w[opposite] < nearness) return put_on_curve(child, opposite, w, result);
    }
    const std::optional<std::array<double, 3>> exact = representable_weights(w);
    if (!exact) return false;
    result.weights = *exact;
    result.location = {halfedge(t), *exact};
    return true;
  }

  // on the curve over which a triangle is entered, opposite a corner of the triangle of the place
  bool put_on_curve(std::uint32_t child, unsigned opposite, std::array<double, 3> w,
                    Place& result) const {
    const unsigned from = (opposite + 1) % 3, to = (opposite + 2) % 3;
    w[opposite] = 0;
    w[to] = std::floor(w[to] / (w[from] + w[to]) * 0x1p52) * 0x1p-52;
    w[from] = 1 - w[to];
    if (w[from] == 0 || w[to] == 0) return false;
    result.weights = w;
    const bool ends_here = result.triangle == child; // else the side of the triangle runs backwards
    const std::uint32_t side = halfedge(child) ^ (ends_here ? 0U : 1U);
    const std::uint32_t curve =
        halfedge(child) ^ (face_.name_curve(child, result.region) ? 0U : 1U);
    result.location = side == curve ? Surface_point{curve, {w[from], w[to], 0}}
                                    : Surface_point{curve, {w[to], w[from], 0}};
    return true;
  }

  Face_development face_;
  internal::Turned_positions<FT> z_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_UNFOLDED_FACE_H
