// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "properties.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/input/mollification.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/is_delaunay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Mollification;

namespace {

using Exact = IT::Intrinsic_triangulation<>;
using Double = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>;

// Two caps whose longest side is the same edge, inside a square: following longest sides goes in
// circles.
meshes::Mesh facing_caps() {
  return {{{-2, 0, 0}, {2, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, -2, 0}},
          {{0, 1, 2}, {1, 0, 3}, {0, 2, 4}, {2, 1, 4}, {1, 3, 5}, {3, 0, 5}}};
}

meshes::Mesh cap_on_the_border() {
  return {{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}}};
}

// a chain of caps, each behind the longest side of the one before, and a proper face at its end
meshes::Mesh chain_of_caps() {
  return {{{0, 0, 0}, {8, 0, 0}, {4, 0, 0}, {2, 0, 0}, {5, 5, 0}, {3, -3, 0}},
          {{0, 1, 4}, {1, 0, 2}, {2, 0, 3}, {0, 5, 3}, {3, 5, 2}, {2, 5, 1}}};
}

template <class T>
bool needs_mollification(const meshes::Mesh& m) {
  const T t(m.input());
  return IT::has_irremovable_degeneracy(m.map(), t.metric());
}

TEST(Mollification, is_needed_where_flips_cannot_remove_degenerate_faces) {
  EXPECT_TRUE(needs_mollification<Exact>(facing_caps()));
  EXPECT_TRUE(needs_mollification<Exact>(cap_on_the_border()));
  EXPECT_TRUE(needs_mollification<Exact>(meshes::with_needle(meshes::box(1, 1, 1), 2, 0)));
  EXPECT_FALSE(needs_mollification<Exact>(chain_of_caps()));
  EXPECT_FALSE(needs_mollification<Exact>(meshes::with_cap(meshes::box(1, 1, 1), 2)));
  EXPECT_FALSE(needs_mollification<Exact>(meshes::with_needle(meshes::potato(1, 1), 2, 1e-15)));
  EXPECT_TRUE(needs_mollification<Double>(facing_caps()));
  EXPECT_FALSE(needs_mollification<Double>(chain_of_caps()));
}

TEST(Mollification, automatic_leaves_caps_to_flips) {
  Exact t(chain_of_caps().input(Mollification::automatic));
  EXPECT_EQ(t.report().degenerate_faces, 2U);
  EXPECT_EQ(t.report().mollification.kind, Mollification::none);
  EXPECT_EQ(t.report().mollification.delta, 0);
  IT::flip_to_delaunay(t);
  EXPECT_TRUE(IT::is_delaunay(t));
  for (const auto f : faces(t.mesh())) EXPECT_GT(t.area(f), 0);
  EXPECT_NEAR(properties::total_area(t), 20 + 12, 1e-12);
}

TEST(Mollification, automatic_acts_where_it_must_and_reports_what_it_added) {
  for (const meshes::Mesh& shape :
       {facing_caps(), cap_on_the_border(), meshes::with_needle(meshes::box(1, 1, 1), 2, 0)})
    for (const double unit : {1.0, 0x1p40, 0x1p-500}) {
      const meshes::Mesh m = meshes::scaled(shape, unit);
      Exact t(m.input(Mollification::automatic));
      EXPECT_GT(t.report().degenerate_faces, 0U);
      EXPECT_EQ(t.report().mollification.kind, Mollification::squared_lengths);
      const double delta = t.report().mollification.delta;
      EXPECT_GT(delta, 0);
      // 2^-72 in units in which edges are about 1
      EXPECT_LT(delta, 0x1p-64 * unit * unit);
      double shortest = t.squared_length(*edges(t.mesh()).begin());
      for (const auto e : edges(t.mesh())) shortest = std::min(shortest, t.squared_length(e));
      EXPECT_GE(shortest, delta);
      IT::flip_to_delaunay(t);
      EXPECT_TRUE(IT::is_delaunay(t));
      for (const auto f : faces(t.mesh())) EXPECT_GT(t.area(f), 0);
      for (const auto& [ij, w] : properties::laplacian(t)) EXPECT_TRUE(std::isfinite(w));
    }
}

TEST(Mollification, none_leaves_degenerate_faces_and_says_how_many) {
  for (const meshes::Mesh& m : {facing_caps(), cap_on_the_border()}) {
    Exact t(m.input(Mollification::none));
    EXPECT_EQ(t.report().mollification.kind, Mollification::none);
    std::size_t degenerate = 0;
    for (const auto f : faces(t.mesh())) degenerate += t.area(f) == 0;
    EXPECT_EQ(degenerate, t.report().degenerate_faces);
    EXPECT_GT(degenerate, 0U);
  }
}

TEST(Mollification, automatic_leaves_proper_meshes_alone) {
  for (const meshes::Mesh& m :
       {meshes::box(2, 2, 2), meshes::potato(2, 2), meshes::parabola_fan(20)}) {
    Exact t(m.input(Mollification::automatic));
    EXPECT_EQ(t.report().degenerate_faces, 0U);
    EXPECT_EQ(t.report().mollification.kind, Mollification::none);
  }
}

template <class T>
void expect_all_faces_proper(Mollification kind) {
  for (const meshes::Mesh& m : {facing_caps(), cap_on_the_border(), chain_of_caps(),
                                meshes::with_needle(meshes::box(1, 1, 1), 2, 0)}) {
    T t(m.input(kind));
    EXPECT_EQ(t.report().mollification.kind, kind);
    EXPECT_GT(t.report().mollification.delta, 0);
    for (const auto f : faces(t.mesh())) EXPECT_GT(t.area(f), 0);
    IT::flip_to_delaunay(t);
    EXPECT_TRUE(IT::is_delaunay(t));
  }
}

TEST(Mollification, both_kinds_give_all_faces_an_area_in_both_arithmetics) {
  expect_all_faces_proper<Exact>(Mollification::squared_lengths);
  expect_all_faces_proper<Exact>(Mollification::lengths);
  expect_all_faces_proper<Double>(Mollification::squared_lengths);
  expect_all_faces_proper<Double>(Mollification::lengths);
}

TEST(Mollification, epsilon_is_the_least_that_gives_every_inequality_the_margin) {
  const IT::Gluing_map map = cap_on_the_border().map();
  std::vector<double> lengths(map.number_of_edges());
  for (std::uint32_t e = 0; e < lengths.size(); ++e) {
    const auto p = cap_on_the_border().points[map.source({2 * e}).index];
    const auto q = cap_on_the_border().points[map.target({2 * e}).index];
    lengths[e] = std::hypot(p[0] - q[0], p[1] - q[1]);
  }
  for (const double delta : {1e-3, 0.25, 1.0}) {
    const double epsilon = IT::mollifying_epsilon(map, lengths, delta);
    double least_margin = 1e300;
    for (std::uint32_t f = 0; f < map.number_of_faces(); ++f) {
      auto h = map.halfedge(IT::Gluing_map::Face{f});
      for (int k = 0; k < 3; ++k, h = map.next(h)) {
        const auto l = [&](auto x) { return lengths[x.index / 2] + epsilon; };
        const auto n = map.next(h), p = map.next(n);
        least_margin = std::min(least_margin, l(h) + l(n) - l(p));
      }
    }
    EXPECT_NEAR(least_margin, delta, 1e-14);
  }
  EXPECT_EQ(IT::mollifying_epsilon(map, std::vector<double>(lengths.size(), 1.0), 0.5), 0);
}

} // namespace
