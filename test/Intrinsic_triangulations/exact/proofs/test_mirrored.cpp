// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/proofs/mirrored.h>

#include <CGAL/Intrinsic_triangulations/exact/proofs/field.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>

#include "meshes.h"
#include "random_history.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using random_history::Map;
using random_history::Walk;

// a sphere, stretched along an axis: symmetric by the planes of the others
meshes::Mesh ellipsoid(unsigned levels, double factor) {
  meshes::Mesh m = meshes::sphere(levels);
  for (auto& p : m.points) p[0] *= factor;
  return m;
}

Walk delaunay_walk(const meshes::Mesh& m) {
  Walk walk = random_history::walk_on(m);
  random_history::make_delaunay(walk);
  return walk;
}

bool is_mirrored(const Walk& walk, const IT::Unfolded_diamond& d) {
  return IT::Mirrored_proof()(IT::Question{
             walk.input, d, IT::recorded(IT::Delaunay_expression())}) == IT::Answer::zero;
}

TEST(Mirrored_proof, proves_the_ties_of_a_symmetric_surface_and_no_others) {
  const Walk walk = delaunay_walk(ellipsoid(2, 8));
  IT::Field_proof proof;
  std::size_t mirrored = 0, zeros = 0;
  for (const Map::Halfedge h : walk.inner_edges()) {
    const auto d = walk.unfolded(h);
    ASSERT_TRUE(d);
    if (d->triangles.size() > 8) continue; // which the general test takes long for
    const IT::Question question{walk.input, *d, IT::recorded(IT::Delaunay_expression())};
    const bool is_tie = proof(question) == IT::Answer::zero;
    const bool is_proven = is_mirrored(walk, *d);
    EXPECT_TRUE(is_tie || !is_proven);
    mirrored += is_proven;
    zeros += is_tie;
  }
  EXPECT_GT(mirrored, 5U);
  EXPECT_GT(zeros, mirrored); // rectangles over pairs of faces
}

TEST(Mirrored_proof, proves_nothing_after_a_vertex_has_moved_by_an_ulp) {
  meshes::Mesh m = ellipsoid(2, 8);
  std::mt19937 random(1);
  std::size_t before = 0, after = 0;
  for (const bool is_moved : {false, true}) {
    if (is_moved)
      for (auto& p : m.points)
        for (double& x : p) x = std::nextafter(x, random() % 2 == 0 ? 9.0 : -9.0);
    const Walk walk = delaunay_walk(m);
    for (const Map::Halfedge h : walk.inner_edges()) {
      const auto d = walk.unfolded(h);
      ASSERT_TRUE(d);
      const bool is_proven = is_mirrored(walk, *d);
      (is_moved ? after : before) += is_proven;
    }
  }
  EXPECT_GT(before, 0U);
  EXPECT_EQ(after, 0U);
}

TEST(Mirrored_proof, is_no_proof_for_kites) {
  // two isosceles triangles glued at their base are symmetric, and not cocircular
  meshes::Mesh kite{{{-1, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, -1.5, 0}}, {{0, 1, 2}, {1, 0, 3}}};
  Map map = kite.map();
  IT::Input_metric input = IT::Input_metric::from_points(map, kite.points, 0);
  const Walk walk(std::move(map), std::move(input));
  ASSERT_EQ(walk.inner_edges().size(), 1U);
  EXPECT_FALSE(is_mirrored(walk, *walk.unfolded(walk.inner_edges().front())));
}

} // namespace
