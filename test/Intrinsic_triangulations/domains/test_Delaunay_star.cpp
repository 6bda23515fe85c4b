// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/domains/Delaunay_star.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace {

using CGAL::Intrinsic_triangulations::internal::Delaunay_star;
using Points = std::vector<std::array<double, 2>>;
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Delaunay_star::Neighbour in_plane(const std::array<double, 2>& at, std::uint32_t number) {
  return {at, number, {at[0], at[1], 0}};
}

// the sides opposite the origin of the triangles there, sorted
Pairs star(const Points& points) {
  std::vector<Delaunay_star::Neighbour> s;
  for (std::uint32_t i = 0; i < points.size(); ++i) s.push_back(in_plane(points[i], i));
  const bool is_closed = Delaunay_star::find(s) == Delaunay_star::Extent::closed;
  Pairs result;
  for (std::size_t i = 0; i + 1 < s.size(); ++i) result.emplace_back(s[i].number, s[i + 1].number);
  if (is_closed) result.emplace_back(s.back().number, s.front().number);
  std::sort(result.begin(), result.end());
  return result;
}

// the same by CGAL
Pairs star_of_triangulation(const Points& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Data = CGAL::Triangulation_data_structure_2<
      CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>>;
  CGAL::Delaunay_triangulation_2<Kernel, Data> t;
  const auto center = t.insert(Kernel::Point_2(0, 0));
  for (std::uint32_t i = 0; i < points.size(); ++i)
    t.insert(Kernel::Point_2(points[i][0], points[i][1]))->info() = i;
  Pairs result;
  if (t.dimension() < 2) return result;
  auto f = t.incident_faces(center);
  const auto end = f;
  do {
    if (t.is_infinite(f)) continue;
    const int k = f->index(center);
    result.emplace_back(f->vertex(t.ccw(k))->info(), f->vertex(t.cw(k))->info());
  } while (++f != end);
  std::sort(result.begin(), result.end());
  return result;
}

TEST(Delaunay_star, is_that_of_the_triangulation) {
  std::mt19937 random(5);
  std::normal_distribution<double> x;
  for (int run = 0; run < 500; ++run) {
    Points points(2 + static_cast<std::size_t>(run) % 30);
    const double shift = run % 3 == 0 ? 0 : 1.5; // then the origin is often on the hull
    for (auto& p : points) p = {x(random) + shift, x(random)};
    EXPECT_EQ(star(points), star_of_triangulation(points)) << run;
  }
}

// Points of a lattice about the origin, some of which are left out: many are in one direction, on
// one line through the origin, or on one circle. Turned and rounded, they have the same star.
TEST(Delaunay_star, stays_when_points_are_turned) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> angle(0, 2 * M_PI);
  for (int run = 0; run < 200; ++run) {
    const double scale = run % 2 == 0 ? 1 : 1e-70;
    const double c = std::cos(angle(random)), slope = std::sqrt(1 - c * c);
    Points points, turned;
    for (int x = -2; x <= 2; ++x)
      for (int y = -2; y <= 2; ++y) {
        if ((x == 0 && y == 0) || random() % 3 == 0) continue;
        points.push_back({double(x), double(y)});
        turned.push_back({scale * (c * x - slope * y), scale * (slope * x + c * y)});
      }
    EXPECT_EQ(star(points), star(turned)) << run;
  }
}

// A quadrilateral that is bent a little, unfolded about each of its corners: it has one diagonal.
TEST(Delaunay_star, has_the_same_diagonal_from_every_corner_of_a_bent_quadrilateral) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> x(-0.03, 0.03);
  for (int run = 0; run < 500; ++run) {
    std::array<std::array<double, 3>, 4> z{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
    for (auto& p : z)
      for (double& coordinate : p) coordinate += x(random);
    std::array<bool, 4> has_diagonal{};
    for (std::uint32_t k = 0; k < 4; ++k) {
      std::vector<Delaunay_star::Neighbour> s;
      for (std::uint32_t i = 1; i < 4; ++i) {
        const auto &p = z[(k + i) % 4], &c = z[k];
        const std::array<double, 3> v{p[0] - c[0], p[1] - c[1], p[2] - c[2]};
        const double factor = std::hypot(1, v[2] / std::hypot(v[0], v[1])); // keeps distances
        s.push_back({{factor * v[0], factor * v[1]}, (k + i) % 4, v});
      }
      Delaunay_star::find(s);
      has_diagonal[k] = s.size() == 3;
    }
    EXPECT_EQ(has_diagonal[0], has_diagonal[2]) << run;
    EXPECT_EQ(has_diagonal[1], has_diagonal[3]) << run;
    EXPECT_NE(has_diagonal[0], has_diagonal[1]) << run;
  }
}

