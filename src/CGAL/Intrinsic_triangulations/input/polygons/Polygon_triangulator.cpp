// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/Space_vector.h>
#include <CGAL/Intrinsic_triangulations/input/polygons/Point_kernel.h>
#include <CGAL/Intrinsic_triangulations/input/polygons/Polygon_triangulator.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

template <class Triangulation>
void mark_outside(Triangulation& plane) {
  for (const auto f : plane.all_face_handles()) f->info() = false;
  std::vector<typename Triangulation::Face_handle> open{plane.infinite_face()};
  open.back()->info() = true;
  while (!open.empty()) {
    const auto f = open.back();
    open.pop_back();
    for (int k = 0; k < 3; ++k)
      if (!f->is_constrained(k) && !f->neighbor(k)->info()) {
        f->neighbor(k)->info() = true;
        open.push_back(f->neighbor(k));
      }
  }
}

void Polygon_triangulator::load(std::vector<Point> points) {
  points_ = std::move(points);
  const Point origin = points_[0];
  const int exponent = exponent_of_extent(points_);
  for (Point& p : points_)
    for (unsigned k = 0; k < 3; ++k) p[k] = std::scalbn(p[k] / 2 - origin[k] / 2, -exponent);
  normal_ = {};
  for (std::size_t i = 2; i < points_.size(); ++i) {
    const Point c = cross(0, i - 1, i);
    for (unsigned k = 0; k < 3; ++k) normal_[k] += c[k];
  }
}

bool Polygon_triangulator::triangulate(std::vector<Triangle>& result) const {
  if (points_.size() == 4) {
    const bool at_0 = inner_product(cross(0, 1, 2), cross(0, 2, 3)) >
                      inner_product(cross(1, 2, 3), cross(1, 3, 0));
    if (at_0)
      result = {{0, 1, 2}, {0, 2, 3}};
    else
      result = {{1, 2, 3}, {1, 3, 0}};
    return true;
  }
  return triangulate_delaunay(result) ||
         triangulate_least_area([](std::size_t, std::size_t) { return true; }, false, result);
}

bool Polygon_triangulator::triangulate_least_area(
    const std::function<bool(std::size_t, std::size_t)>& allowed, bool upright,
    std::vector<Triangle>& result) const {
  const std::size_t n = points_.size();
  if (n > maximal_sides) return false;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> cost(n * n, 0);
  std::vector<std::uint32_t> apex(n * n, 0);
  for (std::size_t width = 2; width < n; ++width)
    for (std::size_t i = 0; i + width < n; ++i) {
      const std::size_t j = i + width;
      double best = infinity;
      if (width == n - 1 || allowed(i, j))
        for (std::size_t k = i + 1; k < j; ++k) {
          const double c = cost[i * n + k] + cost[k * n + j] + weight(i, k, j, upright);
          if (c >= best) continue;
          best = c;
          apex[i * n + j] = static_cast<std::uint32_t>(k);
        }
      const Point diagonal = difference(points_[j], points_[i]);
      // triangulations of a convex polygon in a plane have the same area: short diagonals decide
      cost[i * n + j] = best + 1e-9 * inner_product(diagonal, diagonal);
    }
  if (cost[n - 1] == infinity) return false;
  collect(apex, result);
  return true;
}

double Polygon_triangulator::weight(std::size_t i, std::size_t j, std::size_t k,
                                    bool upright) const {
  const Point c = cross(i, j, k);
  const double against = -inner_product(c, normal_); // up to 1e-9 it is a triangle without area
  if (upright && against > 1e-9 * inner_product(normal_, normal_))
    return std::numeric_limits<double>::infinity();
  return std::sqrt(inner_product(c, c));
}

void Polygon_triangulator::collect(const std::vector<std::uint32_t>& apex,
                                   std::vector<Triangle>& result) const {
  const std::size_t n = points_.size();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open{{0, static_cast<std::uint32_t>(n - 1)}};
  result.clear();
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j - i < 2) continue;
    const std::uint32_t k = apex[i * n + j];
    result.push_back({i, k, j});
    open.emplace_back(k, j);
    open.emplace_back(i, k);
  }
}

bool Polygon_triangulator::triangulate_delaunay(std::vector<Triangle>& result) const {
  using Traits = CGAL::Projection_traits_3<Point_kernel>;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Traits>;
  using Info_base = CGAL::Triangulation_face_base_with_info_2<bool, Traits>;
  using Face_base = CGAL::Constrained_triangulation_face_base_2<Traits, Info_base>;
  using Data = CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>;
  using Triangulation =
      CGAL::Constrained_Delaunay_triangulation_2<Traits, Data,
                                                 CGAL::No_constraint_intersection_tag>;
  if (normal_ == Point{}) return false;
  Triangulation plane{Traits(Point_kernel::Vector_3(normal_[0], normal_[1], normal_[2]))};
  std::vector<Triangulation::Vertex_handle> vertices;
  for (const Point& p : points_) {
    vertices.push_back(plane.insert(Point_kernel::Point_3(p[0], p[1], p[2])));
    vertices.back()->info() = static_cast<std::uint32_t>(vertices.size() - 1);
  }
  if (plane.number_of_vertices() != points_.size()) return false;
  try {
    for (std::size_t i = 0; i < vertices.size(); ++i)
      plane.insert_constraint(vertices[i], vertices[(i + 1) % vertices.size()]);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return false;
  }
  mark_outside(plane);
  result.clear();
  for (const auto f : plane.finite_face_handles())
    if (!f->info())
      result.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return orient_disk(result);
}

bool Polygon_triangulator::orient_disk(std::vector<Triangle>& triangles) const {
  const auto n = static_cast<std::uint32_t>(points_.size());
  if (triangles.size() != n - 2) return false;
  using Side = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Side> sides;
  for (const Triangle& t : triangles)
    for (unsigned k = 0; k < 3; ++k) sides.emplace_back(t[k], t[(k + 1) % 3]);
  std::sort(sides.begin(), sides.end());
  const auto has = [&](std::uint32_t i, std::uint32_t j) {
    return std::binary_search(sides.begin(), sides.end(), Side(i, j));
  };
  const bool reversed = has(1, 0);
  for (std::uint32_t i = 0; i < n; ++i)
    if (has(i, (i + 1) % n) == reversed || has((i + 1) % n, i) != reversed) return false;
  for (const auto& [i, j] : sides)
    if ((j + n - i) % n != 1 && (i + n - j) % n != 1 && !has(j, i)) return false;
  if (std::adjacent_find(sides.begin(), sides.end()) != sides.end()) return false;
  if (reversed)
    for (Triangle& t : triangles) std::swap(t[1], t[2]);
  return true;
}

Polygon_triangulator::Point Polygon_triangulator::cross(std::size_t i, std::size_t j,
                                                        std::size_t k) const {
  return cross_product(difference(points_[j], points_[i]), difference(points_[k], points_[i]));
}

} // namespace CGAL::Intrinsic_triangulations::internal
