// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_STRAIGHT_SEGMENTS_H
#define TEST_INTRINSIC_TRIANGULATIONS_STRAIGHT_SEGMENTS_H

#include "meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

/// Distances on small manifold meshes in space by brute force: every straight segment between two
/// vertices that passes through no face twice is found by unfolding; the shortest chains of these
/// are the shortest paths (Mitchell, Mount, Papadimitriou 1987).
namespace straight_segments {

class Distances {
public:
  explicit Distances(const meshes::Mesh& mesh)
      : mesh_(mesh),
        distance_(mesh.points.size(),
                  std::vector<double>(mesh.points.size(), std::numeric_limits<double>::infinity())),
        is_used_(mesh.triangles.size(), 0) {
    for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        face_[{mesh.triangles[f][k], mesh.triangles[f][(k + 1) % 3]}] = f;
    for (const auto& [side, f] : face_) look_from(apex(f, side), side, f);
    const std::size_t n = distance_.size(); // Floyd and Warshall
    for (std::size_t i = 0; i < n; ++i) distance_[i][i] = 0;
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          distance_[i][j] = std::min(distance_[i][j], distance_[i][k] + distance_[k][j]);
  }

  double operator()(std::uint32_t i, std::uint32_t j) const { return distance_[i][j]; }

private:
  using Side = std::pair<std::uint32_t, std::uint32_t>;
  using Place = std::array<double, 2>;

  static double cross(const Place& a, const Place& b) { return a[0] * b[1] - a[1] * b[0]; }
  double length(std::uint32_t i, std::uint32_t j) const {
    const meshes::Point &a = mesh_.points[i], &b = mesh_.points[j];
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }
  std::uint32_t apex(std::uint32_t f, const Side& side) const {
    for (const std::uint32_t v : mesh_.triangles[f])
      if (v != side.first && v != side.second) return v;
    return side.first;
  }
  // the apex on the left of a side
  Place place(const Side& side, const Place& a, const Place& b, std::uint32_t v) const {
    const double l = length(side.first, side.second), p = length(side.first, v),
                 q = length(side.second, v);
    const double x = (l * l + p * p - q * q) / (2 * l);
    const double y = std::sqrt(std::max(0.0, p * p - x * x));
    const Place u{(b[0] - a[0]) / l, (b[1] - a[1]) / l};
    return {a[0] + x * u[0] - y * u[1], a[1] + x * u[1] + y * u[0]};
  }

  void take(std::uint32_t i, std::uint32_t j, double d) {
    distance_[i][j] = std::min(distance_[i][j], d);
    distance_[j][i] = distance_[i][j];
  }

  void look_from(std::uint32_t v, const Side& side, std::uint32_t f) {
    take(side.first, side.second, length(side.first, side.second));
    const Place a{length(v, side.first), 0};
    const Place b = place({v, side.first}, {0, 0}, a, side.second);
    is_used_[f] = 1;
    look_through(v, side, a, b, a, b);
    is_used_[f] = 0;
  }
  // through a side from a to b, between the rays to `right` and `left`
  void look_through(std::uint32_t v, const Side& side, const Place& a, const Place& b,
                    const Place& right, const Place& left) {
    const auto found = face_.find({side.second, side.first});
    if (found == face_.end() || is_used_[found->second] != 0) return;
    const std::uint32_t w = apex(found->second, side);
    const Place c = place({side.second, side.first}, b, a, w);
    const bool is_left = cross(right, c) >= 0, is_right = cross(c, left) >= 0;
    if (is_left && is_right) take(v, w, std::hypot(c[0], c[1]));
    is_used_[found->second] = 1;
    if (is_left) look_through(v, {side.first, w}, a, c, right, is_right ? c : left);
    if (is_right) look_through(v, {w, side.second}, c, b, is_left ? c : right, left);
    is_used_[found->second] = 0;
  }

  const meshes::Mesh& mesh_;
  std::vector<std::vector<double>> distance_;
  std::vector<char> is_used_;          // per face
  std::map<Side, std::uint32_t> face_; // on the left
};

} // namespace straight_segments

#endif // TEST_INTRINSIC_TRIANGULATIONS_STRAIGHT_SEGMENTS_H
