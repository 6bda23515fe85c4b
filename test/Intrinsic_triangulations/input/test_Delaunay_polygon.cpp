// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/input/Delaunay_polygon_impl.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

// Against CGAL's triangulations and polygons of the plane.

namespace {

namespace polygons = CGAL::Intrinsic_triangulations::internal;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Corner = Kernel::Point_2;
using Point = polygons::Delaunay_polygon::Point;
using Triangle = polygons::Delaunay_polygon::Triangle;

/// Triangles in any order, each from its least corner on.
std::set<Triangle> sorted(const std::vector<Triangle>& triangles) {
  std::set<Triangle> result;
  for (Triangle t : triangles) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    result.insert(t);
  }
  return result;
}

/// Points over the corners, at heights that are not to matter.
std::vector<Point> lifted(const std::vector<Corner>& corners, std::mt19937& random) {
  std::vector<Point> result;
  for (const Corner& p : corners)
    result.push_back({p.x(), p.y(), static_cast<double>(random() % 5) / 4});
  return result;
}

/// The constrained Delaunay triangulation by CGAL, of a polygon that turns to the left.
std::set<Triangle> triangulation_by_cgal(const std::vector<Corner>& corners) {
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
  using Data =
      CGAL::Triangulation_data_structure_2<Vertex_base,
                                           CGAL::Constrained_triangulation_face_base_2<Kernel>>;
  CGAL::Constrained_Delaunay_triangulation_2<Kernel, Data> plane;
  std::vector<decltype(plane)::Vertex_handle> vertices;
  for (const Corner& p : corners) {
    vertices.push_back(plane.insert(p));
    vertices.back()->info() = static_cast<std::uint32_t>(vertices.size() - 1);
  }
  for (std::size_t i = 0; i < vertices.size(); ++i)
    plane.insert_constraint(vertices[i], vertices[(i + 1) % vertices.size()]);
  std::vector<Triangle> result;
  for (const auto f : plane.finite_face_handles()) {
    const Triangle t{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()};
    const Corner middle = CGAL::centroid(corners[t[0]], corners[t[1]], corners[t[2]]);
    if (CGAL::bounded_side_2(corners.begin(), corners.end(), middle) == CGAL::ON_BOUNDED_SIDE)
      result.push_back(t);
  }
  return sorted(result);
}

/// Corners seen from the origin in order, so that nothing crosses.
std::vector<Corner> star(std::size_t n, std::mt19937& random) {
  std::uniform_real_distribution<double> radius(0.1, 1);
  std::vector<Corner> result;
  for (std::size_t k = 0; k < n; ++k) {
    const double r = radius(random),
                 angle = 2 * M_PI * static_cast<double>(k) / static_cast<double>(n);
    result.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return result;
}

TEST(Delaunay_polygon, is_that_of_cgal_whatever_the_heights_of_corners_are) {
  std::mt19937 random(1);
  for (int round = 0; round < 100; ++round) {
    const std::vector<Corner> corners = star(5 + random() % 40, random);
    const std::vector<Point> points = lifted(corners, random);
    polygons::Delaunay_polygon polygon(points, {0, 0, 1});
    ASSERT_TRUE(polygon.is_simple());
    std::vector<Triangle> triangles;
    ASSERT_TRUE(polygon.triangulate(triangles));
    ASSERT_EQ(sorted(triangles), triangulation_by_cgal(corners)) << "seed 1, round " << round;
  }
}

TEST(Delaunay_polygon, is_simple_where_cgal_says_so_on_small_grids) {
  std::mt19937 random(2);
  std::array<int, 2> simple{};
  for (int round = 0; round < 20000; ++round) {
    std::vector<Corner> corners;
    const std::size_t n = 5 + random() % 4;
    for (std::size_t k = 0; k < n; ++k)
      corners.emplace_back(static_cast<double>(random() % 5), static_cast<double>(random() % 5));
    const bool expected = CGAL::is_simple_2(corners.begin(), corners.end());
    ++simple[expected];
    const std::vector<Point> points = lifted(corners, random);
    polygons::Delaunay_polygon polygon(points, {0, 0, 1});
    ASSERT_EQ(polygon.is_simple(), expected) << "seed 2, round " << round;
    if (!expected) continue;
    const CGAL::Orientation turn = CGAL::orientation_2(corners.begin(), corners.end());
    std::vector<Triangle> triangles;
    ASSERT_EQ(polygon.triangulate(triangles), turn == CGAL::LEFT_TURN);
    if (turn != CGAL::LEFT_TURN) continue;
    double area = 0; // exactly
    for (const auto& [i, j, k] : triangles) {
      EXPECT_EQ(CGAL::orientation(corners[i], corners[j], corners[k]), CGAL::LEFT_TURN);
      area += CGAL::area(corners[i], corners[j], corners[k]);
    }
    EXPECT_EQ(triangles.size(), n - 2);
    EXPECT_EQ(area, CGAL::polygon_area_2(corners.begin(), corners.end(), Kernel()));
  }
  EXPECT_GT(simple[0], 1000);
  EXPECT_GT(simple[1], 500);
}

TEST(Delaunay_polygon, looks_along_any_normal) {
  std::mt19937 random(3);
  const std::vector<Corner> corners = star(30, random);
  const std::set<Triangle> expected = triangulation_by_cgal(corners);
  for (std::size_t turn = 0; turn < 3; ++turn)
    for (const double sign : {1.0, -1.0}) {
      std::vector<Point> points;
      for (const Corner& p : corners) {
        Point q{};
        q[turn] = p.x();
        q[(turn + 1) % 3] = sign * p.y();
        q[(turn + 2) % 3] = static_cast<double>(random() % 7);
        points.push_back(q);
      }
      Point normal{};
      normal[(turn + 2) % 3] = sign * 0x1p-20;
      polygons::Delaunay_polygon polygon(points, normal);
      ASSERT_TRUE(polygon.is_simple());
      std::vector<Triangle> triangles;
      ASSERT_TRUE(polygon.triangulate(triangles));
      EXPECT_EQ(sorted(triangles), expected);
    }
}

} // namespace
