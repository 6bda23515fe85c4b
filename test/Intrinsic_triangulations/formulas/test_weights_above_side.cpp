// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/apex.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Point = IT::Plane_vector<double>;

// The point with the weights that are found is where the point was, up to rounding of coordinates,
// however thin the triangle.
void expect_reproduced(const Point& apex, const std::array<double, 3>& w) {
  const Point p{w[1] + w[2] * apex.x, w[2] * apex.y};
  const std::array<double, 3> found = IT::weights_above_side(p, apex);
  for (const double x : found) EXPECT_GE(x, 0);
  EXPECT_NEAR(found[0] + found[1] + found[2], 1, 0x1p-50);
  const Point q{found[1] + found[2] * apex.x, found[2] * apex.y};
  const double size = 1 + std::abs(apex.x) + apex.y;
  EXPECT_LE(std::hypot(q.x - p.x, q.y - p.y), 0x1p-48 * size)
      << "apex " << apex.x << " " << apex.y << ", weights " << w[0] << " " << w[1] << " " << w[2];
}

TEST(weights_above_side, reproduce_points_in_fat_and_thin_triangles) {
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

TEST(weights_above_side, reproduce_points_of_triangles_without_area) {
  for (const double x : {0.25, -2.0, 5.0})
    for (const double s : {0.0, 0.5, 1.0}) {
      expect_reproduced({x, 0}, {s, 1 - s, 0});
      expect_reproduced({x, 0}, {0, s, 1 - s});
    }
}

TEST(weights_above_side, moves_points_from_outside_in) {
  for (const Point& p : {Point{-1, 2}, Point{7, 0.1}, Point{0.5, -3}, Point{0.3, 50}}) {
    const auto w = IT::weights_above_side(p, {0.4, 1.5});
    for (const double x : w) EXPECT_GE(x, 0);
    EXPECT_NEAR(w[0] + w[1] + w[2], 1, 0x1p-50);
  }
}

} // namespace
