// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGON_SHAPER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGON_SHAPER_H

#include <CGAL/Intrinsic_triangulations/input/Planar_polygons.h>
#include <CGAL/Intrinsic_triangulations/input/polygons/Polygon_flattener.h>
#include <CGAL/Intrinsic_triangulations/input/polygons/Polygon_triangulator.h>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The amount that changes the squared distance of two points in space to that of two points in a
// plane. It does not depend on the power of two by which coordinates are scaled.
inline double planar_excess(const std::array<double, 3>& p, const std::array<double, 3>& q,
                            const std::array<double, 2>& a, const std::array<double, 2>& b) {
  const double u = a[0] - b[0], v = a[1] - b[1];
  const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
  return (u * u + v * v) - (x * x + y * y + z * z);
}

// Makes triangles of a polygon in space: of itself, or of the planar polygon that takes its place.
class Polygon_shaper {
public:
  using Point = Polygon_triangulator::Point;
  using Triangle = Polygon_triangulator::Triangle;

  explicit Polygon_shaper(Nonplanar_polygons kind) : kind_(kind) {}

  // Takes a polygon, and makes it planar if the option says so.
  // \param is_simple whether its vertices are distinct
  void load(std::vector<Point> points, bool is_simple = true);
  // Discards the planar polygon.
  void keep();

  // Cuts it as `Polygon_triangulator` does; a planar polygon that crosses itself is discarded.
  // Returns false if all fails.
  bool triangulate(std::vector<Triangle>& result);
  // Returns false if there is no triangulation with such diagonals.
  bool triangulate_with(const std::function<bool(std::size_t, std::size_t)>& allowed,
                        std::vector<Triangle>& result) const;

  // whether the triangles are those of the planar polygon
  bool is_flattened() const { return is_flattened_; }
  // counts the polygon in the report
  void count(Polygon_report& report) const;
  const std::vector<Planar_polygons::Point>& planar_points() const { return flattener_.corners(); }
  double largest_angle_change() const { return flattener_.largest_angle_change(); }

private:
  // of four corners: along the diagonal that is Delaunay
  bool triangulate_planar(std::vector<Triangle>& result) const;
  // whether lengths of sides in space and of diagonals in the plane are those of triangles
  bool are_triangles(const std::vector<Triangle>& triangles) const;
  bool is_triangle(const Triangle& t) const;

  Nonplanar_polygons kind_;
  std::vector<Point> points_;
  bool is_planar_ = false, is_flattened_ = false;
  Polygon_flattener flattener_;
  Polygon_triangulator triangulator_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGON_SHAPER_H
