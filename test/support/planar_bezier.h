// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_PLANAR_BEZIER_H
#define TEST_INTRINSIC_TRIANGULATIONS_PLANAR_BEZIER_H

#include "meshes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

// Bezier curves in a plane, for comparison with those on flat meshes; and flat meshes.
namespace planar_bezier {

using meshes::Point;

inline std::uint32_t vertex_at(const meshes::Mesh& m, double x, double y) {
  for (std::uint32_t i = 0; i < m.points.size(); ++i)
    if (m.points[i][0] == x && m.points[i][1] == y) return i;
  throw std::out_of_range("no such vertex");
}

// de Casteljau's algorithm
inline Point planar(std::vector<Point> b, double t) {
  for (; b.size() > 1; b.pop_back())
    for (std::size_t i = 0; i + 1 < b.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) b[i][c] = (1 - t) * b[i][c] + t * b[i + 1][c];
  return b.front();
}

inline double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

inline double doubled_area(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Points of a unit square, its corners first: each splits the triangle that it falls into, then
/// edges are flipped at random. Fewer if there is no place for so many.
/// \param cells points are those of a lattice of so many cells a side, many on a line; 0: any
///   points
inline meshes::Mesh random_square(unsigned n, std::mt19937& random, unsigned cells = 0) {
  const auto uniform = [&]() -> double {
    if (cells > 0) return (1. + static_cast<double>(random() % (cells - 1))) / cells;
    return (static_cast<double>(random()) + 0.5) / 0x1p32;
  };
  meshes::Mesh m;
  m.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  m.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto area = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return doubled_area(m.points[a], m.points[b], m.points[c]);
  };
  constexpr double least = 1e-6;
  for (unsigned tries = 0; m.points.size() < n && tries < 20 * n; ++tries) {
    const auto v = static_cast<std::uint32_t>(m.points.size());
    m.points.push_back({uniform(), uniform(), 0});
    for (std::size_t f = 0, all = m.triangles.size(); f < all; ++f) {
      const auto [a, b, c] = m.triangles[f];
      if (std::min({area(a, b, v), area(b, c, v), area(c, a, v)}) < least) continue;
      m.triangles[f] = {a, b, v};
      m.triangles.push_back({b, c, v});
      m.triangles.push_back({c, a, v});
      break;
    }
    if (m.triangles.back()[2] != v) m.points.pop_back();
  }
  for (unsigned flip = 0; flip < 20 * n; ++flip) {
    meshes::Triangle& f = m.triangles[random() % m.triangles.size()];
    std::rotate(f.begin(), f.begin() + random() % 3, f.end());
    for (meshes::Triangle& g : m.triangles)
      for (unsigned k = 0; k < 3; ++k) {
        if (g[k] != f[1] || g[(k + 1) % 3] != f[0]) continue;
        const std::uint32_t i = f[0], j = f[1], c = f[2], d = g[(k + 2) % 3];
        if (std::min(area(c, i, d), area(d, j, c)) < least) continue;
        f = {c, i, d};
        g = {d, j, c};
      }
  }
  return m;
}

} // namespace planar_bezier

#endif // TEST_INTRINSIC_TRIANGULATIONS_PLANAR_BEZIER_H
