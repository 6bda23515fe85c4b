// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/input/polygons/Polygon_flattener.h>

#include "meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::internal::Polygon_flattener;
using Point = std::array<double, 3>;
using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;

using meshes::distance;

// by the cosine rule
double angle(const Point& before, const Point& here, const Point& after) {
  const double a = distance(here, before), b = distance(here, after), c = distance(before, after);
  return std::acos((a * a + b * b - c * c) / (2 * a * b));
}

std::vector<Complex> flattened(const std::vector<Point>& points) {
  Polygon_flattener flattener;
  EXPECT_FALSE(Polygon_flattener::is_planar(points));
  EXPECT_TRUE(flattener.run(points));
  std::vector<Complex> result;
  for (const auto& p : flattener.corners()) result.emplace_back(p[0], p[1]);
  return result;
}

double interior_angle(const std::vector<Complex>& p, std::size_t i) {
  const std::size_t n = p.size();
  const double a = std::arg((p[(i + n - 1) % n] - p[i]) / (p[(i + 1) % n] - p[i]));
  return a < 0 ? a + 2 * pi : a;
}

void expect_same_sides(const std::vector<Complex>& p, const std::vector<Point>& points) {
  ASSERT_EQ(p.size(), points.size());
  double perimeter = 0, sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    perimeter += distance(points[i], points[(i + 1) % p.size()]);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const std::size_t j = (i + 1) % p.size();
    EXPECT_NEAR(std::abs(p[j] - p[i]), distance(points[i], points[j]), 1e-14 * perimeter);
    sum += interior_angle(p, i);
  }
  EXPECT_NEAR(sum, (static_cast<double>(p.size()) - 2) * pi, 1e-12);
}

// corners at the same distance from the axis, up and down
std::vector<Point> skew_polygon(std::size_t n, double height) {
  std::vector<Point> result;
  for (std::size_t i = 0; i < n; ++i) {
    const double a = 2 * pi * static_cast<double>(i) / static_cast<double>(n);
    result.push_back({std::cos(a), std::sin(a), i % 2 == 0 ? height : -height});
  }
  return result;
}

TEST(Polygon_flattener, regular_skew_polygons_become_regular) {
  for (const std::size_t n : {4U, 6U, 8U, 12U, 40U})
    for (const double height : {1e-6, 0.1, 0.5, std::sqrt(0.5), 3.0, 100.0}) {
      const std::vector<Point> points = skew_polygon(n, height);
      const std::vector<Complex> p = flattened(points);
      expect_same_sides(p, points);
      for (std::size_t i = 0; i < n; ++i)
        EXPECT_NEAR(interior_angle(p, i), (1 - 2 / static_cast<double>(n)) * pi, 1e-9)
            << n << ' ' << height;
    }
}

// Angles a, b, a, b of a skew rhombus become a + d, b + d with a + b + 2d = pi.
TEST(Polygon_flattener, skew_rhombi_become_rhombi) {
  for (const double x : {0.3, 1.0, 1.7})
    for (const double height : {0.05, 0.4}) {
      const std::vector<Point> points{{x, 0, height}, {0, 1, 0}, {-x, 0, height}, {0, -1, 0}};
      const std::vector<Complex> p = flattened(points);
      expect_same_sides(p, points);
      const double a = angle(points[3], points[0], points[1]),
                   b = angle(points[0], points[1], points[2]);
      for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(interior_angle(p, i), i % 2 == 0 ? (a + pi - b) / 2 : (b + pi - a) / 2, 1e-12);
    }
}

TEST(Polygon_flattener, skew_kites_become_kites) {
  const std::vector<Point> points{{2, 0, 0}, {0, 1, 0.3}, {-1, 0, 0}, {0, -1, 0.3}};
  const std::vector<Complex> p = flattened(points);
  expect_same_sides(p, points);
  EXPECT_NEAR(interior_angle(p, 1), interior_angle(p, 3), 1e-12);
}

// The sum of squared changes of exterior angles, and the closed polygon with given directions of sides.
struct Problem {
  std::vector<double> lengths, targets;

  double value(const std::vector<double>& directions) const {
    double sum = 0;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      const double before = i == 0 ? directions.back() - 2 * pi : directions[i - 1];
      const double d = directions[i] - before - targets[i];
      sum += d * d;
    }
    return sum;
  }
  // Turns two sides so that the polygon closes: the two circles around its gap.
  bool close(std::vector<double>& directions, std::size_t i, std::size_t j) const {
    Complex rest = 0;
    for (std::size_t k = 0; k < lengths.size(); ++k)
      if (k != i && k != j) rest -= std::polar(lengths[k], directions[k]);
    const double r = std::abs(rest), a = lengths[i], b = lengths[j];
    const double cosine = (r * r + a * a - b * b) / (2 * r * a);
    if (std::abs(cosine) > 1) return false;
    double best = 1;
    const double old = directions[i];
    for (const double sign : {-1.0, 1.0}) {
      const double turned = std::arg(rest) + sign * std::acos(cosine);
      const double change = std::remainder(turned - old, 2 * pi);
      if (std::abs(change) >= best) continue;
      best = std::abs(change);
      directions[i] = old + change;
    }
    directions[j] +=
        std::remainder(std::arg(rest - std::polar(a, directions[i])) - directions[j], 2 * pi);
    return best < 1;
  }
};

