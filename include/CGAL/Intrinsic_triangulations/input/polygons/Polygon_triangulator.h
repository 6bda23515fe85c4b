// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGONS_POLYGON_TRIANGULATOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGONS_POLYGON_TRIANGULATOR_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

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

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGONS_POLYGON_TRIANGULATOR_H
