// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Point = std::array<double, 3>;
using Order = std::vector<std::uint32_t>;

// The order in which the tufted cover glues triangles around the edge from point 0 to point 1, from
// the first triangle on; triangle i has the apex i + 2.
Order sorted(const std::vector<Point>& points) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t v = 2; v < points.size(); ++v) triangles.push_back({0, 1, v});
  const auto [input, report] =
      IT::make_domain(IT::triangle_soup(points, triangles), IT::Domain_kind::tufted_cover);
  Order next(triangles.size(), IT::Gluing::none);
  for (const IT::Gluing_map::Halfedge h : halfedges(input.mesh)) {
    const auto row = [&](IT::Gluing_map::Halfedge g) {
      return input.names.row(input.mesh.source(g).index);
    };
    const auto o = IT::Gluing_map::opposite(h);
    if (row(h) != 0 || row(o) != 1) continue;
    // the front of a triangle looks counterclockwise, at the back of the next
    const std::uint32_t front = input.mesh.face(h).index, back = input.mesh.face(o).index;
    EXPECT_EQ(front % 2, 0U);
    EXPECT_EQ(back % 2, 1U);
    next[front / 2] = back / 2;
  }
  Order result{0};
  while (result.size() < next.size()) result.push_back(next[result.back()]);
  EXPECT_EQ(next[result.back()], 0U); // one cycle
  return result;
}

TEST(Tufted_cover, goes_around_an_edge_counterclockwise_seen_from_the_second_end) {
  EXPECT_EQ(sorted({{0, 0, 0}, {0, 0, 3}, {1, 0, 9}, {0, -1, 1}, {0, 1, 2}, {-1, 0, -5}}),
            (Order{0, 2, 3, 1}));
}

TEST(Tufted_cover, orders_triangles_by_random_angles) {
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

TEST(Tufted_cover, keeps_the_order_of_triangles_in_one_half_plane) {
  EXPECT_EQ(sorted({{0, 0, 0}, {0, 0, 3}, {1, 0, 0}, {-2, 0, 1}, {3, 0, 7}, {-1, 0, 0}, {5, 0, 2}}),
            (Order{0, 2, 4, 1, 3}));
}

TEST(Tufted_cover, takes_triangles_without_area_after_the_others) {
  EXPECT_EQ(sorted({{0, 0, 0}, {0, 0, 3}, {0, 0, 1}, {0, 1, 1}, {0, 0, 8}, {1, 0, 0}}),
            (Order{0, 2, 1, 3}));
}

TEST(Tufted_cover, keeps_the_order_around_an_edge_without_length) {
  EXPECT_EQ(sorted({{1, 1, 1}, {1, 1, 1}, {0, 0, 1}, {0, 1, 1}, {1, 1, 1}}), (Order{0, 1, 2}));
}

// Points beside each other in a half plane at a line, and moved off it by a function of the number
// of the point, its distance from the line, and a coordinate.
template <class Move>
std::vector<Point> points_near_half_plane(std::mt19937& random, const Move& move) {
  std::uniform_int_distribution<int> large(1, 1000);
  const Point a{0.1, 0.7, -0.3}, d{0.3, 1.1, 0.7}, e{1.3, -0.2, 0.1};
  std::vector<Point> points{a, {a[0] + d[0], a[1] + d[1], a[2] + d[2]}};
  for (std::size_t i = 0; i < 6; ++i) {
    Point p;
    const double s = large(random) / 64., t = large(random) / 1024.;
    for (unsigned k = 0; k < 3; ++k) p[k] = move(i, t, k, a[k] + s * d[k] + t * e[k]);
    points.push_back(p);
  }
  return points;
}

TEST(Tufted_cover, keeps_the_order_of_triangles_in_one_half_plane_up_to_rounding) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> small(-3, 3);
  for (int run = 0; run < 200; ++run) {
    const auto points =
        points_near_half_plane(random, [&](std::size_t, double, unsigned, double x) {
          for (int ulps = small(random); ulps != 0; ulps += ulps < 0 ? 1 : -1)
            x = std::nextafter(x, ulps < 0 ? -1e9 : 1e9);
          return x;
        });
    EXPECT_EQ(sorted(points), (Order{0, 1, 2, 3, 4, 5})) << run;
  }
}

TEST(Tufted_cover, orders_triangles_whose_angles_differ_by_more_than_rounding) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> small(-3, 3);
  using Rational = CGAL::Gmpq;
  for (int run = 0; run < 200; ++run) {
    const Point normal{0.25, 0.88, -1.49};
    std::array<int, 6> plane{}; // of each point
    for (int& n : plane) n = small(random);
    const auto points =
        points_near_half_plane(random, [&](std::size_t i, double t, unsigned k, double x) {
          return x + plane[i] * 0x1p-24 * t * normal[k];
        });
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
      if (plane[here] != plane[next]) descents += side(here, next) == CGAL::NEGATIVE ? 1 : 0;
    }
    EXPECT_LE(descents, 1U) << run;
  }
}

} // namespace
