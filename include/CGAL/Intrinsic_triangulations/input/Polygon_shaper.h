// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGON_SHAPER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGON_SHAPER_H

#include <CGAL/Intrinsic_triangulations/input/Planar_polygons.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
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

// Triangulates one polygon in space; corners are numbered from 0 along its boundary.
class Polygon_triangulator {
public:
  using Point = std::array<double, 3>;
  using Triangle = std::array<std::uint32_t, 3>;

  // The polygon is moved to the origin and scaled to unit size by a power of two, so that areas
  // neither overflow nor underflow.
  void load(std::vector<Point> points);

  // A quadrilateral is cut as CGAL::Polygon_mesh_processing::triangulate_faces() cuts it: the
  // scalar product of the normals is the greater. Others are triangulated by constrained Delaunay
  // in the plane normal to their vector area, or with least area if their boundary crosses itself
  // there. Returns false if all of it fails.
  bool triangulate(std::vector<Triangle>& result) const;

  // Dynamic programming: of all triangulations whose diagonals are `allowed`, and without a
  // triangle turned against the polygon if `upright`, the one of least area, hence a valid one if
  // the polygon is plane. The lengths of the diagonals decide between equal areas. Returns false if
  // there is none.
  bool triangulate_least_area(const std::function<bool(std::size_t, std::size_t)>& allowed,
                              bool upright, std::vector<Triangle>& result) const;

  // Returns false if the polygon crosses itself in the plane normal to its vector area.
  bool triangulate_delaunay(std::vector<Triangle>& result) const;

private:
  // The time grows with the cube of the sides: 0.2 seconds for a knot of so many.
  static constexpr std::size_t maximal_sides = 512;

  // the area of a triangle; infinite if it must be upright and is not
  double weight(std::size_t i, std::size_t j, std::size_t k, bool upright) const;
  void collect(const std::vector<std::uint32_t>& apex, std::vector<Triangle>& result) const;

  // Orients the triangles as the polygon and checks that they are a disk bounded by it.
  bool orient_disk(std::vector<Triangle>& triangles) const;

  // twice the vector area of a triangle
  Point cross(std::size_t i, std::size_t j, std::size_t k) const;

  std::vector<Point> points_;
  Point normal_{};
};

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
