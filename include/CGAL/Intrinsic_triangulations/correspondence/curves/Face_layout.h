// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_FACE_LAYOUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_FACE_LAYOUT_H

#include <CGAL/Intrinsic_triangulations/correspondence/curves/CurveCoordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/weights_above_side.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

inline double approximation(double x) { return x; }
inline double approximation(const Interval_nt<false>& x) { return CGAL::to_double(x); }
template <class Center>
double approximation(const Ball<Center>& x) {
  return x.to_double();
}

// whether a number may be a copy of another one
inline bool are_identical(double x, double y) { return x == y; }
inline bool are_identical(const Interval_nt<false>& x, const Interval_nt<false>& y) {
  return x.inf() == y.inf() && x.sup() == y.sup();
}
template <class Center>
bool are_identical(const Ball<Center>& x, const Ball<Center>& y) {
  return x.is_identical(y);
}

} // namespace internal

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
\brief unfolds the input triangles over which an intrinsic face lies.

The curves (input edges) in a face ijk cut off corners or emanate from one corner. In the first case a middle
region is left, from which the regions at each corner are reached across the curves that cut it off; in the second
the regions form one strip along the side opposite that corner. Each lies in one input triangle. All are known from
the lists of the curves that cross one or two sides (§3.5 of the course).

Nothing but the input and integers enters: errors do not depend on the moves that made the face. Coordinates are
such that the first side of the first triangle runs from 0 to 1. Memory stays from face to face.
\tparam FT `double`, `Interval_nt<false>` or a `Ball`
*/
template <class FT>
class Face_layout {
public:
  /// A point of the plane.
  using Point = Plane_vector<FT>;
  /// Values at an inserted vertex: of ip, jp, kp and of ijp, jkp, kip.
  using Values = Vertex_move_values<FT>;

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
    for (unsigned k = 0; k < 3; ++k) corners[k] = corner_on_input(complex, coordinates, sides_[k]);
    const Input& input = coordinates.input();
    triangles_.clear();
    unit_ = values(corners[first_].halfedge).squared_lengths[0];
    triangles_.push_back({corners[first_].halfedge, 0, {}});
    place_corners({FT(0), FT(0)}, {FT(1), FT(0)}, values);
    along_ = crossings(coordinates.normal_coordinate(sides_[first_] / 2));
    find_entered_along(complex, coordinates);
    for (const std::uint32_t x : entered_) add(input, last(), x, values);
    if (fan_ == 3) {
      const unsigned third = (first_ + 2) % 3;
      entered_.resize(static_cast<std::size_t>(curves_.cutting[third]));
      find_entered(complex, coordinates, sides_[third], 0, curves_.cutting[third]);
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
  \brief computes the values at a vertex that is inserted in the face.
  \param triangle the number of an unfolded triangle
  \param weights barycentric coordinates of the vertex there, multiples of 2^-52
  \return squared lengths of ip, jp, kp and quadruple areas of ijp, jkp, kip, which are positive if and only if the
  place is in the face
  */
  Values values(std::uint32_t triangle, const std::array<double, 3>& weights) const {
    const Corner at{triangle, weights};
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

  /// returns how many steps were taken so far along curves.
  std::size_t steps() const { return steps_; }

protected:
  /// \cond
  struct Triangle {
    std::uint32_t halfedge;     // by which it is entered, but for the first one
    std::uint32_t parent;       // entered from; itself for the first one
    std::array<Point, 3> point; // source, target, apex
  };
  struct Corner {
    std::uint32_t triangle;
    std::array<double, 3> weights;
  };

  static Plane_vector<double> approximate(const Point& p) {
    return {internal::approximation(p.x), internal::approximation(p.y)};
  }
  std::uint32_t last() const { return static_cast<std::uint32_t>(triangles_.size() - 1); }

  // the input halfedges of the faces that the strip enters along its side, in order; curves from the corner opposite need
  // not be followed
  template <class Complex, class Coordinates>
  void find_entered_along(const Complex& complex, const Coordinates& coordinates) {
    entered_.resize(static_cast<std::size_t>(along_));
    const Normal_coordinate from = fan_ < 3 ? curves_.cutting[first_] : along_,
                            to = fan_ < 3 ? from + curves_.emanating[fan_] : along_;
    find_entered(complex, coordinates, sides_[first_], 0, from);
    for (Normal_coordinate i = from; i < to; ++i)
      entered_[static_cast<std::size_t>(i)] =
          input_halfedge(coordinates, Curve_end{sides_[fan_], i - from});
    find_entered(complex, coordinates, sides_[first_], to, along_);
  }

  // of those that a side enters, numbers `from` to `to`
  template <class Complex, class Coordinates>
  void find_entered(const Complex& complex, const Coordinates& coordinates, std::uint32_t side,
                    Normal_coordinate from, Normal_coordinate to) {
    if (from == to) return;
    if (internal::are_crossings_known(coordinates)) {
      for (Normal_coordinate i = from; i < to; ++i)
        entered_[static_cast<std::size_t>(i)] = internal::entered_by(coordinates, side, i);
    } else {
      steps_ += follow_curves(complex, coordinates, {side, from, to - from, from}, stack_,
                              [&](Normal_coordinate i, const Curve_end& end) {
                                entered_[static_cast<std::size_t>(i)] =
                                    input_halfedge(coordinates, end) ^ 1U;
                              });
    }
  }

  // of the last triangle, whose first side runs between two points; of the first one from 0 to 1
  template <class Input_values>
  void place_corners(const Point& from, const Point& to, const Input_values& values) {
    const Face_values<FT> v = values(triangles_.back().halfedge);
    const auto& [ij, jk, ki] = v.squared_lengths;
    const Point turn = apex(ij, jk, ki, v.quadruple_area);
    triangles_.back().point = {from, to, triangles_.size() == 1 ? turn : from + (to - from) * turn};
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
    return internal::are_identical(p.x, q.x) && internal::are_identical(p.y, q.y);
  }

  Plane_vector<double> combination(const std::array<double, 3>& weights) const {
    Plane_vector<double> p{0, 0};
    for (unsigned k = 0; k < 3; ++k) {
      const Plane_vector<double> z = approximate(position(corner_[k]));
      p = {p.x + weights[k] * z.x, p.y + weights[k] * z.y};
    }
    return p;
  }

  // the side of its parent over which a triangle is entered
  unsigned side_towards(const Input& input, std::uint32_t child) const {
    const std::uint32_t out = triangles_[child].halfedge ^ 1U,
                        first = triangles_[triangles_[child].parent].halfedge;
    return out == first ? 0 : out == input.next(first) ? 1 : 2;
  }

  /// \endcond

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
  std::size_t steps_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_FACE_LAYOUT_H
