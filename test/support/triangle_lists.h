// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_TRIANGLE_LISTS_H
#define TEST_TRIANGLE_LISTS_H

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

/// Surfaces in space as lists of triangles, and other lists of the same surface.
namespace triangle_lists {

namespace IT = CGAL::Intrinsic_triangulations;

struct Triangles {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> faces;

  IT::Corresponding_triangulation triangulation() const {
    return IT::Corresponding_triangulation(IT::Intrinsic_input(
        IT::Gluing_map(IT::gluing_from_triangles(static_cast<std::uint32_t>(points.size()), faces)),
        points));
  }

  std::uint32_t add_point(std::array<double, 3> sum, double divisor) {
    for (double& x : sum) x /= divisor;
    points.push_back(sum);
    return static_cast<std::uint32_t>(points.size() - 1);
  }
  std::array<double, 3> sum(std::uint32_t i, std::uint32_t j) const {
    return {points[i][0] + points[j][0], points[i][1] + points[j][1], points[i][2] + points[j][2]};
  }

  /// inserts a point in a face: exact for coordinates with few digits.
  void split_face(std::size_t f) {
    const auto [i, j, k] = faces[f];
    const std::array<double, 3> a = sum(i, i), b = sum(j, k);
    const std::uint32_t p = add_point({a[0] + b[0], a[1] + b[1], a[2] + b[2]}, 4);
    faces[f] = {i, j, p};
    faces.push_back({j, k, p});
    faces.push_back({k, i, p});
  }
  /// inserts the middle of the first side of a face.
  void split_edge(std::size_t f) {
    const auto [i, j, k] = faces[f];
    const std::uint32_t p = add_point(sum(i, j), 2);
    faces[f] = {i, p, k};
    faces.push_back({p, j, k});
    for (std::size_t g = 0, n = faces.size() - 1; g < n; ++g)
      for (std::size_t s = 0; s < 3; ++s)
        if (faces[g][s] == j && faces[g][(s + 1) % 3] == i) {
          const std::uint32_t m = faces[g][(s + 2) % 3];
          faces[g] = {j, p, m};
          faces.push_back({p, i, m});
        }
  }
  /// divides each face in four, at the middles of its sides.
  Triangles quartered() const {
    Triangles t = *this;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t i, std::uint32_t j) {
      const auto [at, is_new] = middles.try_emplace(std::minmax(i, j));
      if (is_new) at->second = t.add_point(sum(i, j), 2);
      return at->second;
    };
    t.faces.clear();
    for (const auto& [i, j, k] : faces) {
      const std::uint32_t ij = middle(i, j), jk = middle(j, k), ki = middle(k, i);
      t.faces.insert(t.faces.end(), {{i, ij, ki}, {ij, j, jk}, {ki, jk, k}, {ij, jk, ki}});
    }
    return t;
  }
  /// rounds coordinates, so that middles are exact.
  Triangles with_bits_after_the_point(int bits) const {
    Triangles t = *this;
    for (auto& p : t.points)
      for (double& x : p) x = std::ldexp(std::round(std::ldexp(x, bits)), -bits);
    return t;
  }
  /// divides faces and edges at random.
  Triangles divided(std::size_t times, std::uint32_t seed) const {
    Triangles t = *this;
    std::mt19937 random(seed);
    for (std::size_t n = 0; n < times; ++n) {
      const std::size_t f = random() % t.faces.size();
      std::rotate(t.faces[f].begin(), t.faces[f].begin() + random() % 3, t.faces[f].end());
      random() % 2 == 0 ? t.split_face(f) : t.split_edge(f);
    }
    return t;
  }
  /// numbers points and faces at random.
  Triangles renumbered(std::uint32_t seed) const {
    std::mt19937 random(seed);
    std::vector<std::uint32_t> number(points.size());
    std::iota(number.begin(), number.end(), 0U);
    std::shuffle(number.begin(), number.end(), random);
    Triangles t = *this;
    for (std::size_t v = 0; v < points.size(); ++v) t.points[number[v]] = points[v];
    std::shuffle(t.faces.begin(), t.faces.end(), random);
    for (auto& f : t.faces) {
      for (std::uint32_t& v : f) v = number[v];
      std::rotate(f.begin(), f.begin() + random() % 3, f.end());
    }
    return t;
  }
  Triangles turned() const { // exactly
    Triangles t = *this;
    for (auto& p : t.points) p = {p[1], p[2], p[0]};
    return t;
  }
  Triangles mirrored() const {
    Triangles t = *this;
    for (auto& p : t.points) p[0] = -p[0];
    for (auto& f : t.faces) std::swap(f[0], f[1]);
    return t;
  }
  Triangles scaled(double factor) const {
    Triangles t = *this;
    for (auto& p : t.points)
      for (double& x : p) x *= factor;
    return t;
  }
};

inline Triangles tetrahedron() {
  return {{{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

inline Triangles octahedron() {
  return {{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}};
}

/// A box with the corner at the origin.
inline Triangles box(double x, double y, double z) {
  Triangles t;
  for (std::uint32_t k = 0; k < 8; ++k)
    t.points.push_back({(k & 1U) != 0 ? x : 0, (k & 2U) != 0 ? y : 0, (k & 4U) != 0 ? z : 0});
  const std::array<std::uint32_t, 4> quads[] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& [a, b, c, d] : quads) {
    t.faces.push_back({a, b, c});
    t.faces.push_back({a, c, d});
  }
  return t;
}

inline IT::Intrinsic_input equilateral(std::uint32_t vertices,
                                       const std::vector<std::array<std::uint32_t, 3>>& faces) {
  IT::Gluing_map mesh(IT::gluing_from_triangles(vertices, faces));
  std::vector<double> lengths(mesh.number_of_edges(), 1);
  return IT::Intrinsic_input(std::move(mesh), std::move(lengths));
}

inline const std::vector<std::array<std::uint32_t, 3>>& icosahedron_faces() {
  static const std::vector<std::array<std::uint32_t, 3>> faces{
      {0, 1, 2},  {0, 2, 3},  {0, 3, 4},  {0, 4, 5},  {0, 5, 1},   {1, 6, 2},  {2, 6, 7},
      {2, 7, 3},  {3, 7, 8},  {3, 8, 4},  {4, 8, 9},  {4, 9, 5},   {5, 9, 10}, {5, 10, 1},
      {1, 10, 6}, {11, 7, 6}, {11, 8, 7}, {11, 9, 8}, {11, 10, 9}, {11, 6, 10}};
  return faces;
}

} // namespace triangle_lists

#endif // TEST_TRIANGLE_LISTS_H