TEST(Delaunay_star, compares_distances_whose_squares_vanish) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> x(-1, 1);
  for (int run = 0; run < 100; ++run) {
    Points points(12);
    for (auto& p : points) p = {1e-170 * x(random), 1e-170 * x(random)};
    EXPECT_EQ(star(points), star_of_triangulation(points)) << run;
  }
}

TEST(Delaunay_star, has_no_triangles_on_a_line) {
  EXPECT_EQ(star({{1, 1}, {2, 2}, {-3, -3}}), Pairs{});
  EXPECT_EQ(star({{1, 0}}), Pairs{});
  EXPECT_EQ(star({}), Pairs{});
  EXPECT_EQ(star({{0, 0}, {0, 0}, {1, 0}}), Pairs{});
  EXPECT_EQ(star({{1, 0}, {-1, 0}, {0, 1}}), (Pairs{{0, 2}, {2, 1}}));
}

TEST(Delaunay_star, leaves_out_what_is_behind_another_point) {
  EXPECT_EQ(star({{3, 0}, {1, 0}, {0, 2}, {0, 1}, {2, 0}}), (Pairs{{1, 3}}));
}

TEST(Delaunay_star, leaves_points_at_one_place_in_the_plane_out) {
  EXPECT_EQ(star({{1, 0}, {0, 1}, {0, 1}, {-1, 0.5}, {0, 2}}), (Pairs{{0, 3}}));
}

// numbers of the neighbours whose edges are kept, and whether they are tied
using Tied = std::vector<std::pair<std::uint32_t, bool>>;
Tied tied(const Points& points, std::size_t center, std::size_t first) {
  std::vector<Delaunay_star::Neighbour> s;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::size_t i = (first + k) % points.size();
    const std::array at{points[i][0] - points[center][0], points[i][1] - points[center][1]};
    if (i != center) s.push_back(in_plane(at, static_cast<std::uint32_t>(i)));
  }
  Delaunay_star::find(s);
  Tied result;
  for (const auto& a : s) result.emplace_back(a.number, a.is_tied());
  std::sort(result.begin(), result.end());
  return result;
}

TEST(Delaunay_star, keeps_and_marks_all_edges_between_points_on_a_circle) {
  const Points circle{{5, 0}, {4, 3}, {3, 4}, {0, 5}, {-3, 4}, {-4, 3}, {-5, 0}, {0, -5}};
  for (std::uint32_t center = 0; center < 8; ++center) {
    Tied expected;
    for (std::uint32_t i = 0; i < 8; ++i)
      if (i != center) expected.emplace_back(i, i != (center + 1) % 8 && i != (center + 7) % 8);
    for (std::size_t first = 0; first < 8; ++first)
      EXPECT_EQ(tied(circle, center, first), expected) << center << ", " << first;
  }
}

TEST(Delaunay_star, angles_decide_near_a_circle_in_any_unit) {
  for (const double unit : {1., 1e-75}) // products of two angles' numbers are below the range
    for (const double off : {-0x1p-18, 0x1p-18}) {
      const double x = unit * (1 + off);
      Tied expected{{1, false}, {2, false}, {3, false}};
      if (off > 0) expected.erase(expected.begin() + 1);
      EXPECT_EQ(tied({{0, 0}, {unit, 0}, {x, x}, {0, unit}}, 0, 0), expected)
          << unit << ", " << off;
    }
}

// On the border circle of a tube the plane that fits is tilted: points of the circle are below.
TEST(Delaunay_star, is_open_at_the_border_of_a_tube) {
  for (const double tilt : {-0.2, -0.05, 0.05, 0.2}) {
    std::vector<Delaunay_star::Neighbour> s;
    for (int i = -3; i <= 3; ++i)
      for (int j = 0; j <= 2; ++j) {
        if (i == 0 && j == 0) continue;
        const double a = i * M_PI / 8;
        const std::array<double, 3> v{std::sin(a), 0.4 * j, std::cos(a) - 1};
        const double x = v[0], y = std::cos(tilt) * v[1] + std::sin(tilt) * v[2];
        const double factor =
            std::sqrt((v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / (x * x + y * y));
        s.push_back({{factor * x, factor * y}, static_cast<std::uint32_t>(3 * (i + 3) + j), v});
      }
    EXPECT_NE(Delaunay_star::find(s), Delaunay_star::Extent::closed) << tilt;
    ASSERT_GE(s.size(), 3U) << tilt;
    EXPECT_EQ(s.front().number, 12U) << tilt;
    EXPECT_EQ(s.back().number, 6U) << tilt;
  }
}

} // namespace
