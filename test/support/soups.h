// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_SOUPS_H
#define TEST_INTRINSIC_TRIANGULATIONS_SOUPS_H

#include "meshes.h"

#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <set>
#include <utility>
#include <vector>

// Triangles that do not form a mesh.

namespace soups {

namespace IT = CGAL::Intrinsic_triangulations;
using meshes::Mesh;

inline IT::Triangle_soup soup(const Mesh& m) {
  IT::Triangle_soup s;
  s.points = m.points;
  s.triangles = m.triangles;
  s.input_faces = m.triangles.size();
  return s;
}

/// A tetrahedron's apex over each side of one triangle, and one below: the edges of the triangle have three faces.
inline Mesh three_fins() {
  return {{{0, 0, 0}, {4, 0, 0}, {0, 5, 0}, {1, 1, 6}, {-3, 2, -5}},
          {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {2, 0, 3}}};
}

/// Three unit squares at an edge, each with different triangles.
inline Mesh book() {
  Mesh m;
  m.points = {{0, 0, 0}, {0, 1, 0}};
  for (int page = 0; page < 3; ++page) {
    const double angle = page * 2 * std::numbers::pi / 3, c = std::cos(angle), s = std::sin(angle);
    const auto first = static_cast<std::uint32_t>(m.points.size());
    m.points.push_back({c, 0, s});
    m.points.push_back({c, 1, s});
    const double x = 0.3 + 0.1 * page;
    m.points.push_back({x * c, 0.6 - 0.1 * page, x * s});
    const std::uint32_t center = first + 2;
    m.triangles.insert(
        m.triangles.end(),
        {{0, first, center}, {first, first + 1, center}, {first + 1, 1, center}, {1, 0, center}});
  }
  return m;
}

/// A strip with a half turn.
inline Mesh moebius_strip(std::uint32_t n = 7) {
  Mesh m;
  for (std::uint32_t i = 0; i < n; ++i)
    for (const double side : {-1., 1.}) {
      const double a = 2 * M_PI * i / n, r = 3 + side * std::cos(a / 2);
      m.points.push_back({r * std::cos(a), r * std::sin(a), side * std::sin(a / 2)});
    }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 2 * i, b = a + 1, c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? a + 3 : 0;
    m.triangles.push_back({a, c, b});
    m.triangles.push_back({b, c, d});
  }
  return m;
}

/// A grid whose last row is joined to the first, and whose last column to the first upside down.
inline Mesh klein_bottle(std::uint32_t n = 7, std::uint32_t k = 5) {
  Mesh m;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < k; ++j) {
      const double u = 2 * M_PI * i / n, v = 2 * M_PI * j / k; // crosses itself
      const double r = 4 + std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v);
      m.points.push_back({r * std::cos(u), r * std::sin(u),
                          std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v)});
    }
  const auto at = [&](std::uint32_t i, std::uint32_t j) {
    return i < n ? k * i + j % k : (k - j % k) % k;
  };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < k; ++j) {
      m.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      m.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return m;
}

/// Half of an icosahedron, opposite points of its rim joined: six vertices.
inline Mesh projective_plane() {
  return {{{0, 0, 4}, {4, 0, 0}, {1, 4, 1}, {-3, 2, -1}, {-3, -2, 1}, {1, -4, 0}},
          {{0, 1, 2},
           {0, 2, 3},
           {0, 3, 4},
           {0, 4, 5},
           {0, 5, 1},
           {1, 2, 4},
           {2, 3, 5},
           {3, 4, 1},
           {4, 5, 2},
           {5, 1, 3}}};
}

/// Random triangles over few points: most edges have more than two faces; some faces are repeated.
inline Mesh random(std::uint32_t points, std::size_t triangles, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> coordinate(-1000, 1000);
  Mesh m;
  for (std::uint32_t i = 0; i < points; ++i)
    m.points.push_back(
        {double(coordinate(random)), double(coordinate(random)), double(coordinate(random))});
  std::uniform_int_distribution<std::uint32_t> vertex(0, points - 1);
  while (m.triangles.size() < triangles) {
    const meshes::Triangle t{vertex(random), vertex(random), vertex(random)};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) m.triangles.push_back(t);
  }
  return m;
}

/// The same without a triangle on the corners of another.
inline Mesh random_without_repetition(std::uint32_t points, std::size_t triangles, unsigned seed) {
  Mesh m = random(points, 4 * triangles, seed);
  std::set<meshes::Triangle> seen;
  std::vector<meshes::Triangle> kept;
  for (meshes::Triangle t : m.triangles) {
    const meshes::Triangle as_given = t;
    std::sort(t.begin(), t.end());
    if (kept.size() < triangles && seen.insert(t).second) kept.push_back(as_given);
  }
  m.triangles = kept;
  return m;
}

/// Two copies of each face of an oriented mesh, the second one turned around, glued along the border.
struct Doubled {
  IT::Intrinsic_input input;
  std::vector<std::uint32_t> front; ///< the vertex of the mesh that each vertex is a copy of
};
inline Doubled doubled(const Mesh& m) {
  const auto n = static_cast<std::uint32_t>(m.points.size());
  IT::Gluing g = IT::gluing_from_triangles(n, m.triangles);
  const auto sides = static_cast<std::uint32_t>(g.glue.size());
  const auto mirror = [sides](std::uint32_t h) { return sides + h - h % 3 + 2 - h % 3; };
  std::vector<char> is_on_border(n, 0);
  g.origin.resize(2 * sides);
  g.glue.resize(2 * sides);
  for (std::uint32_t h = 0; h < sides; ++h) {
    const bool border = g.glue[h] == IT::Gluing::none;
    g.glue[mirror(h)] = border ? h : mirror(g.glue[h]);
    if (!border) continue;
    g.glue[h] = mirror(h);
    is_on_border[g.origin[h]] = is_on_border[g.origin[IT::Gluing::next(h)]] = 1;
  }
  Doubled d;
  std::vector<std::array<double, 3>> points = m.points;
  std::vector<std::uint32_t> back(n);
  for (std::uint32_t v = 0; v < n; ++v) d.front.push_back(v);
  for (std::uint32_t v = 0; v < n; ++v) {
    back[v] = is_on_border[v] != 0 ? v : static_cast<std::uint32_t>(points.size());
    if (is_on_border[v] != 0) continue;
    points.push_back(m.points[v]);
    d.front.push_back(v);
  }
  for (std::uint32_t h = 0; h < sides; ++h)
    g.origin[mirror(h)] = back[g.origin[IT::Gluing::next(h)]];
  g.number_of_vertices = static_cast<std::uint32_t>(points.size());
  d.input = IT::Intrinsic_input(IT::Gluing_map(g), points);
  return d;
}

} // namespace soups

#endif // TEST_INTRINSIC_TRIANGULATIONS_SOUPS_H
