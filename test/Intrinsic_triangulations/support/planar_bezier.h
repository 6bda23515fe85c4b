// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_PLANAR_BEZIER_H
#define TEST_INTRINSIC_TRIANGULATIONS_PLANAR_BEZIER_H

#include "meshes.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

// Bezier curves in a plane, what those on a mesh that is flat must be.
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

} // namespace planar_bezier

#endif // TEST_INTRINSIC_TRIANGULATIONS_PLANAR_BEZIER_H
