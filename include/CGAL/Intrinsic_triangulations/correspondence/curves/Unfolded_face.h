// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_UNFOLDED_FACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_UNFOLDED_FACE_H

#include <CGAL/Intrinsic_triangulations/correspondence/Edge_path.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/CurveCoordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Face_region.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/weights_above_side.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// returns the face of an input halfedge and its slot there. \pre it has a face
inline Face_side input_side(const Input& input, std::uint32_t halfedge) {
  const std::uint32_t f = input.face(halfedge), first = input.halfedge_of_face(f);
  if (halfedge == first) return {f, 0};
  return {f, halfedge == input.next(first) ? 1U : 2U};
}

/// returns a functor from an input halfedge to the values of its face, from it on, as doubles.
inline auto approximate_values(const Input& input) {
  return [&input](std::uint32_t h) {
    return Face_values<double>{squared_lengths_of_face(input, h),
                               input.quadruple_area(input.face(h))};
  };
}

/*!
\brief unfolds the input triangles over which an intrinsic face lies, and places points of the face on them.

The curves (input edges) in a face ijk cut off corners or emanate from one corner. In the first case a middle
region is left, from which the regions at each corner are reached across the curves that cut it off; in the second
the regions form one strip along the side opposite that corner. Each lies in one input triangle. All are known from
the lists of the curves that cross one or two sides (§3.5 of the course).

Nothing but the input and integers enters: errors do not depend on the moves that made the face. Coordinates are
such that the first side of the first triangle runs from 0 to 1. Memory stays from face to face.
\tparam FT a model of `Field` with `CGAL::to_double()`
*/
template <class FT>
class Unfolded_face {
public:
  /// A point of the plane.
  using Point = Plane_point<FT>;
  /// Values at an inserted vertex, see `inserted_in_face()`.
  using Values = Vertex_move_values<FT>;

  /// A point of the face.
  struct Place {
    Face_region region;              ///< in the face
    std::uint32_t triangle = 0;      ///< the input triangle that contains it, by its number here
    std::array<double, 3> weights{}; ///< of the corners of the triangle, multiples of 2^-52
    Surface_point
        location; ///< on the input; if it is on a curve, on the side of the curve of larger numbers
  };

  /*!
  \brief unfolds the face of a halfedge.
  \tparam Complex `Intrinsic_view`
  \tparam Coordinates a model of `CurveCoordinates`
  \tparam Input_values a functor from an input halfedge to the `Face_values<FT>` of its face, from the halfedge on
  \complexity linear in the number of curves in the face, and that of following them
  */
  template <class Complex, CurveCoordinates Coordinates, class Input_values>
  void unfold(const Complex& complex, const Coordinates& coordinates, std::uint32_t h,
              const Input_values& values) {
    sides_ = sides_of_face(complex, h);
    curves_ = corner_coordinates(complex, coordinates, h);
    first_ = 0;
    fan_ = 3;
    for (unsigned k = 0; k < 3; ++k)
      if (curves_.emanating[k] > 0) fan_ = k, first_ = (k + 1) % 3;
    std::array<Surface_point, 3> corners;
    for (unsigned k = 0; k < 3; ++k)
      corners[k] = corner_on_input(complex, coordinates, sides_[k]);
    const Input& input = coordinates.input();
    triangles_.clear();
    unit_ = values(corners[first_].halfedge).squared_lengths[0];
    triangles_.push_back({corners[first_].halfedge, 0, {}});
    place_corners({FT(0), FT(0)}, {FT(1), FT(0)}, values);
    along_ = crossings(coordinates.normal_coordinate(sides_[first_] / 2));
    find_entered(complex, coordinates, sides_[first_], along_);
    for (const std::uint32_t x : entered_) add(input, last(), x, values);
    if (fan_ == 3) {
      const unsigned third = (first_ + 2) % 3;
      find_entered(complex, coordinates, sides_[third], curves_.cutting[third]);
      std::uint32_t parent = region_at(first_, curves_.cutting[first_]);
      for (auto x = entered_.rbegin(); x != entered_.rend(); ++x, parent = last())
        add(input, parent, *x ^ 1U, values);
    }
    for (unsigned k = 0; k < 3; ++k) {
      const std::uint32_t t = region_at(k, 0);
      corner_[k] = {t, seen_from(input, corners[k], triangles_[t].halfedge).weights};
    }
  }

