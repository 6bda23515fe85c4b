// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVE_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVE_STRIP_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/corner_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/follow_curve.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a point in the plane, in any number type.
\tparam FT a model of `Field`
*/
template <class FT>
struct Plane_point {
  FT x; ///< first coordinate
  FT y; ///< second coordinate

  friend Plane_point operator+(const Plane_point& a, const Plane_point& b) {
    return {a.x + b.x, a.y + b.y};
  }
  friend Plane_point operator-(const Plane_point& a, const Plane_point& b) {
    return {a.x - b.x, a.y - b.y};
  }
  /// product of complex numbers: turns and stretches
  friend Plane_point operator*(const Plane_point& a, const Plane_point& b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
  }
};

/*!
\brief is the strip of faces through which a curve passes a given face, unfolded into the plane.

The first face has points 0, 1, 2 for its corners, in the plane at 0, 1 and where its shape puts the
third. Each other triangle is joined to the side between two points and adds a point. Unfolding is a
sequence of rational operations in squared lengths and quadruple areas, thus possible in any field.
*/
class Curve_strip {
public:
  /// A triangle of the strip, across the side from point `start` to point `end` counterclockwise.
  struct Triangle {
    std::array<std::uint32_t, 3> edges; ///< that side, the next and the last one
    std::uint32_t face;                 ///< the face
    std::uint32_t entered;              ///< halfedge of that side
    std::uint32_t start;                ///< first end of the side
    std::uint32_t end;                  ///< second end of the side
  };

  /*!
  \brief unfolds the faces along a curve.
  \param complex the intrinsic triangulation
  \param coordinates its normal coordinates
  \param sides the sides of the first face
  \param crossing where the curve leaves that face
  */
  template <class Complex, class Coordinates>
  Curve_strip(const Complex& complex, const Coordinates& coordinates,
              const std::array<std::uint32_t, 3>& sides, const Curve_crossing& crossing) {
    triangles_.push_back({edges(sides), complex.face(sides[0]), sides[0], 0, 1});
    unsigned out = 0;
    while (sides[out] != crossing.halfedge) ++out;
    const Corner_coordinates c = corner_coordinates(complex, coordinates, sides[0]);
    const Normal_coordinate n = coordinates.normal_coordinate(sides[out] / 2);
    const Normal_coordinate to_target = n - 1 - crossing.position;
    const unsigned left = (out + 1) % 3, right = (out + 2) % 3;
    end_ = follow(complex, coordinates, crossing, {out, left}, last_);
    if (crossing.position < c.cutting[out]) { // about the source of the side, from the last side
      const Normal_coordinate m = coordinates.normal_coordinate(sides[right] / 2);
      start_ = follow(complex, coordinates, {sides[right], m - 1 - crossing.position}, {right, out},
                      first_);
    } else if (to_target < c.cutting[left]) { // about its target, from the next side
      start_ = follow(complex, coordinates, {sides[left], to_target}, {left, right}, first_);
    } else {
      first_ = right;
      start_ = {sides[right], crossing.position - c.cutting[out]};
    }
  }

  /// returns the triangles; number `n` adds point `n + 2`.
  const std::vector<Triangle>& triangles() const { return triangles_; }
  /// returns the number of the point where the curve starts.
  std::uint32_t first() const { return first_; }
  /// returns the number of the point where the curve ends.
  std::uint32_t last() const { return last_; }
  /// returns the corner from which the curve starts.
  const Curve_end& start() const { return start_; }
  /// returns the corner in which the curve ends, as the start of the way back.
  const Curve_end& end() const { return end_; }

  /*!
  \brief unfolds the strip.
  \tparam FT a model of `Field`
  \param metric returns squared lengths and quadruple areas
  \return the positions of the points; the unit is the first side
  */
  template <class FT, class Metric>
  std::vector<Plane_point<FT>> unfold(const Metric& metric) const {
    std::vector<Plane_point<FT>> points{{FT(0), FT(0)}, {FT(1), FT(0)}};
    points.reserve(triangles_.size() + 2);
    for (const Triangle& t : triangles_) {
      const FT ij = metric.squared_length(t.edges[0]);
      const FT p = ij + metric.squared_length(t.edges[2]) - metric.squared_length(t.edges[1]);
      const FT scale = FT(1) / (ij + ij);
      const Plane_point<FT> turn{p * scale, metric.quadruple_area(t.face) * scale};
      points.push_back(points[t.start] + (points[t.end] - points[t.start]) * turn);
    }
    return points;
  }

private:
  static std::array<std::uint32_t, 3> edges(const std::array<std::uint32_t, 3>& s) {
    return {s[0] / 2, s[1] / 2, s[2] / 2};
  }

  // Adds the triangles from a crossing on, whose halfedge runs between two `points`.
  template <class Complex, class Coordinates>
  Curve_end follow(const Complex& complex, const Coordinates& coordinates,
                   const Curve_crossing& crossing, std::array<std::uint32_t, 2> points,
                   std::uint32_t& apex) {
    std::uint32_t entered = Gluing::none; // halfedge through which the last triangle was entered
    return follow_curve(complex, coordinates, crossing, [&](const Curve_crossing& c) {
      if (entered != Gluing::none) {
        if (c.halfedge == complex.next(entered))
          points = {points[0], apex}; // from the target of the entered halfedge
        else
          points = {apex, points[1]};
      }
      entered = c.halfedge ^ 1U;
      apex = static_cast<std::uint32_t>(triangles_.size()) + 2;
      triangles_.push_back({edges(sides_of_face(complex, entered)), complex.face(entered), entered,
                            points[1], points[0]});
    });
  }

  std::vector<Triangle> triangles_;
  std::uint32_t first_ = 0, last_ = 0;
  Curve_end start_{}, end_{};
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVE_STRIP_H
