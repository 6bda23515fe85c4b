// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_PATHS_H
#define TEST_INTRINSIC_TRIANGULATIONS_PATHS_H

#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

// Paths over a triangulation, measured by its lengths and areas alone.

namespace paths {

using CGAL::Intrinsic_triangulations::Surface_point;
using Weights = std::array<double, 3>;

/// The length of a path, whose halfedges must follow each other.
template <class T>
double length_of_path(const T& t, const std::vector<typename T::halfedge_descriptor>& path) {
  double length = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    length += t.length(edge(path[i], t.mesh()));
    if (i > 0) {
      EXPECT_EQ(target(path[i - 1], t.mesh()), source(path[i], t.mesh()));
    }
  }
  return length;
}

/// A point with random weights in a random face.
template <class Triangulation>
Surface_point random_point(const Triangulation& t, std::mt19937& random) {
  const auto uniform = [&random] { return (static_cast<double>(random()) + 0.5) / 0x1p32; };
  auto f = faces(t.mesh()).begin();
  for (std::size_t i = random() % num_faces(t.mesh()); i > 0; --i) ++f;
  const double a = uniform(), b = uniform();
  const Weights w = a + b < 1 ? Weights{1 - a - b, a, b} : Weights{a + b - 1, 1 - a, 1 - b};
  return {t.numbers().halfedge(halfedge(*f, t.mesh())), w};
}

/// The weights, in the order of the face of `h`, of the descriptions of a point that lie in that face.
template <class Triangulation>
std::vector<Weights> seen_from(const Triangulation& t,
                               typename Triangulation::halfedge_descriptor h,
                               const Surface_point& p) {
  const auto& mesh = t.mesh();
  const typename Triangulation::halfedge_descriptor g = t.numbers().halfedge_at(p.halfedge);
  const Weights& w = p.weights;
  std::vector<Weights> result;
  for (std::size_t k = 0; k < 3; ++k, h = next(h, mesh)) {
    if (h == g) result.push_back({w[(3 - k) % 3], w[(4 - k) % 3], w[(5 - k) % 3]});
    Weights u{0, 0, 0};
    u[k] = w[1];
    u[(k + 1) % 3] = w[0];
    if (opposite(h, mesh) == g && w[2] == 0) result.push_back(u);
    u = {0, 0, 0};
    u[k] = 1;
    if (w[0] == 1 && source(h, mesh) == source(g, mesh)) result.push_back(u);
  }
  return result;
}

/// The distance in the plane of points of a face with given weights; laid out along its longest side, as that is accurate in
/// needles.
template <class Triangulation>
double distance_in_face(const Triangulation& t, typename Triangulation::halfedge_descriptor h,
                        Weights p, Weights q) {
  const auto& mesh = t.mesh();
  const auto length = [&](typename Triangulation::halfedge_descriptor g) {
    return t.length(edge(g, mesh));
  };
  while (length(h) < length(next(h, mesh)) || length(h) < length(next(next(h, mesh), mesh))) {
    h = next(h, mesh);
    std::rotate(p.begin(), p.begin() + 1, p.end());
    std::rotate(q.begin(), q.begin() + 1, q.end());
  }
  const double a = length(h), b = length(next(h, mesh)), c = length(next(next(h, mesh), mesh));
  const double x = ((a - b) * (a + b) + c * c) / (2 * a), y = 2 * t.area(face(h, mesh)) / a;
  return std::hypot((p[1] - q[1]) * a + (p[2] - q[2]) * x, (p[2] - q[2]) * y);
}

/// The length of a piece that lies in the face of its first point; infinity if it does not.
template <class Triangulation>
double length_of_piece(const Triangulation& t, const Surface_point& p, const Surface_point& q) {
  const typename Triangulation::halfedge_descriptor h = t.numbers().halfedge_at(p.halfedge);
  double least = std::numeric_limits<double>::infinity();
  for (const Weights& w : seen_from(t, h, q))
    least = std::min(least, distance_in_face(t, h, p.weights, w));
  return least;
}

template <class Triangulation>
double length_of_path(const Triangulation& t, const std::vector<Surface_point>& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += length_of_piece(t, path[i - 1], path[i]);
  return sum;
}

} // namespace paths

#endif // TEST_INTRINSIC_TRIANGULATIONS_PATHS_H
