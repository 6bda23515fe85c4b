// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_COARSE_MESHES_H
#define INTRINSIC_TRIANGULATIONS_TEST_COARSE_MESHES_H

// Meshes for tests that make surfaces coarse, and how many vertices are asked for.

#include "operator_test_meshes.h"

#include <CGAL/Intrinsic_simplification/simplification/Simplification.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>

namespace operator_test {

/// asks for a number of vertices.
inline IT::Simplify_options to(std::size_t vertices) {
  IT::Simplify_options options;
  options.vertices = vertices;
  return options;
}

/// A cube whose faces are grids of n times n squares.
inline Shape cube_of_grids(int n) {
  Shape s;
  std::map<std::array<int, 3>, std::uint32_t> number;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto [at, is_new] = number.emplace(p, static_cast<std::uint32_t>(number.size()));
    if (is_new)
      s.points.push_back(
          {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    return at->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int level : {0, n})
      for (int x = 0; x < n; ++x)
        for (int y = 0; y < n; ++y) {
          const auto at = [&](int a, int b) {
            std::array<int, 3> p;
            p[axis] = level;
            p[(axis + 1) % 3] = level > 0 ? a : b;
            p[(axis + 2) % 3] = level > 0 ? b : a;
            return vertex(p);
          };
          const std::uint32_t a = at(x, y), b = at(x + 1, y), c = at(x + 1, y + 1),
                              d = at(x, y + 1);
          s.triangles.push_back({a, b, c});
          s.triangles.push_back({a, c, d});
        }
  return s;
}

} // namespace operator_test

#endif // INTRINSIC_TRIANGULATIONS_TEST_COARSE_MESHES_H
