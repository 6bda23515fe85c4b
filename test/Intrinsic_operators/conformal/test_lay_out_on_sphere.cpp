// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/conformal/lay_out_on_sphere.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>

#include "flat_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Points on the sphere are found again, but for a Möbius transformation, from lengths in the plane.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Point = std::array<double, 3>;

double distance(const Point& p, const Point& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

struct Polyhedron {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  void normalise() {
    for (Point& p : points) {
      const double n = distance(p, {0, 0, 0});
      for (double& x : p) x /= n;
    }
  }
  // divides each triangle into four, and each edge on the sphere
  void divide() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
    const auto between = [&](std::uint32_t i, std::uint32_t j) {
      const auto [at, is_new] =
          middle.insert({std::minmax(i, j), static_cast<std::uint32_t>(points.size())});
      if (is_new)
        points.push_back({points[i][0] + points[j][0], points[i][1] + points[j][1],
                          points[i][2] + points[j][2]});
      return at->second;
    };
    std::vector<std::array<std::uint32_t, 3>> all;
    for (const auto& [i, j, k] : triangles) {
      const std::uint32_t a = between(j, k), b = between(k, i), c = between(i, j);
      for (const auto& t : {std::array{i, c, b}, {j, a, c}, {k, b, a}, {a, b, c}}) all.push_back(t);
    }
    triangles = all;
    normalise();
  }
  // Projected to the plane from a vertex, with lengths |p - q| / (|p - v| |q - v|).
  flat::Surface seen_from(std::uint32_t v) const {
    flat::Surface s(triangles, points);
    for (std::uint32_t h = 0; h < s.length.size(); ++h) {
      const std::uint32_t i = s.gluing.origin[h], j = s.gluing.origin[IT::Gluing::next(h)];
      if (i != v && j != v)
        s.length[h] /= distance(points[i], points[v]) * distance(points[j], points[v]);
    }
    return s;
  }
};

Polyhedron octahedron() {
  return {{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}};
}
Polyhedron icosahedron() {
  const double t = std::numbers::phi;
  Polyhedron p{{{-1, t, 0},
                {1, t, 0},
                {-1, -t, 0},
                {1, -t, 0},
                {0, -1, t},
                {0, 1, t},
                {0, -1, -t},
                {0, 1, -t},
                {t, 0, -1},
                {t, 0, 1},
                {-t, 0, -1},
                {-t, 0, 1}},
               {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  p.normalise();
  return p;
}
Polyhedron tetrahedron() {
  Polyhedron p{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
               {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  p.normalise();
  return p;
}

void expect_on_sphere(const IT::Sphere_layout& layout, double error) {
  EXPECT_TRUE(layout.is_centred);
  EXPECT_LE(layout.distance_of_mean, error);
  EXPECT_TRUE(layout.is_injective());
  EXPECT_LE(layout.largest_side_error, 1e-10);
  for (const Point& p : layout.positions) EXPECT_NEAR(distance(p, {0, 0, 0}), 1, 1e-14);
  EXPECT_LE(distance(layout.positions[layout.pole], {0, 0, 1}), 1e-14);
}

TEST(LayOutOnSphere, makesRegularPolyhedraRegular) {
  for (const Polyhedron& p : {tetrahedron(), octahedron(), icosahedron()})
    for (std::uint32_t pole = 0; pole < p.points.size(); ++pole) {
      SCOPED_TRACE(std::to_string(p.points.size()) + " vertices, pole " + std::to_string(pole));
      const IT::Sphere_layout layout = IT::lay_out_on_sphere(p.seen_from(pole), pole);
      expect_on_sphere(layout, 1e-14);
      for (std::size_t i = 0; i < p.points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_NEAR(distance(layout.positions[i], layout.positions[j]),
                      distance(p.points[i], p.points[j]), 1e-12);
    }
}

TEST(LayOutOnSphere, keepsCrossRatiosOfPoints) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shift(-0.1, 0.1), weight(0, 1);
    Polyhedron p = icosahedron();
    p.divide();
    p.divide();
    for (Point& x : p.points)
      for (double& c : x) c += 0.3 * shift(random);
    p.normalise();
    for (Point& x : p.points) { // moved to one side
      const double b = 0.8, n = 1 + b * x[0];
      x = {(x[0] + b) / n, std::sqrt(1 - b * b) * x[1] / n, std::sqrt(1 - b * b) * x[2] / n};
    }
    const auto pole = static_cast<std::uint32_t>(random() % p.points.size());
    std::vector<double> weights(p.points.size());
    for (double& w : weights) w = weight(random);
    const IT::Sphere_layout layout = IT::lay_out_on_sphere(p.seen_from(pole), pole, weights);
    expect_on_sphere(layout, 1e-13);
    const auto ratio = [](const std::vector<Point>& x, const std::array<std::size_t, 4>& i) {
      return distance(x[i[0]], x[i[1]]) * distance(x[i[2]], x[i[3]]) /
             (distance(x[i[0]], x[i[2]]) * distance(x[i[1]], x[i[3]]));
    };
    for (int n = 0; n < 200; ++n) {
      std::array<std::size_t, 4> i;
      do
        for (std::size_t& k : i) k = random() % p.points.size();
      while (std::set<std::size_t>(i.begin(), i.end()).size() < 4);
      const double expected = ratio(p.points, i);
      EXPECT_NEAR(ratio(layout.positions, i), expected, 1e-9 * expected);
    }
  }
}

TEST(LayOutOnSphere, saysThatHalfOfTheWeightAtAPointCannotBeCentred) {
  const Polyhedron p = octahedron();
  const std::vector<double> weights{1, 1, 1, 1, 10, 1};
  const IT::Sphere_layout layout = IT::lay_out_on_sphere(p.seen_from(4), 4, weights);
  EXPECT_FALSE(layout.is_centred);
  EXPECT_GT(layout.distance_of_mean, 0.1);
}

TEST(LayOutOnSphere, refusesWhatIsNoSphere) {
  const flat::Surface torus = flat::Surface::torus(1, flat::Complex(0, 1), 3);
  EXPECT_THROW(IT::lay_out_on_sphere(torus, 0), IT::Invalid_input);
  const flat::Surface open({{0, 1, 2}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_THROW(IT::lay_out_on_sphere(open, 0), IT::Invalid_input);
  const flat::Surface s = octahedron().seen_from(0);
  EXPECT_THROW(IT::lay_out_on_sphere(s, 6), IT::Invalid_input);
  EXPECT_THROW(IT::lay_out_on_sphere(s, 0, std::vector<double>{1}), IT::Invalid_input);
  EXPECT_THROW(IT::lay_out_on_sphere(s, 0, std::vector<double>{1, 1, 1, 1, 1, -1}),
               IT::Invalid_input);
  // a vertex of all triangles
  const flat::Surface pillow = flat::Surface::doubled_polygon({0, 1, {0, 1}});
  EXPECT_THROW(IT::lay_out_on_sphere(pillow, 0), IT::Invalid_input);
}

} // namespace
