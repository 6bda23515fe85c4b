// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_STRAIGHT_SEGMENTS_H
#define TEST_INTRINSIC_TRIANGULATIONS_STRAIGHT_SEGMENTS_H

#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

/// Distances on small surfaces by brute force: every straight segment between two vertices that
/// passes through no face twice is found by unfolding; the shortest chains of these are the
/// shortest paths (Mitchell, Mount, Papadimitriou 1987) if faces are triangles in space. Copies of
/// a vertex on a cover are one vertex.
namespace straight_segments {

namespace IT = CGAL::Intrinsic_triangulations;

/// Distances between the user's vertices, in scaled units.
class Distances {
public:
  explicit Distances(const IT::Input& input) : input_(input), is_used_(input.number_of_faces(), 0) {
    std::size_t n = 0;
    for (std::uint32_t v = 0; v < input.number_of_vertices(); ++v)
      n = std::max<std::size_t>(n, input.names().row(v) + std::size_t{1});
    distance_.assign(n, std::vector<double>(n, std::numeric_limits<double>::infinity()));
    for (std::uint32_t f = 0; f < input.number_of_faces(); ++f) {
      std::uint32_t h = input.halfedge_of_face(f);
      for (int k = 0; k < 3; ++k, h = input.next(h)) look_through(h);
    }
    for (std::size_t i = 0; i < n; ++i) distance_[i][i] = 0;
    for (std::size_t k = 0; k < n; ++k) // Floyd and Warshall
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          distance_[i][j] = std::min(distance_[i][j], distance_[i][k] + distance_[k][j]);
  }

  double operator()(std::uint32_t i, std::uint32_t j) const { return distance_[i][j]; }

private:
  using Place = std::array<double, 2>;

  static double cross(const Place& a, const Place& b) { return a[0] * b[1] - a[1] * b[0]; }
  double length(std::uint32_t h) const { return std::sqrt(input_.squared_length(h / 2)); }
  std::uint32_t row(std::uint32_t h) const { return input_.names().row(input_.source(h)); }
  // the apex of the face of a halfedge from a to b, on its left
  Place apex(std::uint32_t h, const Place& a, const Place& b) const {
    const double l = length(h), p = length(input_.next(input_.next(h))), q = length(input_.next(h));
    const double x = (l * l + p * p - q * q) / (2 * l);
    const double y = std::sqrt(std::max(0.0, p * p - x * x));
    const Place u{(b[0] - a[0]) / l, (b[1] - a[1]) / l};
    return {a[0] + x * u[0] - y * u[1], a[1] + x * u[1] + y * u[0]};
  }
  void take(std::uint32_t i, std::uint32_t j, double d) {
    distance_[i][j] = distance_[j][i] = std::min(distance_[i][j], d);
  }

  // from the source of a halfedge through its face
  void look_through(std::uint32_t h) {
    const std::uint32_t far = input_.next(h);
    take(row(h), row(far), length(h));
    const Place a{length(h), 0}, b = apex(h, {0, 0}, a);
    is_used_[input_.face(h)] = 1;
    look_through(row(h), far, a, b, a, b);
    is_used_[input_.face(h)] = 0;
  }
  // through a side from a to b, between the rays to `right` and `left`
  void look_through(std::uint32_t v, std::uint32_t side, const Place& a, const Place& b,
                    const Place& right, const Place& left) {
    const std::uint32_t o = side ^ 1U;
    if (input_.is_border(o) || is_used_[input_.face(o)] != 0) return;
    const std::uint32_t from_a = input_.next(o), to_b = input_.next(from_a);
    const Place c = apex(o, b, a);
    const bool is_left = cross(right, c) >= 0, is_right = cross(c, left) >= 0;
    if (is_left && is_right) take(v, row(to_b), std::hypot(c[0], c[1]));
    is_used_[input_.face(o)] = 1;
    if (is_left) look_through(v, from_a, a, c, right, is_right ? c : left);
    if (is_right) look_through(v, to_b, c, b, is_left ? c : right, left);
    is_used_[input_.face(o)] = 0;
  }

  const IT::Input& input_;
  std::vector<std::vector<double>> distance_;
  std::vector<char> is_used_; // per face
};

} // namespace straight_segments

#endif // TEST_INTRINSIC_TRIANGULATIONS_STRAIGHT_SEGMENTS_H
