// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/proofs/field.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/prism.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>

#include "gallery.h"
#include "meshes.h"
#include "random_history.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Answer;
using random_history::make_delaunay;
using random_history::Map;
using random_history::Walk;
using random_history::walk_on;

// over unfolded faces against repeating the flips, for all edges and expressions
template <class Expression>
std::size_t compare(const Walk& walk, const Expression& expression) {
  const IT::Field_proof proof;
  std::size_t zeros = 0;
  for (const Map::Halfedge h : walk.inner_edges()) {
    const auto d = walk.unfolded(h);
    if (!d) continue;
    const auto& recorded = IT::recorded(expression);
    const auto replayed = walk.replayed(h);
    const Answer a = proof(IT::Question{walk.input, *d, recorded});
    EXPECT_EQ(a, proof(IT::Question{walk.input, replayed, recorded}));
    const Answer in_prism = IT::Prism_in_field_proof()(IT::Question{walk.input, *d, recorded});
    EXPECT_TRUE(in_prism == a || in_prism == Answer::open);
    zeros += a == Answer::zero;
  }
  return zeros;
}

std::size_t compare_all(const Walk& walk) {
  return compare(walk, IT::Delaunay_expression()) +
         compare(walk, IT::Convexity_at_source_expression()) +
         compare(walk, IT::Convexity_at_target_expression());
}

TEST(Field_proof, agrees_with_repeated_flips_on_a_box) {
  std::mt19937 random(1);
  Walk walk = walk_on(meshes::box(2, 1, 1));
  std::size_t zeros = compare_all(walk);
  for (int round = 0; round < 5; ++round) {
    walk.run(15, random);
    zeros += compare_all(walk);
  }
  EXPECT_GT(zeros, 50U);
}

TEST(Field_proof, agrees_with_repeated_flips_on_folded_lattices) {
  std::mt19937 random(2);
  Walk walk = walk_on(meshes::folded_lattice(3, 4, 1));
  walk.run(30, random);
  compare_all(walk);
  make_delaunay(walk);
  EXPECT_GT(compare_all(walk), 3U);
}

TEST(Field_proof, agrees_with_repeated_flips_on_squared_lengths_and_with_mollification) {
  std::mt19937 random(3);
  Walk torus = walk_on(gallery::flat_torus(3, 3));
  torus.run(40, random);
  compare_all(torus);
  make_delaunay(torus);
  EXPECT_GT(compare_all(torus), 3U);
  Walk mollified = walk_on(meshes::box(2, 1, 1), std::ldexp(1.0, -31));
  mollified.run(20, random);
  compare_all(mollified);
}

TEST(Field_proof, agrees_with_repeated_flips_on_Delta_complexes) {
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    std::mt19937 random(4);
    Walk walk = walk_on(s);
    for (int round = 0; round < 4; ++round) {
      walk.run(4, random);
      compare_all(walk);
    }
  }
}

TEST(Field_proof, agrees_with_repeated_flips_on_random_walls_with_and_without_an_ulp) {
  // hinges along an axis and along diagonals, planes of rational and of irrational area
  std::mt19937 random(8);
  std::uniform_int_distribution<int> step(1, 9);
  for (const bool is_moved : {false, true}) {
    std::size_t zeros = 0;
    for (int round = 0; round < 6; ++round) {
      std::vector<std::array<double, 2>> polygon{{0, 0}};
      for (int i = 0; i < 4; ++i)
        polygon.push_back(
            {polygon.back()[0] + step(random) / 8.0, polygon.back()[1] + (step(random) - 5) / 8.0});
      meshes::Mesh m = meshes::walls(polygon, 2);
      if (is_moved)
        for (auto& p : m.points) p[2] = std::nextafter(p[2], random() % 2 == 0 ? 9 : p[2]);
      Walk walk = walk_on(m);
      walk.run(20, random);
      compare_all(walk);
      make_delaunay(walk);
      zeros += compare_all(walk);
    }
    if (!is_moved) {
      EXPECT_GT(zeros, 20U);
    }
  }
}

TEST(Field_proof, certifies_all_ties_of_a_shuffled_box) {
  std::mt19937 random(5);
  Walk walk = walk_on(meshes::box(3, 3, 3));
  walk.run(300, random);
  // the Delaunay tessellation of the cubical grid: each of the 54 squares has one tie, its diagonal
  EXPECT_EQ(make_delaunay(walk), 54U);
  EXPECT_EQ(walk.statistics.probable_zero, 0U);
}

TEST(Field_proof, certifies_the_ties_of_sheared_walls_that_pass_many_planes) {
  // rolling out the walls of a prism gives a rectangle; shearing it makes the ties pass over edges
  for (const std::uint32_t sides : {6U, 10U, 16U}) {
    std::vector<std::array<double, 2>> polygon{{0, 0}};
    for (std::uint32_t i = 1; i < sides;
         ++i) // steps of length 5 in directions that repeat no plane
      polygon.push_back({polygon.back()[0] + (i % 2 == 0 ? 3.0 : 4.0),
                         polygon.back()[1] + (i % 2 == 0 ? 4.0 : -3.0)});
    meshes::Mesh m = meshes::walls(polygon, 3);
    for (auto& p : m.points) p[2] *= 5;
    Walk walk = walk_on(m);
    std::mt19937 random(6);
    walk.run(20 * sides, random);
    EXPECT_GT(make_delaunay(walk), sides);
    EXPECT_EQ(walk.statistics.probable_zero, 0U);
  }
}

TEST(Field_proof, tells_a_tie_from_a_value_of_two_to_the_minus_fifty) {
  for (const double lift : {0.0, std::ldexp(1.0, -50)}) {
    meshes::Mesh m = meshes::box(1, 1, 1);
    m.points[0][0] += lift;
    Walk walk = walk_on(m);
    // the twelve edges of the cube are at right angles; the other six are diagonals of its faces
    std::vector<Map::Halfedge> diagonals;
    for (const Map::Halfedge h : walk.inner_edges())
      if (walk.is_convex(h) && walk.sign(h, IT::Delaunay_expression()) != CGAL::POSITIVE)
        diagonals.push_back(h);
    for (const Map::Halfedge h : diagonals)
      for (int i = 0; i < 3; ++i) walk.flip(h);
    std::size_t ties = 0;
    for (const Map::Halfedge h : walk.inner_edges())
      ties += walk.sign(h, IT::Delaunay_expression()) == CGAL::ZERO;
    if (lift == 0)
      EXPECT_EQ(ties, 6U);
    else
      EXPECT_LT(ties, 6U);
  }
}

TEST(Field_proof, survives_flips_whose_paths_are_too_long) {
  Walk walk = walk_on(gallery::one_vertex_torus());
  for (std::uint32_t i = 0; i < 60; ++i) walk.flip(Map::Halfedge{2 * (i % 3)});
  EXPECT_FALSE(walk.unfolded(Map::Halfedge{0}));
  // thin parallelograms of a flat torus: far from any circle
  const IT::Field_proof proof;
  const auto replayed = walk.replayed(Map::Halfedge{0});
  EXPECT_EQ(proof(IT::Question{walk.input, replayed, IT::recorded(IT::Delaunay_expression())}),
            Answer::not_zero);
  EXPECT_NE(walk.sign(Map::Halfedge{0}, IT::Delaunay_expression()), CGAL::ZERO);
}

} // namespace
