// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_HYPERBOLIC_SURFACES_H
#define TEST_HYPERBOLIC_SURFACES_H

#include "gallery.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

/// Surfaces of genus 2 and 3 with symmetries, whose hyperbolic metrics are known in closed form.
namespace hyperbolic {

/// returns the length of a side of a hyperbolic triangle with given angles, the first one opposite.
inline double side(double opposite, double b, double c) {
  return std::acosh((std::cos(opposite) + std::cos(b) * std::cos(c)) / (std::sin(b) * std::sin(c)));
}

/// A regular octagon, glued by a b a^-1 b^-1 c d c^-1 d^-1, and its centre: triangles with sides of
/// length 1 and spokes of the given length.
inline gallery::Surface octagon(double spoke) {
  std::vector<gallery::Glued> pairs{{0, 6}, {3, 9}, {12, 18}, {15, 21}};
  for (std::uint32_t k = 0; k < 8; ++k) pairs.push_back({3 * k + 1, 3 * ((k + 1) % 8) + 2});
  return gallery::abstract("octagon", gallery::glue(8, pairs), {2, 12, 8, 0, 1, 2},
                           {1, spoke * spoke, spoke * spoke});
}

/// The surface of Bolza: the cover of two sheets of the octahedron that branches at its vertices.
/// Eight triangles meet at each.
inline gallery::Surface bolza() {
  // corners x, y, z and -x, -y, -z are 0, 1, 2 and 3, 4, 5; face f has signs of its bits
  const auto corner = [](std::uint32_t f, std::uint32_t side) {
    const bool is_odd = ((f ^ f >> 1U ^ f >> 2U) & 1U) != 0; // such triangles are counterclockwise
    const std::uint32_t axis = is_odd ? 2 - side % 3 : side % 3;
    return axis + 3 * (f >> axis & 1U);
  };
  const auto edge = [&](std::uint32_t h) {
    return std::pair(corner(h / 3, h % 3), corner(h / 3, h % 3 + 1));
  };
  // edges that join the sheets, one at each vertex
  const auto joins = [](std::pair<std::uint32_t, std::uint32_t> e) {
    const std::uint32_t low = std::min(e.first, e.second), high = std::max(e.first, e.second);
    return std::pair(low, high) == std::pair(0U, 1U) || std::pair(low, high) == std::pair(2U, 3U) ||
           std::pair(low, high) == std::pair(4U, 5U);
  };
  std::vector<gallery::Glued> pairs;
  for (std::uint32_t g = 0; g < 24; ++g)
    for (std::uint32_t h = 0; h < g; ++h) {
      const auto [a, b] = edge(h);
      if (edge(g) != std::pair(b, a)) continue;
      for (std::uint32_t sheet = 0; sheet < 2; ++sheet)
        pairs.push_back({24 * sheet + h, 24 * (joins({a, b}) ? 1 - sheet : sheet) + g});
    }
  return gallery::abstract("Bolza", gallery::glue(16, pairs), {6, 24, 16, 0, 1, 2});
}

/// The quartic of Klein: 56 triangles, seven at each vertex. Its sides are the elements of the
/// group PSL(2, 7), of which r of order 3 turns around triangles, and s of order 2 across edges.
inline gallery::Surface klein_quartic() {
  using Matrix = std::array<int, 4>;
  const auto times = [](const Matrix& a, const Matrix& b) {
    Matrix m{a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2],
             a[2] * b[1] + a[3] * b[3]};
    Matrix minus = m;
    for (int& x : m) x = (x % 7 + 7) % 7;
    for (int& x : minus) x = (7 - (x % 7 + 7) % 7) % 7;
    return std::min(m, minus);
  };
  const Matrix r{0, -1, 1, 1}, s{0, -1, 1, 0};
  std::map<Matrix, std::uint32_t> number;
  std::vector<Matrix> sides{times(r, times(r, r))}; // one
  const auto add_face = [&](Matrix g) {
    for (int k = 0; k < 3; ++k, g = times(g, r))
      if (number.emplace(g, static_cast<std::uint32_t>(number.size())).second && number.size() > 1)
        sides.push_back(g);
  };
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (const Matrix& g : {Matrix(sides[i]), times(sides[i], s)})
      if (number.count(g) == 0) add_face(g);
  std::vector<gallery::Glued> pairs;
  for (const Matrix& g : sides)
    if (const auto other = number.at(times(g, s)); number.at(g) < other)
      pairs.push_back({number.at(g), other});
  return gallery::abstract("Klein", gallery::glue(56, pairs), {24, 84, 56, 0, 1, 3});
}

} // namespace hyperbolic

#endif // TEST_HYPERBOLIC_SURFACES_H
