// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "convex_polyhedra.h"
#include "flat_surfaces.h"

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_simplification/embedding/embed_convex.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <string>
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

TEST(EmbedPolygons, knowsDoublyCoveredPolygons) {
  std::vector<std::vector<std::complex<double>>> polygons{{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                                                          {{0, 0}, {3, 0}, {1, .2}},
                                                          {{0, 0}, {1, 0}, {1, .02}, {0, .02}}};
  for (const std::size_t n : {5U, 12U, 40U}) {
    polygons.emplace_back();
    for (std::size_t k = 0; k < n; ++k) {
      const double a = 2 * std::numbers::pi * static_cast<double>(k * k + 3 * k) /
                       static_cast<double>(n * n + 3 * n);
      polygons.back().emplace_back(std::cos(a), .3 * std::sin(a));
    }
  }
  for (const auto& corners : polygons) {
    SCOPED_TRACE(std::to_string(corners.size()) + " corners");
    const IT::Convex_polyhedron p = IT::embed_convex(
        IT::Corresponding_triangulation(flat::input_of(flat::Surface::doubled_polygon(corners))));
    ASSERT_EQ(p.status, IT::Status::done) << p.steps;
    EXPECT_EQ(p.shape, IT::Convex_shape::doubly_covered_polygon);
    for (std::size_t v = 0; v < corners.size(); ++v) {
      EXPECT_EQ(p.points[v][2], 0);
      for (std::size_t w = 0; w < v; ++w)
        EXPECT_NEAR(distance(p.points[v], p.points[w]), std::abs(corners[v] - corners[w]), 1e-12);
    }
  }
}

} // namespace
