// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_POLYHEDRA_H
#define TEST_POLYHEDRA_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <utility>
#include <vector>

/// Polyhedra with corners on the unit sphere.
namespace polyhedra {

using Point = std::array<double, 3>;

inline double distance(const Point& p, const Point& q) {
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
};

inline Polyhedron octahedron() {
  return {{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}};
}
inline Polyhedron icosahedron() {
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
inline Polyhedron tetrahedron() {
  Polyhedron p{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
               {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  p.normalise();
  return p;
}

/// returns the cross ratio of distances of four points, which Möbius transformations keep.
inline double cross_ratio(const std::vector<Point>& x, const std::array<std::size_t, 4>& i) {
  return distance(x[i[0]], x[i[1]]) * distance(x[i[2]], x[i[3]]) /
         (distance(x[i[0]], x[i[2]]) * distance(x[i[1]], x[i[3]]));
}

/// returns four different numbers below n.
inline std::array<std::size_t, 4> four_of(std::size_t n, std::mt19937& random) {
  std::array<std::size_t, 4> i;
  do
    for (std::size_t& k : i) k = random() % n;
  while (std::set<std::size_t>(i.begin(), i.end()).size() < 4);
  return i;
}

} // namespace polyhedra

#endif // TEST_POLYHEDRA_H
