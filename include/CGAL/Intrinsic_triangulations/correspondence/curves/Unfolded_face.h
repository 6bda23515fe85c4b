// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_UNFOLDED_FACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_UNFOLDED_FACE_H

#include <CGAL/Intrinsic_triangulations/correspondence/Edge_path.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Face_layout.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Face_region.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/weights_above_side.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

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
\tparam FT a model of `Field` with `CGAL::to_double()`
*/
template <class FT>
class Unfolded_face : public Face_layout<FT> {
public:
  /// Relative distance from a curve within which a point is put on it: a few roundings of a circumcenter.
  static constexpr double usual_nearness = 0x1p-40;
  /// The unit of weights.
  static constexpr double least_nearness = 0x1p-52;

  /// A point of the face.
  struct Place {
    Face_region region;              ///< in the face
    std::uint32_t triangle = 0;      ///< the input triangle that contains it, by its number here
    std::array<double, 3> weights{}; ///< of the corners of the triangle, multiples of 2^-52
    Surface_point
        location; ///< on the input; if it is on a curve, on the side of the curve of larger numbers
  };

  /*!
  \brief places a point of the face on the input: finds the triangle that contains it, and rounds its barycentric
  coordinates there, which then define it. A point within rounding of a curve is put on it.
  \param input the input
  \param weights barycentric coordinates of the point in the face, approximately
  \param nearness distance from a curve within which a point is put on it, relative to the height of the triangle;
  what is represented beside it is at least `least_nearness` away
  \return the place; nothing if it is within rounding of a vertex of the input
  */
  std::optional<Place> place(const Input& input, const std::array<double, 3>& weights,
                             double nearness = usual_nearness) const {
    const Plane_vector<double> p = combination(weights);
    Place result;
    result.region = middle_region();
    walk(p, result);
    const std::array<double, 3> in_triangle = barycentric(triangles_[result.triangle], p);
    return rounded(input, in_triangle, nearness, result) ? std::optional(result) : std::nullopt;
  }

  /*!
  \brief places a point of the first side, which runs along an input edge.
  \param input the input
  \param location a point of the input halfedge that runs beside the face, approximately
  \return the place; nothing if it is within rounding of an end
  */
  std::optional<Place> place_on_side(const Input& input, const Surface_point& location) const {
    Place result;
    result.region = middle_region();
    if (fan_ < 3) result.region.right_of_fan = fan_ == 1 ? curves_.emanating[1] : 0;
    result.triangle = region_at(fan_ == 0 ? 1 : 0, 0);
    const double along = std::floor(location.weights[1] * 0x1p52) * 0x1p-52;
    if (!(along > 0 && along < 1)) return std::nullopt;
    result.location = {location.halfedge, {1 - along, along, 0}};
    result.weights =
        seen_from(input, result.location, triangles_[result.triangle].halfedge).weights;
    for (unsigned k = 0; k < 2; ++k) { // not at an end, which may be inside the input edge
      const Plane_vector<double> d =
          approximate(vector({result.triangle, result.weights}, corner_[k]));
      if (d.x == 0 && d.y == 0) return std::nullopt;
    }
    return result;
  }

  /*!
  \brief places a point whose place on the input is known.
  \param input the input
  \param wanted the place: multiples of 2^-52; on an edge if the last weight is zero
  \param weights barycentric coordinates of the point in the face, approximately: where the face lies twice over an
  input triangle, they tell which is meant
  \return the place; nothing if the face lies over no triangle with that place, or the edge runs along a side of the face
  */
  std::optional<Place> place_at(const Input& input, const Surface_point& wanted,
                                const std::array<double, 3>& weights) const {
    const Plane_vector<double> near = combination(weights);
    double least = std::numeric_limits<double>::infinity();
    Place result;
    for (std::uint32_t t = 0; t <= last(); ++t) {
      const std::optional<Surface_point> p = seen_in(input, t, wanted);
      if (!p) continue;
      const Plane_vector<double> d = point_in(t, p->weights) - near;
      if (!(dot(d, d) < least)) continue;
      least = dot(d, d);
      result.triangle = t;
      result.location = *p;
    }
    if (least == std::numeric_limits<double>::infinity()) return std::nullopt;
    return at(input, result.triangle, result.location);
  }

  /// tells whether errors of points grow so large that what is in the middle of them may be anywhere.
  template <class Interval = FT> // other numbers have no bounds
  bool is_vague() const {
    const auto is_vague = [](const Interval& x) {
      return !(x.sup() - x.inf() <= 0x1p-26 * std::max(1., std::abs(x.sup())));
    };
    return std::any_of(triangles_.begin(), triangles_.end(), [&](const Triangle& t) {
      return is_vague(t.point[2].x) || is_vague(t.point[2].y);
    });
  }

  using Face_layout<FT>::values;
  /// computes the values at a vertex that is inserted at a place.
  Vertex_move_values<FT> values(const Place& p) const { return values(p.triangle, p.weights); }

