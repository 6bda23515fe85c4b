// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "convex_polyhedra.h"

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_simplification/embedding/embed_convex.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

// Polygons with a front and a back, and polyhedra that are nearly such ones.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using namespace convex_polyhedra;

// Lengths of a square, front and back, whose corners are nearly in a plane: a polyhedron with the
// height 1e-5, not the polygon, from which distances differ by 1e-11.
TEST(EmbedPolygons, tellsThinPolyhedraFromPolygons) {
  const Mesh thin = hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1e-5}});
  const IT::Convex_polyhedron p = IT::embed_convex(IT::Corresponding_triangulation(thin));
  EXPECT_EQ(p.status, IT::Status::done);
  EXPECT_EQ(p.shape, IT::Convex_shape::polyhedron);
  EXPECT_LT(error_of_distances(p.points, thin), 1e-14);
}

// Heights that polygons lack: the lengths of front and back differ by their squares.
TEST(EmbedPolygons, provesNoPolygonForAThinPolyhedronWithoutStretch) {
  for (const double height : {1e-5, 1e-6, 3e-7, 1e-7, 3e-8}) {
    SCOPED_TRACE(height);
    const Mesh thin = hull_of({{0, 0, 0}, {1, 0, height}, {1, 1, 0}, {0, 1, height}});
    const IT::Convex_polyhedron p = IT::embed_convex(IT::Corresponding_triangulation(thin));
    if (p.points.empty() || !p.certificate.is_proven) continue;
    EXPECT_LT(p.certificate.stretch, 1e-8);
    if (p.shape == IT::Convex_shape::doubly_covered_polygon) {
      EXPECT_GT(p.certificate.stretch, height * height / 8);
    } else {
      EXPECT_LT(error_of_distances(p.points, thin), 1e-14);
    }
  }
}

// A triangulation by a fan, and its copy in a mirror, glued along the border.
IT::Intrinsic_input two_copies(const std::vector<std::array<double, 2>>& corners) {
  const auto n = static_cast<std::uint32_t>(corners.size());
  IT::Gluing g;
  g.number_of_vertices = n;
  const auto add = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    g.origin.insert(g.origin.end(), {i, j, k});
  };
  for (std::uint32_t k = 1; k + 1 < n; ++k) add(0, k, k + 1);
  for (std::uint32_t k = 1; k + 1 < n; ++k) add(0, k + 1, k);
  const std::uint32_t half = 3 * (n - 2);
  g.glue.resize(g.origin.size());
  for (std::uint32_t h = 0; h < 2 * half; ++h) { // sides of one copy by their ends
    const std::uint32_t a = g.origin[h], b = g.origin[IT::Gluing::next(h)];
    const bool is_border = (a + 1) % n == b || (b + 1) % n == a;
    for (std::uint32_t o = 0; o < 2 * half; ++o)
      if (g.origin[o] == b && g.origin[IT::Gluing::next(o)] == a &&
          (o < half) == ((h < half) != is_border))
        g.glue[h] = o;
  }
  IT::Gluing_map map(g);
  std::vector<double> squared;
  for (const auto e : edges(map)) {
    const auto h = halfedge(e, map);
    const auto &p = corners[source(h, map).index], &q = corners[target(h, map).index];
    squared.push_back((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]));
  }
  return {std::move(map), std::move(squared), IT::Mollification::none};
}

TEST(EmbedPolygons, knowsDoublyCoveredPolygons) {
  std::vector<std::vector<std::array<double, 2>>> polygons{{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                                                           {{0, 0}, {3, 0}, {1, .2}},
                                                           {{0, 0}, {1, 0}, {1, .02}, {0, .02}}};
  for (const std::size_t n : {5U, 12U, 40U}) {
    polygons.emplace_back();
    for (std::size_t k = 0; k < n; ++k) {
      const double a = 2 * std::numbers::pi * static_cast<double>(k * k + 3 * k) /
                       static_cast<double>(n * n + 3 * n);
      polygons.back().push_back({std::cos(a), .3 * std::sin(a)});
    }
  }
  for (const auto& corners : polygons) {
    SCOPED_TRACE(std::to_string(corners.size()) + " corners");
    const IT::Convex_polyhedron p =
        IT::embed_convex(IT::Corresponding_triangulation(two_copies(corners)));
    ASSERT_EQ(p.status, IT::Status::done) << p.steps;
    EXPECT_EQ(p.shape, IT::Convex_shape::doubly_covered_polygon);
    for (std::size_t v = 0; v < corners.size(); ++v) {
      EXPECT_EQ(p.points[v][2], 0);
      for (std::size_t w = 0; w < v; ++w)
        EXPECT_NEAR(distance(p.points[v], p.points[w]),
                    std::hypot(corners[v][0] - corners[w][0], corners[v][1] - corners[w][1]),
                    1e-12);
    }
  }
}

} // namespace
