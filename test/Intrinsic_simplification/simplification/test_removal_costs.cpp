// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "expect_coarse.h"
#include "operator_test_meshes.h"
#include "removal_archetypes.h"

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_simplification/simplification/removal_costs.h>
#include <CGAL/Intrinsic_simplification/simplification/simplify.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <span>
#include <vector>

namespace {

using namespace operator_test;
using T = IT::Corresponding_triangulation;
using Complex = std::complex<double>;

static_assert(IT::RemovalCost<archetypes::Removal_cost>);
static_assert(IT::RemovalCost<archetypes::Remembering_cost>);
static_assert(IT::RemovalCost<IT::Stretch_cost>);
static_assert(IT::RemovalCost<IT::Transported_mass>);
static_assert(IT::RemovalCost<IT::Balanced_cost>);
static_assert(!IT::RemovalCost<double>);

IT::Simplify_options keeping_border(const T& t, std::size_t vertices) {
  IT::Simplify_options options;
  options.vertices = vertices;
  for (const auto h : halfedges(t.mesh()))
    if (CGAL::is_border(h, t.mesh()))
      options.kept_vertices.push_back(t.input_vertex(target(h, t.mesh())));
  return options;
}

TEST(RemovalCost, archetypes_are_enough) {
  const T t = delaunay(rough_torus(6, .3, 1));
  IT::Simplify_options options;
  options.vertices = 20;
  EXPECT_EQ(IT::simplify(t, options, archetypes::Removal_cost(1)).kept.size(), 20U);
  EXPECT_EQ(IT::simplify(t, options, archetypes::Remembering_cost(1)).kept.size(), 20U);
}

TEST(TransportedMass, moves_in_shares_and_remembers_the_way_back) {
  IT::Transported_mass cost;
  cost.add({3, -2, 0}, 2); // channels 6 0 0 and 0 4 0
  const std::vector<IT::Removal_neighbor> of_0{{1, .25, 1, {0, 1}, {1, 0}},
                                               {2, .75, 2, {1, 0}, {0, -2}}};
  EXPECT_DOUBLE_EQ(cost({.number = 0}, of_0), 6 * (.25 * 1 + .75 * 2));
  cost.remove({.number = 0}, of_0);
  // 1 has 1.5 at (1, 0), and 4 of the other channel; it sends all to 2, turned by a quarter
  const std::vector<IT::Removal_neighbor> of_1{{2, 1, 3, {0, 1}, {3, 0}}};
  // 2 has 4.5 at (0, -2) from 0: 1.5 (3, 1) + 4.5 (0, -2) = (4.5, -7.5)
  EXPECT_DOUBLE_EQ(cost({.number = 1}, of_1), std::hypot(4.5, -7.5) + 4 * 3);
  EXPECT_EQ(IT::Transported_mass().add({0, 0})({.number = 1}, of_0), 0);
}

// A tetrahedron has curvature pi and a quarter of the area at each vertex; all edges are alike.
TEST(BalancedCost, grows_with_curvature_area_lengths_and_stretch) {
  const Shape shape = tetrahedron();
  const T t = delaunay(shape);
  const IT::Balanced_cost cost = IT::balanced_cost(t);
  const double length = (shape.point(1) - shape.point(0)).squaredNorm();
  const auto compare = [&](const IT::Removal_candidate& c) {
    EXPECT_NEAR(c.squared_length, length, 1e-12 * length);
    EXPECT_NEAR(c.curvature, std::numbers::pi, 1e-12);
    IT::Removal_candidate same = c;
    same.stretch = 3 * std::numbers::ln2; // its cube root is 2
    EXPECT_NEAR(cost(same), 2 * (1 + .25) * length, 1e-12 * length);
    same.curvature = -4 * std::numbers::ln2;
    EXPECT_NEAR(cost(same), 4 * (4 * std::numbers::ln2 / std::numbers::pi + .25) * length,
                1e-12 * length);
    return cost(c);
  };
  IT::Simplify_options options;
  options.vertices = 4;
  EXPECT_EQ(IT::simplify(t, options, compare).removed, 0U);
}

// Checks neighbours on a plane, where all frames are turned against it by a fixed angle each.
struct Plane_check {
  const Shape& shape;
  std::set<std::uint32_t> corners; // of the plane, where polar angles are scaled
  std::map<std::uint32_t, Complex>& axis;
  std::size_t& checked;