Problem problem_of(const std::vector<Point>& points) {
  Problem result;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    result.lengths.push_back(distance(points[i], points[(i + 1) % n]));
    result.targets.push_back(pi - angle(points[(i + n - 1) % n], points[i], points[(i + 1) % n]));
  }
  return result;
}

TEST(Polygon_flattener, no_closed_polygon_near_by_has_nearer_angles) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-1, 1);
  for (const std::size_t n : {4U, 5U, 7U, 12U})
    for (int round = 0; round < 20; ++round) {
      std::vector<Point> points = skew_polygon(n, 0);
      for (Point& p : points)
        for (double& x : p) x += 0.15 * noise(random) / static_cast<double>(n);
      const Problem problem = problem_of(points);
      const std::vector<Complex> p = flattened(points);
      std::vector<double> directions;
      double direction = std::arg(p[1] - p[0]);
      for (std::size_t i = 0; i < n; ++i) {
        directions.push_back(direction);
        direction += pi - interior_angle(p, (i + 1) % n);
      }
      const double least = problem.value(directions);
      for (const double size : {1e-1, 1e-2, 1e-3})
        for (int k = 0; k < 20; ++k) {
          std::vector<double> other(directions);
          for (double& x : other) x += size * noise(random);
          const std::size_t i = random() % n;
          if (problem.close(other, i, (i + 1 + random() % (n - 1)) % n)) {
            EXPECT_GE(problem.value(other), least - 1e-13) << n << ' ' << round << ' ' << size;
          }
        }
    }
}

TEST(Polygon_flattener, reflex_corners_stay_reflex) {
  // an L, bent
  const std::vector<Point> points{{0, 0, 0},   {2, 0, 0.1}, {2, 1, 0},
                                  {1, 1, 0.1}, {1, 2, 0},   {0, 2, -0.1}};
  const std::vector<Complex> p = flattened(points);
  expect_same_sides(p, points);
  EXPECT_NEAR(interior_angle(p, 3), 1.5 * pi, 0.1);
}

TEST(Polygon_flattener, size_and_place_do_not_matter) {
  const std::vector<Point> points{{0, 0, 0}, {2, 0, 0.5}, {2, 1, 0}, {1, 2, 0.25}, {0, 2, -1}};
  const std::vector<Complex> p = flattened(points);
  for (const double scale : {0x1p-1000, 0x1p-300, 0x1p500, 0x1p1020}) {
    std::vector<Point> other(points);
    for (Point& q : other)
      for (double& x : q) x *= scale;
    const std::vector<Complex> q = flattened(other);
    for (std::size_t i = 0; i < p.size(); ++i) EXPECT_EQ(q[i] / scale, p[i]) << scale;
  }
}

TEST(Polygon_flattener, planar_polygons_are_recognized) {
  EXPECT_TRUE(Polygon_flattener::is_planar({{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}));
  EXPECT_FALSE(Polygon_flattener::is_planar({{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1 + 1e-13}}));
  // all in a line, all at a point, three points, a sliver
  EXPECT_TRUE(Polygon_flattener::is_planar({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 2, 2}}));
  EXPECT_TRUE(Polygon_flattener::is_planar(std::vector<Point>(5, Point{1, 2, 3})));
  EXPECT_TRUE(Polygon_flattener::is_planar({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 7}}));
  EXPECT_TRUE(Polygon_flattener::is_planar({{0, 0, 0}, {1, 1, 1e-30}, {2, 2, 2e-30}, {1, 1, 0.0}}));
  // a square in a plane that no rounded points are in
  std::vector<Point> square;
  for (int i = 0; i < 4; ++i) {
    const double x = std::cos(i * pi / 2 + 1), y = std::sin(i * pi / 2 + 1);
    square.push_back({x * 0.6 + 100, y, 0.8 * x + 1.0 / 3});
  }
  EXPECT_TRUE(Polygon_flattener::is_planar(square));
}

TEST(Polygon_flattener, refuses_what_has_no_angles) {
  Polygon_flattener f;
  EXPECT_FALSE(
      f.run({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}})); // a side of length 0
  std::vector<Point> eight; // both loops have the same area, and none to the side
  for (int i = 0; i < 12; ++i) {
    const double t = (i + 0.5) * pi / 6;
    eight.push_back({std::cos(t), std::sin(2 * t), 0.1 * std::cos(3 * t)});
  }
  EXPECT_FALSE(f.run(eight));
  EXPECT_FALSE(Polygon_flattener::is_planar(eight));
}

// almost twice the same segment: there is hardly another polygon
TEST(Polygon_flattener, ends_on_polygons_that_are_nearly_flat) {
  for (const double e : {1e-1, 1e-3, 1e-5, 1e-7, 1e-9}) {
    const std::vector<Point> points{{0, 0, 0}, {1, e, e}, {2, -e, 0}, {3, 0, e}, {1.5, -2 * e, -e}};
    Polygon_flattener f;
    if (!f.run(points)) continue;
    std::vector<Complex> p;
    for (const auto& q : f.corners()) p.emplace_back(q[0], q[1]);
    expect_same_sides(p, points);
  }
}

} // namespace
