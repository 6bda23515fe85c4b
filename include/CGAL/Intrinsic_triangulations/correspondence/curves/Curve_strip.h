// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CURVE_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CURVE_STRIP_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/weights_above_side.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

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
    std::uint32_t entered; ///< halfedge of that side
    std::uint32_t start;   ///< first end of the side
    std::uint32_t end;     ///< second end of the side
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
    add(sides, complex.face(sides[0]), 0, 1);
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
  /// returns the face of each triangle and its sides, that to the triangle before first.
  std::span<const Indexed_face> faces() const { return faces_; }
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
  \param values what squared lengths and quadruple areas the `faces()` have
  \return the positions of the points; the unit is the first side
  */
  template <class FT>
  std::vector<Plane_vector<FT>> unfold(std::span<const Face_values<FT>> values) const {
    std::vector<Plane_vector<FT>> points{{FT(0), FT(0)}, {FT(1), FT(0)}};
    points.reserve(triangles_.size() + 2);
    for (std::size_t n = 0; n < triangles_.size(); ++n) {
      const Triangle& t = triangles_[n];
      const auto& [ij, jk, ki] = values[n].squared_lengths;
      points.push_back(points[t.start] + (points[t.end] - points[t.start]) *
                                             apex(ij, jk, ki, values[n].quadruple_area));
    }
    return points;
  }

  /// the same, with the values that `complex` has in double precision
  template <class Complex>
  std::vector<Plane_vector<double>> unfold_approximately(const Complex& complex) const {
    std::vector<Face_values<double>> values;
    values.reserve(faces_.size());
    for (std::size_t n = 0; n < faces_.size(); ++n)
      values.push_back({squared_lengths_of_face(complex, triangles_[n].entered),
                        complex.quadruple_area(faces_[n].face)});
    return unfold<double>(values);
  }

private:
  void add(const std::array<std::uint32_t, 3>& sides, std::uint32_t face, std::uint32_t start,
           std::uint32_t end) {
    triangles_.push_back({sides[0], start, end});
    faces_.push_back({face, {sides[0] / 2, sides[1] / 2, sides[2] / 2}});
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
      add(sides_of_face(complex, entered), complex.face(entered), points[1], points[0]);
    });
  }

  std::vector<Triangle> triangles_;
  std::vector<Indexed_face> faces_;
  std::uint32_t first_ = 0, last_ = 0;
  Curve_end start_{}, end_{};
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CURVE_STRIP_H
