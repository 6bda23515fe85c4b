// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/Planar_polygons.h>
#include <CGAL/Intrinsic_triangulations/input/Polygon_shaper.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Gmpq.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

void Polygon_shaper::load(std::vector<Point> points, bool is_simple) {
  is_flattened_ = false;
  if (kind_ == Nonplanar_polygons::planar) {
    points_ = points;
    is_planar_ = Polygon_flattener::is_planar(points);
    is_flattened_ = !is_planar_ && is_simple && flattener_.run(points);
  }
  if (is_flattened_)
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] = {planar_points()[i][0], planar_points()[i][1], 0};
  triangulator_.load(std::move(points));
}

void Polygon_shaper::keep() {
  if (!is_flattened_) return;
  is_flattened_ = false;
  triangulator_.load(points_);
}

bool Polygon_shaper::triangulate(std::vector<Triangle>& result) {
  if (is_flattened_) {
    if (triangulate_planar(result) && are_triangles(result)) return true;
    keep();
  }
  return triangulator_.triangulate(result);
}

bool Polygon_shaper::triangulate_with(const std::function<bool(std::size_t, std::size_t)>& allowed,
                                      std::vector<Triangle>& result) const {
  return triangulator_.triangulate_least_area(allowed, true, result) &&
         (!is_flattened_ || are_triangles(result));
}

void Polygon_shaper::count(Polygon_report& report) const {
  if (kind_ == Nonplanar_polygons::fan) return;
  ++(is_flattened_ ? report.flattened : is_planar_ ? report.planar : report.kept);
  if (is_flattened_)
    report.largest_angle_change = std::max(report.largest_angle_change, largest_angle_change());
}

bool Polygon_shaper::triangulate_planar(std::vector<Triangle>& result) const {
  if (points_.size() > 4) return triangulator_.triangulate_delaunay(result);
  const std::vector<Planar_polygons::Point>& p = planar_points();
  // twice the area, and the scalar product of the sides, at corner j of triangle ijk
  const auto at = [&p](std::size_t i, std::size_t j, std::size_t k) {
    const double x = p[k][0] - p[j][0], y = p[k][1] - p[j][1], u = p[i][0] - p[j][0],
                 v = p[i][1] - p[j][1];
    return std::array{x * v - y * u, x * u + y * v};
  };
  const std::array corner{at(3, 0, 1), at(0, 1, 2), at(1, 2, 3), at(2, 3, 0)};
  const bool can_02 = corner[1][0] > 0 && corner[3][0] > 0,
             can_13 = corner[0][0] > 0 && corner[2][0] > 0;
  if (!can_02 && !can_13) return false;
  // the angles at 1 and 3 are together at most pi
  const double excess = corner[1][0] * corner[3][1] + corner[3][0] * corner[1][1];
  if (can_02 && (!can_13 || excess >= 0))
    result = {{0, 1, 2}, {0, 2, 3}};
  else
    result = {{1, 2, 3}, {1, 3, 0}};
  return true;
}

bool Polygon_shaper::are_triangles(const std::vector<Triangle>& triangles) const {
  return std::all_of(triangles.begin(), triangles.end(),
                     [this](const Triangle& t) { return is_triangle(t); });
}

bool Polygon_shaper::is_triangle(const Triangle& t) const {
  const auto scaled = [exponent = flattener_.exponent()](auto p) {
    for (double& x : p) x = std::scalbn(x, -exponent);
    return p;
  };
  std::array<Point, 3> p;
  std::array<Planar_polygons::Point, 3> q;
  for (std::size_t k = 0; k < 3; ++k) {
    p[k] = scaled(points_[t[k]]);
    q[k] = scaled(planar_points()[t[k]]);
  }
  std::array<double, 3> excess{};
  for (std::size_t k = 0; k < 3; ++k)
    if (const std::size_t i = t[k], j = t[(k + 1) % 3], n = points_.size();
        (i + 1) % n != j && (j + 1) % n != i)
      excess[k] = planar_excess(p[k], p[(k + 1) % 3], q[k], q[(k + 1) % 3]);
  const auto squared_area = [&]<class FT>(FT) {
    std::array<FT, 3> l;
    for (std::size_t k = 0; k < 3; ++k)
      l[k] = Input_metric::squared_distance<FT>(p[k], p[(k + 1) % 3]) + FT(excess[k]);
    return std::pair(squared_quadruple_area(l[0], l[1], l[2]), l[0] * l[2]);
  };
  const auto [area, scale] = squared_area(0.0);
  // above rounding; rationals decide on all else
  if (area > 0x1p-30 * scale && area > 0x1p-40) return true;
  return squared_area(CGAL::Gmpq(0)).first >= CGAL::Gmpq(0);
}

} // namespace CGAL::Intrinsic_triangulations::internal
