// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_TUFTED_ORACLE_H
#define TEST_INTRINSIC_TRIANGULATIONS_TUFTED_ORACLE_H

#include "meshes.h"
#include "oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

// The tufted cover of triangles by its definition only.

namespace soups {

using meshes::Mesh;

/// The Laplacian of the tufted cover, by its definition, in 400 digits: twice that of the soup.
/// Angles around edges must differ.
inline oracle::Answer tufted(const Mesh& m) {
  using Oracle = oracle::Triangulation<oracle::Wide_float>;
  Mesh both{m.points, {}};
  for (const auto& [i, j, k] : m.triangles) {
    both.triangles.push_back({i, j, k});
    both.triangles.push_back({j, i, k});
  }
  // for each edge, by angle, the triangle that runs along it from the lower vertex, and the one that
  // runs back
  using Vector = std::array<double, 3>;
  const auto minus = [](const Vector& a, const Vector& b) {
    return Vector{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  const auto dot = [](const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const auto cross = [](const Vector& a, const Vector& b) {
    return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  struct Leaf {
    Oracle::Side there, back;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::multimap<double, Leaf>> edges;
  for (std::size_t f = 0; f < both.triangles.size(); f += 2)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& t = both.triangles[f];
      const std::uint32_t u = std::min(t[k], t[(k + 1) % 3]), v = std::max(t[k], t[(k + 1) % 3]);
      const Vector e = minus(m.points[v], m.points[u]);
      const Vector x =
          cross(e, std::abs(e[0]) < std::abs(e[1]) ? Vector{1, 0, 0} : Vector{0, 1, 0});
      const Vector y = cross(e, x), p = minus(m.points[t[(k + 2) % 3]], m.points[u]);
      const double angle = std::atan2(dot(p, y) / std::sqrt(dot(e, e)), dot(p, x));
      Leaf leaf{};
      for (const std::size_t copy : {f, f + 1})
        for (std::size_t s = 0; s < 3; ++s) {
          const auto& c = both.triangles[copy];
          if (c[s] == u && c[(s + 1) % 3] == v) leaf.there = {copy, s};
          if (c[s] == v && c[(s + 1) % 3] == u) leaf.back = {copy, s};
        }
      edges[{u, v}].insert({angle, leaf});
    }
  std::vector<std::array<Oracle::Side, 3>> across(both.triangles.size());
  for (const auto& [uv, leaves] : edges)
    for (auto i = leaves.begin(); i != leaves.end(); ++i) {
      const auto j = std::next(i) == leaves.end() ? leaves.begin() : std::next(i);
      const Oracle::Side a = i->second.there, b = j->second.back;
      across[a.triangle][a.k] = b;
      across[b.triangle][b.k] = a;
    }
  return Oracle(both, across).flip_to_delaunay();
}

} // namespace soups

#endif // TEST_INTRINSIC_TRIANGULATIONS_TUFTED_ORACLE_H
