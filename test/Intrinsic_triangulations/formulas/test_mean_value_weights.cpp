// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/input/position_on_face.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace {

using CGAL::Intrinsic_triangulations::mean_value_weights;
using Point = std::array<double, 2>;
using Polygon = std::vector<Point>;

const Polygon l_shape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
const Polygon pentagon{{0, 0}, {3, 0.5}, {3.5, 2}, {1, 3}, {-0.5, 1}};

void expect_reproduces(const Polygon& polygon, const Point& p, double scale = 1) {
  Polygon scaled(polygon);
  for (Point& q : scaled)
    for (double& x : q) x *= scale;
  const std::vector<double> w = mean_value_weights(scaled, {p[0] * scale, p[1] * scale});
  double sum = 0, x = 0, y = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sum += w[i];
    x += w[i] * polygon[i][0];
    y += w[i] * polygon[i][1];
  }
  EXPECT_NEAR(sum, 1, 1e-14);
  EXPECT_NEAR(x, p[0], 1e-13) << scale;
  EXPECT_NEAR(y, p[1], 1e-13) << scale;
}

TEST(Mean_value_weights, reproduce_points_inside_of_any_size) {
  for (const double scale : {1., 0x1p-700, 0x1p-500, 0x1p500, 0x1p900})
    for (const Point& p : {Point{0.5, 0.5}, Point{0.9, 1.9}, Point{1.9, 0.1}, Point{0.999, 0.999}})
      expect_reproduces(l_shape, p, scale);
  for (const Point& p : {Point{1, 1}, Point{3, 2}, Point{0.1, 0.1}, Point{-0.4, 1}})
    expect_reproduces(pentagon, p);
}

TEST(Mean_value_weights, are_positive_inside_of_convex_polygons) {
  for (const Point& p : {Point{1, 1}, Point{3, 2}, Point{0.1, 0.1}, Point{-0.4, 1}})
    for (const double w : mean_value_weights(pentagon, p)) EXPECT_GT(w, 0);
}

TEST(Mean_value_weights, are_linear_on_sides) {
  for (const Polygon& polygon : {l_shape, pentagon})
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t j = (i + 1) % polygon.size();
      for (const double s : {0., 0.25, 0.5, 1.}) {
        const Point &a = polygon[i], &b = polygon[j];
        const std::vector<double> w =
            mean_value_weights(polygon, {(1 - s) * a[0] + s * b[0], (1 - s) * a[1] + s * b[1]});
        for (std::size_t k = 0; k < polygon.size(); ++k)
          EXPECT_NEAR(w[k], k == i ? 1 - s : k == j ? s : 0, 1e-15) << i << ' ' << k << ' ' << s;
      }
    }
}

TEST(Mean_value_weights, of_the_center_of_a_regular_polygon_are_equal) {
  Polygon hexagon;
  for (int i = 0; i < 6; ++i)
    hexagon.push_back({std::cos(i * std::numbers::pi / 3), std::sin(i * std::numbers::pi / 3)});
  for (const double w : mean_value_weights(hexagon, {0, 0})) EXPECT_NEAR(w, 1. / 6, 1e-15);
}

} // namespace
