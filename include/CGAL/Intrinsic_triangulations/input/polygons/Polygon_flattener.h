// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGONS_POLYGON_FLATTENER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGONS_POLYGON_FLATTENER_H

#include <array>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Makes a polygon in space planar: its sides keep their lengths, its angles change least.
class Polygon_flattener {
public:
  using Point = std::array<double, 3>;
  using Planar_point = std::array<double, 2>;

  // Whether all points lie in one plane, exactly or so near to it as rounding of coordinates may
  // bring them.
  static bool is_planar(const std::vector<Point>& points);

  // Returns whether there is a result. \pre there are at least four points, not all in one plane
  bool run(const std::vector<Point>& points);

  // in the units of the points, counterclockwise
  const std::vector<Planar_point>& corners() const { return corners_; }
  double largest_angle_change() const { return largest_angle_change_; }
  // of a power of two that is near to the size of the polygon
  int exponent() const { return exponent_; }

private:
  bool measure(const std::vector<Point>& points);
  // the exterior angles of the projection along the vector area
  std::vector<double> projected_angles() const;
  void place(const std::vector<double>& directions);

  std::vector<Point> sides_; // scaled by 2^-exponent_, as all that follows
  Point normal_{};           // the vector area, of length 1
  std::vector<double> lengths_, targets_;
  double perimeter_ = 0;
  int exponent_ = 0;
  std::vector<Planar_point> corners_;
  double largest_angle_change_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGONS_POLYGON_FLATTENER_H