  /// returns the corner of the face that is farthest from a place: its direction is the most accurate one.
  Seen_corner farthest_corner(const Input& input, const Place& p) const {
    const Plane_vector<double> axis = along(input, p);
    Seen_corner result;
    double farthest = 0;
    for (unsigned k = 0; k < 3; ++k) {
      const Plane_vector<double> to = approximate(vector({p.triangle, p.weights}, corner_[k]));
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
    const Plane_vector<double> p = combination(weights);
    Place place;
    place.region = middle_region();
    walk(p, place);
    const Triangle& t = triangles_[place.triangle];
    const Plane_vector<double> d = approximate(t.point[1]) - approximate(t.point[0]);
    const Plane_vector<double> side =
        approximate(position(corner_[1])) - approximate(position(corner_[0]));
    const double length = std::sqrt(dot(d, d) * dot(side, side));
    return {
        {t.halfedge, barycentric(t, p)}, {dot(side, d) / length, cross(side, d) / length}, {1, 0}};
  }

private:
  using Base = Face_layout<FT>;
  using Base::along_, Base::corner_, Base::curves_, Base::fan_, Base::first_, Base::triangles_;
  using Base::approximate, Base::combination, Base::last, Base::position, Base::region_at;
  using Base::side_towards, Base::vector;
  using typename Base::Triangle;

  // a place on the input from the first side of a triangle, if it is in it
  std::optional<Surface_point> seen_in(const Input& input, std::uint32_t t,
                                       const Surface_point& p) const {
    const std::uint32_t h = triangles_[t].halfedge, o = p.halfedge ^ 1U;
    if (input.face(p.halfedge) == input.face(h)) return seen_from(input, p, h);
    if (p.weights[2] != 0 || input.face(o) != input.face(h)) return std::nullopt;
    return seen_from(input, {o, {p.weights[1], p.weights[0], 0}}, h);
  }

  Plane_vector<double> point_in(std::uint32_t t, const std::array<double, 3>& w) const {
    Plane_vector<double> p{0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      const Plane_vector<double> z = approximate(triangles_[t].point[k]);
      p = {p.x + w[k] * z.x, p.y + w[k] * z.y};
    }
    return p;
  }

  // a point of a triangle, from its first side on
  std::optional<Place> at(const Input& input, std::uint32_t t, const Surface_point& p) const {
    constexpr double inwards = 0x1p-20; // so far that the walk ends in the triangle
    std::array<double, 3> w = p.weights;
    for (double& x : w) x += inwards * (1. / 3 - x);
    Place result;
    result.region = middle_region();
    walk(point_in(t, w), result);
    if (result.triangle != t) return std::nullopt;
    const auto zero = std::find(p.weights.begin(), p.weights.end(), 0.);
    if (zero != p.weights.end()) {
      const auto opposite = static_cast<unsigned>(zero - p.weights.begin());
      const std::optional<std::uint32_t> child = beyond(input, t, opposite);
      if (!child || !put_on_curve(*child, opposite, p.weights, result)) return std::nullopt;
      return result;
    }
    result.weights = p.weights;
    result.location = p;
    return result;
  }

  // the triangle that is entered over the side of a triangle opposite a corner: itself, or another one
  std::optional<std::uint32_t> beyond(const Input& input, std::uint32_t t,
                                      unsigned opposite) const {
    if (t > 0 && opposite == 2) return t;
    for (const std::uint32_t child : {t + 1, static_cast<std::uint32_t>(along_) + 1})
      if (child <= last() && triangles_[child].parent == t &&
          (side_towards(input, child) + 2) % 3 == opposite)
        return child;
    return std::nullopt;
  }

  Face_region middle_region() const {
    Face_region r;
    r.cutting = curves_.cutting;
    r.fan_corner = fan_;
    return r;
  }

  // whether a point is beyond the side by which triangle t is entered
  bool is_in(std::uint32_t t, const Plane_vector<double>& p) const {
    const Plane_vector<double> a = approximate(triangles_[t].point[0]),
                               b = approximate(triangles_[t].point[1]), d = b - a, q = p - a;
    return d.x * q.y - d.y * q.x > 0;
  }

  // to the region that contains a point
  void walk(const Plane_vector<double>& p, Place& result) const {
    if (fan_ < 3) {
      Normal_coordinate m = 0;
      while (m < along_ && is_in(static_cast<std::uint32_t>(m) + 1, p)) ++m;
      return enter(m, result);
    }
    result.triangle = region_at(first_, curves_.cutting[first_]);
    for (unsigned k = 0; k < 3; ++k) {
      Normal_coordinate& q = result.region.cutting[k];
      for (; q > 0; --q) {
        const std::uint32_t outer = region_at(k, q - 1);
        const bool is_beyond = k == first_ ? !is_in(outer + 1, p) : is_in(outer, p);
        if (!is_beyond) break;
        result.triangle = outer;
      }
      if (q < curves_.cutting[k]) return;
    }
  }

  // region number m of a strip along a side
  void enter(Normal_coordinate m, Place& result) const {
    const unsigned end = (first_ + 1) % 3;
    Face_region& r = result.region;
    result.triangle = static_cast<std::uint32_t>(m);
    r.cutting[first_] = std::min(m, curves_.cutting[first_]);
    r.cutting[end] = std::min(along_ - m, curves_.cutting[end]);
    r.right_of_fan = std::clamp(m - curves_.cutting[first_], 0, curves_.emanating[fan_]);
  }

  // the direction of the halfedge of the location; where the triangle has both sides of its edge, at the one that the
  // place is on
  Plane_vector<double> along(const Input& input, const Place& p) const {
    const bool is_on_edge = p.location.weights[2] == 0;
    const auto is_side = [&](std::uint32_t side, std::size_t k) {
      return side / 2 == p.location.halfedge / 2 && !(is_on_edge && p.weights[(k + 2) % 3] != 0);
    };
    const Triangle& t = triangles_[p.triangle];
    std::uint32_t side = t.halfedge;
    std::size_t k = 0;
    for (; k < 2 && !is_side(side, k); ++k) side = input.next(side);
    const Plane_vector<double> a = approximate(t.point[k]), b = approximate(t.point[(k + 1) % 3]);
    return side == p.location.halfedge ? b - a : a - b;
  }

  static std::array<double, 3> barycentric(const Triangle& t, const Plane_vector<double>& p) {
    const Plane_vector<double> from = approximate(t.point[0]),
                               side = approximate(t.point[1]) - from;
    const auto seen = [&](const Plane_vector<double>& q) {
      const Plane_vector<double> v = q - from;
      return Plane_vector<double>{dot(side, v) / dot(side, side), cross(side, v) / dot(side, side)};
    };
    return weights_above_side(seen(p), seen(approximate(t.point[2])));
  }

  bool rounded(const Input& input, std::array<double, 3> w, double nearness, Place& result) const {
    const std::uint32_t t = result.triangle;
    if (t > 0 && w[2] < nearness) return put_on_curve(t, 2, w, result);
    for (const std::uint32_t child : {t + 1, static_cast<std::uint32_t>(along_) + 1}) {
      if (child > last() || triangles_[child].parent != t) continue;
      const unsigned opposite = (side_towards(input, child) + 2) % 3;
      if (w[opposite] < nearness) return put_on_curve(child, opposite, w, result);
    }
    const std::optional<std::array<double, 3>> exact = representable_weights(w);
    if (!exact) return false;
    result.weights = *exact;
    result.location = {triangles_[t].halfedge, *exact};
    return true;
  }

  // on the curve over which a triangle is entered; it is opposite a corner of the triangle of the place
  bool put_on_curve(std::uint32_t child, unsigned opposite, std::array<double, 3> w,
                    Place& result) const {
    const unsigned from = (opposite + 1) % 3, to = (opposite + 2) % 3;
    w[opposite] = 0;
    w[to] = std::floor(w[to] / (w[from] + w[to]) * 0x1p52) * 0x1p-52;
    w[from] = 1 - w[to];
    if (w[from] == 0 || w[to] == 0) return false;
    result.weights = w;
    const bool ends_here = result.triangle == child; // else the side of the triangle runs backwards
    const std::uint32_t side = triangles_[child].halfedge ^ (ends_here ? 0U : 1U);
    const std::uint32_t halfedge =
        triangles_[child].halfedge ^ (name_curve(child, result.region) ? 0U : 1U);
    result.location = side == halfedge ? Surface_point{halfedge, {w[from], w[to], 0}}
                                       : Surface_point{halfedge, {w[to], w[from], 0}};
    return true;
  }

  // Names the curve over which a triangle is entered. Returns whether the triangle is on the left of the curve as it
  // leaves the face through the side that starts from the corner it cuts off, or as it starts from its corner.
  bool name_curve(std::uint32_t child, Face_region& r) const {
    const auto c = static_cast<Normal_coordinate>(child);
    const unsigned end = (first_ + 1) % 3, third = (first_ + 2) % 3;
    r = middle_region();
    r.is_on_curve = true;
    const Normal_coordinate cut_first = curves_.cutting[first_];
    const bool at_first = c <= cut_first,
               in_fan = !at_first && fan_ < 3 && c <= cut_first + curves_.emanating[fan_];
    r.corner = at_first ? first_ : in_fan ? fan_ : c <= along_ ? end : third;
    if (fan_ < 3)
      r.right_of_fan = at_first ? 0 : in_fan ? c - 1 - cut_first : curves_.emanating[fan_];
    if (!in_fan)
      r.cutting[r.corner] = at_first      ? c - 1
                            : c <= along_ ? along_ - c
                                          : along_ + curves_.cutting[third] - c;
    return at_first || in_fan;
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_UNFOLDED_FACE_H
