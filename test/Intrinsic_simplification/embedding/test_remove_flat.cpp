// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "convex_polyhedra.h"

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_simplification/embedding/embed_convex.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Flat vertices of a polyhedron are removed, found again, and told from those that hardly are.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using namespace convex_polyhedra;

TEST(EmbedFlatVertices, putsFlatVerticesBack) {
  const std::vector<std::pair<Point, int>> boxes{
      {{1, 1, 1}, 6}, {{1, 1, .02}, 4}, {{1, 1, .02}, 10}, {{3, 1, .1}, 3}, {{1, 1, .02}, 18}};
  for (const auto& [sides, n] : boxes) {
    SCOPED_TRACE(std::to_string(sides[2]));
    const Mesh mesh = box(sides, n);
    const IT::Convex_polyhedron p = IT::embed_convex(IT::Corresponding_triangulation(mesh));
    ASSERT_EQ(p.status, IT::Status::done);
    EXPECT_EQ(p.flat_vertices.size(), mesh.number_of_vertices() - 8);
    EXPECT_LT(error_of_distances(p.points, mesh), 1e-13);
    EXPECT_EQ(p.faces.size(), mesh.number_of_faces());
    EXPECT_LT(greatest_height(p), 1e-13);
    EXPECT_TRUE(p.certificate.is_proven);
    EXPECT_GE(p.certificate.convex_edges, 12U); // those of the box; of some boxes diagonals, too
    const IT::Convex_polyhedron flipped = IT::embed_convex(lengths_only(mesh, 3));
    ASSERT_EQ(flipped.status, IT::Status::done);
    EXPECT_LT(error_of_distances(flipped.points, mesh), 1e-12);
    // rounded lengths leave some curvature at vertices of flat faces
    EXPECT_TRUE(flipped.certificate.is_proven);
    EXPECT_GT(flipped.certificate.stretch, 0);
    EXPECT_LT(flipped.certificate.stretch, 1e-10);
  }
}

// A low pyramid on a cube, whose tip is made flat: by symmetry all four edges at it take the length
// of half a diagonal, and in their direction curves are stretched as they are.
TEST(EmbedFlatVertices, boundsTheStretchOfFlatVertices) {
  for (const double height : {1e-6, 1e-4, 1e-2}) {
    SCOPED_TRACE(std::to_string(height));
    std::vector<Point> points{{.5, .5, 1 + height}};
    for (int c = 0; c < 8; ++c) points.push_back({c % 2 * 1., c / 2 % 2 * 1., c / 4 * 1.});
    const Mesh mesh = hull_of(points);
    IT::Embed_options options;
    options.flat_within = 10 * height * height;
    const IT::Convex_polyhedron p =
        IT::embed_convex(IT::Corresponding_triangulation(mesh), options);
    ASSERT_EQ(p.status, IT::Status::done);
    EXPECT_EQ(p.flat_vertices.size(), 1U);
    EXPECT_TRUE(p.certificate.is_proven);
    const double least = std::hypot(std::sqrt(.5), height) / std::sqrt(.5) - 1;
    EXPECT_GT(p.certificate.stretch, least * (1 - 1e-3));
    EXPECT_LT(p.certificate.stretch, 4 * least);
  }
}

// Vertices that get the curvature of flat neighbours do not count as flat.
TEST(EmbedFlatVertices, keepsCornersThatFlatNeighborsMake) {
  const Mesh mesh = hull_of(random_points(300, {1, 1, 1}, 1));
  for (const double within : {.01, .05, .1}) {
    SCOPED_TRACE(within);
    IT::Embed_options options;
    options.flat_within = within;
    const IT::Convex_polyhedron p =
        IT::embed_convex(IT::Corresponding_triangulation(mesh), options);
    ASSERT_FALSE(p.points.empty()) << IT::reason_without_points(p);
    EXPECT_LT(p.flat_vertices.size(), 290U);
    EXPECT_LT(error_of_distances(p.points, mesh), .2);
    EXPECT_EQ(p.status == IT::Status::done, std::isfinite(p.certificate.stretch));
  }
}

TEST(EmbedFlatVertices, refusesAnglesThatAreNoneForFlatVertices) {
  const IT::Corresponding_triangulation t(box({1, 1, 1}, 1));
  for (const double angle : {-1., 1., std::nan("")}) {
    IT::Embed_options options;
    options.flat_within = angle;
    EXPECT_THROW(IT::embed_convex(t, options), IT::Invalid_input);
  }
}

// A box whose faces are paraboloids.
Mesh bent_box(int points_by_axis, double bend, unsigned seed) {
  std::vector<Point> points;
  for (int c = 0; c < 8; ++c)
    points.push_back({c % 2 * 2. - 1, c / 2 % 2 * 2. - 1, c / 4 * 2. - 1});
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int k = 0; k < points_by_axis; ++k) {
      Point p{uniform(random), uniform(random), uniform(random)};
      const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
      p[axis] = (k % 2 * 2 - 1) * (1 + bend * (2 - p[a] * p[a] - p[b] * p[b]));
      points.push_back(p);
    }
  return hull_of(points);
}

// Curvatures of the surface are 1e-9 to 1e-5, or 1e-13 to 1e-9: lengths are rounded by 1e-16.
TEST(EmbedFlatVertices, findsFacesThatAreHardlyBent) {
  for (const double bend : {1e-3, 1e-5}) {
    SCOPED_TRACE(std::to_string(bend));
    const Mesh mesh = bent_box(40, bend, 2);
    IT::Embed_options options;
    options.flat_within = 1e-12;
    const IT::Convex_polyhedron p = IT::embed_convex(lengths_only(mesh, 4), options);
    ASSERT_EQ(p.status, IT::Status::done) << IT::reason_without_points(p);
    EXPECT_LT(error_of_distances(p.points, mesh), bend * 1e-1);
    EXPECT_TRUE(p.certificate.is_proven);
    EXPECT_LT(p.certificate.within, 1e-14);
    EXPECT_TRUE(bend < 1e-3 || p.flat_vertices.empty());
  }
}

// Derivatives are so nearly singular that a proof takes more than 64 bits.
TEST(EmbedFlatVertices, provesFacesWithTheLeastBends) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Mesh mesh = bent_box(20, 1e-7, seed);
    IT::Embed_options options;
    options.flat_within = 1e-15;
    const IT::Convex_polyhedron p = IT::embed_convex(lengths_only(mesh, 4), options);
    ASSERT_EQ(p.status, IT::Status::done) << IT::reason_without_points(p);
    EXPECT_LT(error_of_distances(p.points, mesh), 1e-7);
    EXPECT_TRUE(p.certificate.is_proven) << seed;
    EXPECT_LT(p.certificate.within, 1e-14);
  }
}

} // namespace
