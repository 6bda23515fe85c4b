// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/domains/tufted_cover.h>

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace {

using CGAL::Intrinsic_triangulations::internal::sort_around_edge;
using Point = std::array<double, 3>;
using Order = std::vector<std::uint32_t>;

// points 2, 3, ... about the line from point 0 to point 1
Order sorted(const std::vector<Point>& points) {
  Order apices(points.size() - 2);
  std::iota(apices.begin(), apices.end(), 2U);
  return sort_around_edge(points, 0, 1, apices);
}

TEST(Sort_around_edge, goes_counterclockwise_seen_from_the_second_end) {
  EXPECT_EQ(sorted({{0, 0, 0}, {0, 0, 3}, {1, 0, 9}, {0, -1, 1}, {0, 1, 2}, {-1, 0, -5}}),
            (Order{0, 2, 3, 1}));
}

TEST(Sort_around_edge, finds_the_angles_of_random_points) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(0, 2 * M_PI), length(0.1, 5), height(-3, 3);
  for (int run = 0; run < 50; ++run) {
    std::vector<Point> points{{0, 0, -1}, {0, 0, 1}};
    std::vector<double> angles;
    for (int i = 0; i < 20; ++i) {
      angles.push_back(angle(random));
      const double r = length(random);
      points.push_back({r * std::cos(angles.back()), r * std::sin(angles.back()), height(random)});
    }
    const Order order = sorted(points);
    ASSERT_EQ(order.front(), 0U);
    const auto turn = [&](std::uint32_t i) {
      return std::fmod(angles[i] - angles[0] + 2 * M_PI, 2 * M_PI);
    };
    for (std::size_t i = 1; i < order.size(); ++i) EXPECT_LT(turn(order[i - 1]), turn(order[i]));
  }
}

TEST(Sort_around_edge, keeps_the_order_of_points_in_one_half_plane) {
  EXPECT_EQ(sorted({{0, 0, 0}, {0, 0, 3}, {1, 0, 0}, {-2, 0, 1}, {3, 0, 7}, {-1, 0, 0}, {5, 0, 2}}),
            (Order{0, 2, 4, 1, 3}));
}

TEST(Sort_around_edge, takes_points_on_the_line_last) {
  EXPECT_EQ(sorted({{0, 0, 0}, {0, 0, 3}, {0, 0, 1}, {0, 1, 1}, {0, 0, 8}, {1, 0, 0}}),
            (Order{1, 3, 0, 2}));
}

TEST(Sort_around_edge, ends_on_an_edge_without_length) {
  EXPECT_EQ(sorted({{1, 1, 1}, {1, 1, 1}, {0, 0, 1}, {0, 1, 1}, {1, 1, 1}}), (Order{0, 1, 2}));
}

// Points in a plane up to the last bits of coordinates: doubles do not detect this.
TEST(Sort_around_edge, is_exact) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> small(-3, 3), large(1, 1000);
  using Rational = CGAL::Gmpq;
  for (int run = 0; run < 200; ++run) {
    const Point a{0.1, 0.7, -0.3}, d{0.3, 1.1, 0.7};
    std::vector<Point> points{a, {a[0] + d[0], a[1] + d[1], a[2] + d[2]}};
    for (int i = 0; i < 6; ++i) {
      Point p;
      const double s = large(random) / 64., t = large(random) / 1024.;
      for (unsigned k = 0; k < 3; ++k) {
        p[k] = a[k] + s * d[k] + t * (k == 0 ? 1.3 : k == 1 ? -0.2 : 0.1);
        for (int ulps = small(random); ulps != 0; ulps += ulps < 0 ? 1 : -1)
          p[k] = std::nextafter(p[k], ulps < 0 ? -1e9 : 1e9);
      }
      points.push_back(p);
    }
    const auto side = [&](std::uint32_t i, std::uint32_t j) { // of j, seen from i
      std::array<std::array<Rational, 3>, 3> m;
      for (unsigned k = 0; k < 3; ++k) {
        m[0][k] = Rational(points[1][k]) - Rational(points[0][k]);
        m[1][k] = Rational(points[i + 2][k]) - Rational(points[0][k]);
        m[2][k] = Rational(points[j + 2][k]) - Rational(points[0][k]);
      }
      return CGAL::sign(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                        m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                        m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
    };
    // all are near one half plane, so that the circular order is a linear one from some point on
    const Order order = sorted(points);
    std::size_t descents = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const std::uint32_t here = order[i], next = order[(i + 1) % order.size()];
      descents += side(here, next) == CGAL::NEGATIVE ? 1 : 0;
    }
    EXPECT_LE(descents, 1U) << run;
  }
}

} // namespace
