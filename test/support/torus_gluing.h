// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_TORUS_GLUING_H
#define TEST_TORUS_GLUING_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <cstdint>
#include <utility>

/// The torus of a grid of n times m cells, each of two triangles: (0,0) (1,0) (1,1), and (0,0) (1,1)
/// (0,1). Vertex (x, y) has number n y + x.
inline CGAL::Intrinsic_triangulations::Gluing torus_gluing(std::uint32_t n, std::uint32_t m) {
  CGAL::Intrinsic_triangulations::Gluing g;
  g.number_of_vertices = n * m;
  const auto vertex = [n, m](std::uint32_t x, std::uint32_t y) { return n * (y % m) + x % n; };
  const auto cell = [&](std::uint32_t x, std::uint32_t y) { return 6 * vertex(x, y); };
  for (std::uint32_t y = 0; y < m; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t c = cell(x, y);
      for (const auto& [i, j] :
           {std::pair{0U, 0U}, {1U, 0U}, {1U, 1U}, {0U, 0U}, {1U, 1U}, {0U, 1U}})
        g.origin.push_back(vertex(x + i, y + j));
      // sides: 0 bottom, 1 right, 2 diagonal back; 3 diagonal, 4 top, 5 left
      for (const std::uint32_t other : {cell(x, y + m - 1) + 4, cell(x + 1, y) + 5, c + 3, c + 2,
                                        cell(x, y + 1), cell(x + n - 1, y) + 1})
        g.glue.push_back(other);
    }
  return g;
}

#endif // TEST_TORUS_GLUING_H
