// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/proofs/mirrored.h>

#include <CGAL/Intrinsic_triangulations/exact/proofs/field.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>

#include "meshes.h"
#include "random_history.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

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
    if (d->triangles.size() > 12) continue; // which the general test takes long for
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

// A fan of triangles about a point, unfolded: its first two and its last two are mirrored, unless the
// last point is moved by an ulp; those in between are not symmetric. The corners of the outer ones
// are those of an isosceles trapezoid.
class Fan {
public:
  Fan(std::size_t middle, bool is_moved, std::mt19937& random)
      : walk_(make(middle, is_moved, random)) {
    const auto last = static_cast<std::uint32_t>(walk_.mesh.number_of_vertices() - 1);
    diamond_.triangles.start({0, 0});
    for (std::uint32_t n = 1; n + 1 < last; ++n) diamond_.triangles.enter(n - 1, 2, {n, 0});
    diamond_.corners = {{{0, 1}, {last - 2, 1}, {last - 2, 2}, {0, 2}}};
  }
  bool has_proof() const { return is_mirrored(walk_, diamond_); }
  IT::Answer in_field() const {
    return IT::Field_proof()(
        IT::Question{walk_.input, diamond_, IT::recorded(IT::Delaunay_expression())});
  }

private:
  static Walk make(std::size_t middle, bool is_moved, std::mt19937& random) {
    std::uniform_real_distribution<double> x(-1, 1);
    meshes::Mesh m{{{0, 0, 0}}, {}};
    const auto add = [&](double a, double b, double c) { m.points.push_back({a, b, c}); };
    const double a = 2 + x(random), b = x(random), c = 2 + x(random), d = x(random);
    add(a, 3, b);
    add(c, 2, d);
    for (std::size_t n = 0; n < middle; ++n) add(x(random), 2 * x(random), 1 + x(random));
    add(-c, 2, d);
    add(-a, is_moved ? std::nextafter(3., 4.) : 3, b);
    const auto last = static_cast<std::uint32_t>(m.points.size() - 1);
    for (std::uint32_t n = 1; n < last; ++n) m.triangles.push_back({0, n, n + 1});
    return random_history::walk_on(m);
  }

  Walk walk_;
  IT::Unfolded_diamond diamond_;
};

TEST(Mirrored_proof, proves_trapezoids_over_triangles_that_are_not_symmetric_in_between) {
  std::mt19937 random(2);
  for (std::size_t i = 0; i < 40; ++i) {
    const bool is_moved = i % 3 == 0;
    const Fan fan(1 + i % 7, is_moved, random);
    EXPECT_EQ(fan.has_proof(), !is_moved);
    EXPECT_EQ(fan.in_field(), is_moved ? IT::Answer::not_zero : IT::Answer::zero);
  }
}

// one root for each triangle in the middle, and two
TEST(Field_proof, ends_for_any_number_of_roots) {
  std::mt19937 random(3);
  EXPECT_EQ(Fan(8, false, random).in_field(), IT::Answer::zero); // took hours in coefficients
  for (const std::size_t middle : {20U, 40U, 80U}) {
    EXPECT_EQ(Fan(middle, false, random).in_field(), IT::Answer::open);
    EXPECT_TRUE(Fan(middle, false, random).has_proof());
    if (middle < 60) {
      EXPECT_EQ(Fan(middle, true, random).in_field(), IT::Answer::not_zero);
    }
  }
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