  /*!
  \brief places a point of the face on the input: finds the triangle that contains it, and rounds its barycentric
  coordinates there, which then define it. A point within rounding of a curve is put on it.
  \param input the input
  \param weights barycentric coordinates of the point in the face, approximately
  \return the place; nothing if it is within rounding of a vertex of the input
  */
  std::optional<Place> place(const Input& input, const std::array<double, 3>& weights) const {
    const Plane_point<double> p = combination(weights);
    Place result;
    result.region = middle_region();
    walk(p, result);
    const std::array<double, 3> in_triangle = barycentric(triangles_[result.triangle], p);
    return rounded(input, in_triangle, result) ? std::optional(result) : std::nullopt;
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
      const Plane_point<double> d =
          approximate(vector({result.triangle, result.weights}, corner_[k]));
      if (d.x == 0 && d.y == 0) return std::nullopt;
    }
    return result;
  }

  /*!
  \brief computes the values at a vertex that is inserted at a place.
  \return squared lengths of ip, jp, kp and quadruple areas of ijp, jkp, kip, which are positive if and only if the
  place is in the face
  */
  Values values(const Place& p) const {
    const Corner at{p.triangle, p.weights};
    std::array<Point, 3> to;
    Values result;
    for (unsigned k = 0; k < 3; ++k) {
      to[k] = vector(at, corner_[k]);
      result.squared_lengths[k] = unit_ * dot(to[k], to[k]);
    }
    for (unsigned k = 0; k < 3; ++k)
      result.quadruple_areas[k] = (unit_ + unit_) * cross(to[k], to[(k + 1) % 3]);
    return result;
  }

  /*!
  \brief finds the point of the input at a point of the face, without rounding it.
  \param weights barycentric coordinates of the point in the face
  \return the point, and the direction of its halfedge from the first side of the face
  */
  Mapped_point locate(const std::array<double, 3>& weights) const {
    const Plane_point<double> p = combination(weights);
    Place place;
    place.region = middle_region();
    walk(p, place);
    const Triangle& t = triangles_[place.triangle];
    const Plane_point<double> d = approximate(t.point[1]) - approximate(t.point[0]);
    const Plane_point<double> side =
        approximate(position(corner_[1])) - approximate(position(corner_[0]));
    const double length = std::sqrt(dot(d, d) * dot(side, side));
    return {
        {t.halfedge, barycentric(t, p)}, {dot(side, d) / length, cross(side, d) / length}, {1, 0}};
  }

