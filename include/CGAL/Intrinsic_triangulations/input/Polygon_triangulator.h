// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGON_TRIANGULATOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGON_TRIANGULATOR_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Triangulates one polygon in space; corners are numbered from 0 along its boundary. A template, so that
// only programs with polygons compile it.
template <class Kernel = CGAL::Exact_predicates_inexact_constructions_kernel>
class Polygon_triangulator {
  using Point = typename Kernel::Point_3;
  using Vector = typename Kernel::Vector_3;

public:
  using Triangle = std::array<std::uint32_t, 3>;

  // The polygon is moved to the origin and scaled to unit size by a power of two, so that areas
  // neither overflow nor underflow.
  template <class Point_of_corner>
  void load(std::size_t n, Point_of_corner point_of_corner) {
    points_.clear();
    const std::array<double, 3> origin = point_of_corner(0);
    double extent = 0;
    for (std::size_t i = 0; i < n; ++i)
      for (unsigned k = 0; k < 3; ++k)
        extent = std::max(extent, std::abs(point_of_corner(i)[k] / 2 - origin[k] / 2));
    const int exponent = extent > 0 ? std::ilogb(extent) : 0;
    const auto scaled = [exponent](double x, double x0) {
      return std::scalbn(x / 2 - x0 / 2, -exponent);
    };
    for (std::size_t i = 0; i < n; ++i) {
      const std::array<double, 3> p = point_of_corner(i);
      points_.emplace_back(scaled(p[0], origin[0]), scaled(p[1], origin[1]),
                           scaled(p[2], origin[2]));
    }
    normal_ = Vector(0, 0, 0);
    for (std::size_t i = 2; i < n; ++i) normal_ = normal_ + cross(0, i - 1, i);
  }

  // A quadrilateral is cut as CGAL::Polygon_mesh_processing::triangulate_faces() cuts it: the
  // scalar product of the normals is the greater. Others are triangulated by constrained Delaunay
  // in the plane normal to their vector area, or with least area if their boundary crosses itself
  // there. Returns false if all of it fails.
  bool triangulate(std::vector<Triangle>& result) {
    if (points_.size() == 4) {
      const bool at_0 = cross(0, 1, 2) * cross(0, 2, 3) > cross(1, 2, 3) * cross(1, 3, 0);
      if (at_0)
        result = {{0, 1, 2}, {0, 2, 3}};
      else
        result = {{1, 2, 3}, {1, 3, 0}};
      return true;
    }
    return triangulate_delaunay(result) ||
           triangulate_least_area([](std::size_t, std::size_t) { return true; }, false, result);
  }

  // Dynamic programming: of all triangulations whose diagonals are `allowed`, and without a
  // triangle turned against the polygon if `upright`, the one of least area, hence a valid one if
  // the polygon is plane. Equal areas are told apart by the lengths of the diagonals. Returns false
  // if there is none.
  template <class Allowed>
  bool triangulate_least_area(Allowed allowed, bool upright, std::vector<Triangle>& result) const {
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
        cost[i * n + j] = best + 1e-9 * (points_[j] - points_[i]).squared_length();
      }
    if (cost[n - 1] == infinity) return false;
    collect(apex, result);
    return true;
  }

private:
  static constexpr std::size_t maximal_sides = 512;

  Vector cross(std::size_t i, std::size_t j, std::size_t k) const {
    return CGAL::cross_product(points_[j] - points_[i], points_[k] - points_[i]);
  }

  double weight(std::size_t i, std::size_t j, std::size_t k, bool upright) const {
    const Vector c = cross(i, j, k);
    const double against = -(c * normal_);
    if (upright && against > 1e-9 * normal_.squared_length())
      return std::numeric_limits<double>::infinity();
    return std::sqrt(c.squared_length());
  }

  void collect(const std::vector<std::uint32_t>& apex, std::vector<Triangle>& result) const {
    const std::size_t n = points_.size();
    std::vector<std::pair<std::uint32_t, std::uint32_t>> open{
        {0, static_cast<std::uint32_t>(n - 1)}};
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

  // Not inline: it takes seconds to compile, see `extern template`.
  bool triangulate_delaunay(std::vector<Triangle>& result) const;

  template <class Triangulation>
  static void mark_outside(Triangulation& plane) {
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

  // Orients the triangles as the polygon and checks that they are a disk bounded by it.
  bool orient_disk(std::vector<Triangle>& triangles) const {
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

  std::vector<Point> points_;
  Vector normal_;
};

template <class Kernel>
bool Polygon_triangulator<Kernel>::triangulate_delaunay(std::vector<Triangle>& result) const {
  using Traits = CGAL::Projection_traits_3<Kernel>;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Traits>;
  using Info_base = CGAL::Triangulation_face_base_with_info_2<bool, Traits>;
  using Face_base = CGAL::Constrained_triangulation_face_base_2<Traits, Info_base>;
  using Data = CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>;
  using Triangulation =
      CGAL::Constrained_Delaunay_triangulation_2<Traits, Data,
                                                 CGAL::No_constraint_intersection_tag>;
  if (normal_ == CGAL::NULL_VECTOR) return false;
  Triangulation plane{Traits(normal_)};
  std::vector<typename Triangulation::Vertex_handle> vertices;
  for (const Point& p : points_) {
    vertices.push_back(plane.insert(p));
    vertices.back()->info() = static_cast<std::uint32_t>(vertices.size() - 1);
  }
  if (plane.number_of_vertices() != points_.size()) return false;
  try {
    for (std::size_t i = 0; i < vertices.size(); ++i)
      plane.insert_constraint(vertices[i], vertices[(i + 1) % vertices.size()]);
  } catch (const typename Triangulation::Intersection_of_constraints_exception&) {
    return false;
  }
  mark_outside(plane);
  result.clear();
  for (const auto f : plane.finite_face_handles())
    if (!f->info())
      result.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return orient_disk(result);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGON_TRIANGULATOR_H
