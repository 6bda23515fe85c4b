// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/apex.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using Point = IT::Plane_vector<Gmpq>;

Gmpq squared_distance(const Point& p, const Point& q) { return dot(q - p, q - p); }

// Draws three points, counterclockwise.
template <class Random>
std::array<Point, 3> draw(Random& random) {
  std::uniform_int_distribution<int> coordinate(-1000, 1000);
  std::array<Point, 3> p;
  do {
    for (Point& q : p) q = {Gmpq(coordinate(random)), Gmpq(coordinate(random))};
  } while (cross(p[1] - p[0], p[2] - p[0]) <= Gmpq(0));
  return p;
}

TEST(Apex, places_the_third_corner_in_any_field) {
  std::mt19937 random(1);
  for (int n = 0; n < 200; ++n) {
    const auto [i, j, k] = draw(random);
    const Gmpq ij = squared_distance(i, j), jk = squared_distance(j, k),
               ki = squared_distance(k, i), area = Gmpq(2) * cross(j - i, k - i);
    const Point apex = IT::apex(ij, jk, ki, area);
    EXPECT_EQ(i + (j - i) * apex, k);
    EXPECT_EQ(IT::scaled_corner(ij, jk, ki, area), Gmpq(2) * in_frame(j - i, k - i));
    const auto number = [](const Gmpq& x) { return CGAL::to_double(x); };
    const auto rounded = IT::apex(number(ij), number(jk), number(ki), number(area));
    EXPECT_DOUBLE_EQ(rounded.x, number(apex.x));
    EXPECT_DOUBLE_EQ(rounded.y, number(apex.y));
    using Interval = CGAL::Interval_nt<>;
    const auto enclosed = IT::apex(Interval(number(ij)), Interval(number(jk)), Interval(number(ki)),
                                   Interval(number(area)));
    EXPECT_LE(Gmpq(enclosed.x.inf()), apex.x);
    EXPECT_GE(Gmpq(enclosed.x.sup()), apex.x);
    EXPECT_LE(Gmpq(enclosed.y.inf()), apex.y);
    EXPECT_GE(Gmpq(enclosed.y.sup()), apex.y);
  }
}

TEST(Plane_vector, is_read_by_name_and_by_number) {
  IT::Plane_vector<double> v{3, 4};
  v[1] = 5;
  EXPECT_EQ(v, (IT::Plane_vector<double>{3, 5}));
  EXPECT_EQ(v[0], v.x);
  EXPECT_EQ(2. * v - v / 1., v);
}

using Place = IT::Plane_vector<double>;

// The point with the weights that are found is where the point was, up to rounding of coordinates,
// however thin the triangle.
void expect_reproduced(const Place& apex, const std::array<double, 3>& w) {
  const Place p{w[1] + w[2] * apex.x, w[2] * apex.y};
  const std::array<double, 3> found = IT::weights_in_triangle(p, {0, 0}, {1, 0}, apex);
  for (const double x : found) EXPECT_GE(x, 0);
  EXPECT_NEAR(found[0] + found[1] + found[2], 1, 0x1p-50);
  const Place q{found[1] + found[2] * apex.x, found[2] * apex.y};
  const double size = 1 + std::abs(apex.x) + apex.y;
  EXPECT_LE(std::hypot(q.x - p.x, q.y - p.y), 0x1p-48 * size)
      << "apex " << apex.x << " " << apex.y << ", weights " << w[0] << " " << w[1] << " " << w[2];
}

TEST(weights_in_triangle, reproduce_points_in_fat_and_thin_triangles) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const double height : {1.0, 1e-3, 1e-8, 1e-15, 1e-30, 1e-300})
    for (const double x : {0.5, 0.0, 1.0, 1e-9, 1e-17, -1e-17, 1 - 1e-9, -3.0, 40.0, -1e-9})
      for (int i = 0; i < 200; ++i) {
        const double s = unit(random), t = unit(random) * (1 - s);
        expect_reproduced({x, height}, {s, t, 1 - s - t});
        expect_reproduced({x, height}, {s, 1 - s, 0});
        expect_reproduced({x, height}, {0, s, 1 - s});
        expect_reproduced({x, height}, {s, 0, 1 - s});
      }
}

TEST(weights_in_triangle, reproduce_points_of_triangles_without_area) {
  for (const double x : {0.25, -2.0, 5.0})
    for (const double s : {0.0, 0.5, 1.0}) {
      expect_reproduced({x, 0}, {s, 1 - s, 0});
      expect_reproduced({x, 0}, {0, s, 1 - s});
    }
}

TEST(weights_in_triangle, moves_points_from_outside_in) {
  for (const Place& p : {Place{-1, 2}, Place{7, 0.1}, Place{0.5, -3}, Place{0.3, 50}}) {
    const auto w = IT::weights_in_triangle(p, {0, 0}, {1, 0}, {0.4, 1.5});
    for (const double x : w) EXPECT_GE(x, 0);
    EXPECT_NEAR(w[0] + w[1] + w[2], 1, 0x1p-50);
  }
}

} // namespace