private:
  struct Triangle {
    std::uint32_t halfedge;     // by which it is entered, but for the first one
    std::uint32_t parent;       // entered from; itself for the first one
    std::array<Point, 3> point; // source, target, apex
  };
  struct Corner {
    std::uint32_t triangle;
    std::array<double, 3> weights;
  };

  static Plane_point<double> approximate(const Point& p) {
    return {CGAL::to_double(p.x), CGAL::to_double(p.y)};
  }
  std::uint32_t last() const { return static_cast<std::uint32_t>(triangles_.size() - 1); }

  // the input halfedges of the faces that a side enters first, in order
  template <class Complex, class Coordinates>
  void find_entered(const Complex& complex, const Coordinates& coordinates, std::uint32_t side,
                    Normal_coordinate count) {
    entered_.resize(static_cast<std::size_t>(count));
    if constexpr (requires { coordinates.entered_by(side, count); }) {
      for (Normal_coordinate i = 0; i < count; ++i)
        entered_[static_cast<std::size_t>(i)] = coordinates.entered_by(side, i);
    } else {
      follow_curves(complex, coordinates, {side, 0, count, 0}, stack_,
                    [&](Normal_coordinate i, const Curve_end& end) {
                      entered_[static_cast<std::size_t>(i)] = input_halfedge(coordinates, end) ^ 1U;
                    });
    }
  }

  // of the last triangle, whose first side runs between two points
  template <class Input_values>
  void place_corners(const Point& from, const Point& to, const Input_values& values) {
    const Face_values<FT> v = values(triangles_.back().halfedge);
    const auto& [ij, jk, ki] = v.squared_lengths;
    const FT scale = FT(1) / (ij + ij);
    const Point turn{(ij + ki - jk) * scale, v.quadruple_area * scale};
    triangles_.back().point = {from, to, from + (to - from) * turn};
  }

  // across input halfedge x, out of a triangle
  template <class Input_values>
  void add(const Input& input, std::uint32_t parent, std::uint32_t x, const Input_values& values) {
    triangles_.push_back({x, parent, {}});
    const unsigned m = side_towards(input, last());
    const std::array<Point, 3>& from = triangles_[parent].point;
    place_corners(Point(from[(m + 1) % 3]), Point(from[m]), values);
  }

  // the triangle of the region that `passed` curves cut off corner k do not cut off from it
  std::uint32_t region_at(unsigned k, Normal_coordinate passed) const {
    if (k == first_) return static_cast<std::uint32_t>(passed);
    if (k == (first_ + 1) % 3) return static_cast<std::uint32_t>(along_ - passed);
    if (passed == curves_.cutting[k]) return static_cast<std::uint32_t>(curves_.cutting[first_]);
    return static_cast<std::uint32_t>(along_ + curves_.cutting[k] - passed);
  }

  Point position(const Corner& c) const {
    const std::array<Point, 3>& z = triangles_[c.triangle].point;
    if (c.weights[0] == 1) return z[0];
    if (c.weights[1] == 1) return z[1];
    const Point a = z[1] - z[0], b = z[2] - z[0];
    const FT s(c.weights[1]), t(c.weights[2]);
    return {z[0].x + s * a.x + t * b.x, z[0].y + s * a.y + t * b.y};
  }

  // from a corner to another one; in one triangle differences of weights are exact
  Point vector(const Corner& from, Corner to) const {
    if (from.triangle != to.triangle) {
      const std::optional<unsigned> shared = shared_point(from.triangle, to);
      if (!shared) return position(to) - position(from);
      to = {from.triangle, {}};
      to.weights[*shared] = 1;
    }
    const std::array<Point, 3>& z = triangles_[from.triangle].point;
    const Point a = z[1] - z[0], b = z[2] - z[0];
    const FT s(to.weights[1] - from.weights[1]), t(to.weights[2] - from.weights[2]);
    return {s * a.x + t * b.x, s * a.y + t * b.y};
  }

  // the point of a triangle that a corner is at, if it was copied there
  std::optional<unsigned> shared_point(std::uint32_t triangle, const Corner& c) const {
    for (unsigned m = 0; m < 3; ++m) {
      if (c.weights[m] != 1) continue;
      const Point& p = triangles_[c.triangle].point[m];
      for (unsigned l = 0; l < 3; ++l)
        if (is_same(triangles_[triangle].point[l], p)) return l;
    }
    return std::nullopt;
  }
  static bool is_same(const Point& p, const Point& q) {
    return CGAL::to_interval(p.x) == CGAL::to_interval(q.x) &&
           CGAL::to_interval(p.y) == CGAL::to_interval(q.y);
  }

  Plane_point<double> combination(const std::array<double, 3>& weights) const {
    Plane_point<double> p{0, 0};
    for (unsigned k = 0; k < 3; ++k) {
      const Plane_point<double> z = approximate(position(corner_[k]));
      p = {p.x + weights[k] * z.x, p.y + weights[k] * z.y};
    }
    return p;
  }

  Face_region middle_region() const {
    Face_region r;
    r.cutting = curves_.cutting;
    r.fan_corner = fan_;
    return r;
  }

  // whether a point is beyond the side by which triangle t is entered
  bool is_in(std::uint32_t t, const Plane_point<double>& p) const {
    const Plane_point<double> a = approximate(triangles_[t].point[0]),
                              b = approximate(triangles_[t].point[1]), d = b - a, q = p - a;
    return d.x * q.y - d.y * q.x > 0;
  }

  // to the region that contains a point
  void walk(const Plane_point<double>& p, Place& result) const {
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

  static std::array<double, 3> barycentric(const Triangle& t, const Plane_point<double>& p) {
    const Plane_point<double> from = approximate(t.point[0]), side = approximate(t.point[1]) - from;
    const auto seen = [&](const Plane_point<double>& q) {
      const Plane_point<double> v = q - from;
      return Plane_point<double>{dot(side, v) / dot(side, side), cross(side, v) / dot(side, side)};
    };
    return weights_above_side(seen(p), seen(approximate(t.point[2])));
  }

  // relative distance from a curve within which a point is put on it: a few roundings of a circumcenter
  static constexpr double nearness = 0x1p-40;

  bool rounded(const Input& input, std::array<double, 3> w, Place& result) const {
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

  // the side of its parent over which a triangle is entered
  unsigned side_towards(const Input& input, std::uint32_t child) const {
    const std::uint32_t out = triangles_[child].halfedge ^ 1U,
                        first = triangles_[triangles_[child].parent].halfedge;
    return out == first ? 0 : out == input.next(first) ? 1 : 2;
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

  std::array<std::uint32_t, 3> sides_{};
  Corner_coordinates curves_{};
  unsigned first_ = 0;          // corner from which the strip along a side starts
  unsigned fan_ = 3;            // corner opposite that side, if curves emanate from it
  Normal_coordinate along_ = 0; // number of curves across that side
  std::vector<Triangle> triangles_;
  std::array<Corner, 3> corner_{};
  FT unit_{};
  std::vector<std::uint32_t> entered_;
  std::vector<Curve_bundle> stack_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_UNFOLDED_FACE_H
