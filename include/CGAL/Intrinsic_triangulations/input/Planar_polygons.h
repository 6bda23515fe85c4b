// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_PLANAR_POLYGONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_PLANAR_POLYGONS_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief says what is made of faces whose corners do not lie in a plane.
*/
enum class Nonplanar_polygons {
  fan, ///< triangles in space, as if the polygon was planar: their diagonals give it a shape
  /*!
  The planar polygon with the same sides, whose interior angles are nearest to those in space: the
  sum of the squares of their changes is least ("Nonplanar faces" in chapter 7 of the course).
  Angles in space are those between the sides, above pi where the polygon turns clockwise, seen
  along its vector area.
  */
  planar
};

/*!
\brief reports the result for polygons, if nonplanar ones were to become planar.

It is counted for faces with more than three sides.
*/
struct Polygon_report {
  std::size_t planar = 0; ///< those that are planar, exactly or but for the rounding of coordinates
  std::size_t flattened = 0; ///< those that became planar
  /*!
  Those that remain triangles in space, because their vector area is zero, a side has length zero, a
  vertex occurs twice, the planar polygon crosses itself, or a diagonal joins vertices that another
  edge joins.
  */
  std::size_t kept = 0;
  double largest_angle_change = 0; ///< largest change of an interior angle, in radians
};

/*!
\brief holds the planar polygons that took the place of those in space, each in a frame of its own.

They have the corners of the user's faces, in their order, and the lengths of their sides.
*/
class Planar_polygons {
public:
  /// Coordinates in the plane of a polygon, counterclockwise around it, in the units of the user.
  using Point = std::array<double, 2>;
  /// A polygon.
  struct Polygon {
    std::span<const std::uint32_t> vertices; ///< numbers of the user's vertices
    std::span<const Point> points; ///< their places in the plane; empty: there is no such polygon
    std::span<const std::uint32_t>
        sorted; ///< numbers of the corners, in the order of their vertices
    /// returns the number of the corner at a vertex; the number of corners if there is none.
    /// \complexity logarithmic
    std::size_t corner(std::uint32_t vertex) const;
    /// tells whether two corners are the ends of a side
    bool is_side(std::size_t i, std::size_t j) const {
      const std::size_t apart = i < j ? j - i : i - j;
      return apart == 1 || apart + 1 == points.size();
    }
  };

  /// appends a polygon. \pre `face` is above those before, and no vertex is there twice \complexity
  /// n log n
  void add(std::uint32_t face, std::span<const std::uint32_t> vertices,
           std::span<const Point> points);
  /// tells whether there are none.
  bool empty() const { return face_.empty(); }
  /// returns the number of polygons.
  std::size_t size() const { return face_.size(); }
  /// returns the user's number of face `i` of those that became planar.
  std::uint32_t face(std::size_t i) const { return face_[i]; }
  /// returns the planar polygon of the user's face; without points if it has none. \complexity
  /// logarithmic
  Polygon operator()(std::uint32_t face) const;

  /// Reports the result for all polygons.
  Polygon_report report;

private:
  std::vector<std::uint32_t> face_;
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> vertices_;
  std::vector<Point> points_;
  std::vector<std::uint32_t> sorted_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_PLANAR_POLYGONS_H