  Complex at(std::uint32_t v) const { return {shape.points[v][0], shape.points[v][1]}; }
  double operator()(const IT::Removal_candidate& c,
                    std::span<const IT::Removal_neighbor> neighbors) const {
    double shares = 0;
    for (const IT::Removal_neighbor& n : neighbors) {
      shares += n.share;
      EXPECT_GE(n.share, 0);
      EXPECT_NEAR(n.length, std::abs(at(c.number) - at(n.number)), 1e-7);
      if (corners.contains(n.number)) continue;
      const Complex axis_there = (at(c.number) - at(n.number)) / n.back;
      const Complex first = axis.emplace(n.number, axis_there).first->second;
      EXPECT_NEAR(std::abs(first - axis_there), 0, 1e-7);
      const auto here = axis.find(c.number);
      if (here == axis.end()) continue;
      EXPECT_NEAR(std::abs(here->second - first * n.turn), 0, 1e-7);
      ++checked;
    }
    EXPECT_NEAR(shares, 1, 1e-12);
    return c.area;
  }
  void remove(const IT::Removal_candidate&, std::span<const IT::Removal_neighbor>) {}
};

TEST(RemovalNeighbor, has_vectors_in_frames_that_stay) {
  const Shape shape = rough_grid(12, .3, 0, 2);
  Shape straight = shape;
  for (std::uint32_t v = 0; v < 169; ++v) // a straight border
    for (const std::size_t c : {0U, 1U}) {
      const auto x = c == 0 ? v % 13 : v / 13;
      if (x == 0 || x == 12) straight.points[v][c] = x;
    }
  const T t = delaunay(straight);
  std::map<std::uint32_t, Complex> axis;
  std::size_t checked = 0;
  const IT::Simplification s = IT::simplify(
      t, keeping_border(t, 50), Plane_check{straight, {0, 12, 156, 168}, axis, checked});
  EXPECT_EQ(s.kept.size(), 50U);
  EXPECT_GT(checked, 1000U);
}

TEST(CurvatureCost, removes_flat_vertices_first) {
  const T t = delaunay(grid(8));
  const IT::Transported_mass cost = IT::curvature_cost(t);
  IT::Simplify_options options;
  options.cost = 1e-9;
  EXPECT_EQ(IT::simplify(t, options, cost).kept.size(), 4U);
}

// Areas times lengths are beyond doubles on the larger ones, and zero on the smaller ones.
TEST(AreaCost, is_the_same_on_surfaces_of_any_size) {
  const Shape shape = rough_torus(8, .3, 2);
  const auto kept = [&](int exponent) {
    Shape scaled = shape;
    for (auto& p : scaled.points)
      for (double& x : p) x = std::ldexp(x, exponent);
    const T t = delaunay(scaled);
    IT::Simplify_options options;
    options.vertices = 20;
    return IT::simplify(t, options, IT::area_cost(t)).kept;
  };
  const std::vector<std::uint32_t> expected = kept(0);
  EXPECT_EQ(expected.size(), 20U);
  for (const int exponent : {-500, -400, 400}) EXPECT_EQ(kept(exponent), expected) << exponent;
}

TEST(AreaCost, leaves_small_faces_before_large_ones) {
  // A grid that is dense on the left: columns at x = 0, .01, ... .05, 1, 2 ... 6.
  Shape shape = grid(12);
  for (auto& p : shape.points) p[0] = p[0] < 6 ? p[0] / 100 : p[0] - 5;
  const T t = delaunay(shape);
  const IT::Simplification s = IT::simplify(t, keeping_border(t, 48 + 60), IT::area_cost(t));
  std::size_t dense = 0;
  for (const std::uint32_t v : s.kept)
    dense += v % 13 > 0 && v % 13 < 6 && v / 13 > 0 && v / 13 < 12;
  EXPECT_EQ(s.kept.size(), 108U);
  EXPECT_LT(dense, 15U); // of 55; others lose none
}

} // namespace
