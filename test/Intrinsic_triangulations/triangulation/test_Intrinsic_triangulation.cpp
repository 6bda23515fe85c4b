// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gallery.h"
#include "meshes.h"
#include "properties.h"

#include <CGAL/Intrinsic_triangulation.h>

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Exact = IT::Intrinsic_triangulation<>;
using Double = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>;
using IT::Move_status;

template <class T>
class Intrinsic_triangulation : public ::testing::Test {};
using Arithmetics = ::testing::Types<Exact, Double>;
TYPED_TEST_SUITE(Intrinsic_triangulation, Arithmetics);

std::vector<IT::Intrinsic_input> inputs() {
  std::vector<IT::Intrinsic_input> all;
  for (const gallery::Surface& s : gallery::oriented()) all.push_back(gallery::input(s));
  for (const meshes::Mesh& m :
       {meshes::box(1, 2, 1), meshes::rough_grid(4, 3), meshes::potato(2, 4), meshes::l_shape(2)})
    all.push_back(m.input());
  return all;
}

TYPED_TEST(Intrinsic_triangulation,
           four_flips_of_an_edge_are_the_identity_and_two_swap_its_halfedges) {
  for (const IT::Intrinsic_input& in : inputs()) {
    TypeParam t(in);
    const auto before = properties::connectivity(t);
    for (const auto h : properties::flippable_by_connectivity(t)) {
      if (t.flip_edge(h) != Move_status::done) continue;
      EXPECT_NE(properties::connectivity(t), before);
      ASSERT_EQ(t.flip_edge(h), Move_status::done);
      // h has the other direction, but the same number and that of the face on its left
      const auto o = opposite(h, t.mesh());
      auto swapped = before;
      const auto f = before[h.index][2], g = before[o.index][2];
      std::swap(swapped[h.index], swapped[o.index]);
      for (auto& [next, target, face] : swapped) {
        if (next / 2 == h.index / 2) next ^= 1U;
        if (face == f || face == g) face = f + g - face;
      }
      EXPECT_EQ(properties::connectivity(t), swapped);
      ASSERT_EQ(t.flip_edge(h), Move_status::done);
      ASSERT_EQ(t.flip_edge(h), Move_status::done);
      EXPECT_EQ(properties::connectivity(t), before);
    }
  }
}

TYPED_TEST(Intrinsic_triangulation, flips_conserve_area_cone_angles_and_euler_characteristic) {
  std::mt19937 random(20260711);
  for (const IT::Intrinsic_input& in : inputs()) {
    TypeParam t(in);
    const double area = properties::total_area(t);
    const auto angles = properties::cone_angles(t);
    const auto chi = properties::euler_characteristic(t);
    const auto edges = properties::flippable_by_connectivity(t);
    for (std::size_t i = 0; !edges.empty() && i < 12; ++i)
      t.flip_edge(edges[random() % edges.size()]);
    // a dozen flips multiply lengths by at most 2 each; errors are far below
    EXPECT_NEAR(properties::total_area(t), area, 1e-10 * area);
    const auto after = properties::cone_angles(t);
    for (std::size_t v = 0; v < angles.size(); ++v) EXPECT_NEAR(after[v], angles[v], 1e-9);
    EXPECT_EQ(properties::euler_characteristic(t), chi);
  }
}

TYPED_TEST(Intrinsic_triangulation, a_refused_flip_leaves_the_state_untouched) {
  int borders = 0, same_faces = 0, not_convex = 0;
  for (const IT::Intrinsic_input& in : inputs()) {
    TypeParam t(in);
    const auto connectivity = properties::connectivity(t);
    const auto values = properties::values(t);
    for (const auto e : edges(t.mesh())) {
      const auto h = halfedge(e, t.mesh());
      const Move_status s = t.flip_status(h);
      if (s == Move_status::done) continue;
      EXPECT_EQ(t.flip_edge(h), s);
      EXPECT_EQ(t.flip_edge(opposite(h, t.mesh())), s);
      borders += s == Move_status::border;
      same_faces += s == Move_status::same_face;
      not_convex += s == Move_status::not_convex;
      EXPECT_EQ(properties::connectivity(t), connectivity);
    }
    // exact predicates may sharpen the intervals of which these are the middle
    const auto after = properties::values(t);
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_NEAR(after[i], values[i], 1e-14 * values[i]);
  }
  EXPECT_GT(borders, 0);
  EXPECT_GT(same_faces, 0);
  EXPECT_GT(not_convex, 0);
}

TYPED_TEST(Intrinsic_triangulation, an_edge_whose_diamond_has_a_straight_angle_cannot_be_flipped) {
  // vertex 1 in the middle of the segment from 2 to 3
  TypeParam t(
      meshes::Mesh{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {4, -4, 0}}, {{0, 1, 2}, {1, 0, 3}}}.input());
  const auto inner = properties::flippable_by_connectivity(t);
  ASSERT_EQ(inner.size(), 1U);
  EXPECT_EQ(t.flip_edge(inner[0]), Move_status::not_convex);
  EXPECT_EQ(t.delaunay_sign(inner[0]), CGAL::POSITIVE);
}

TYPED_TEST(Intrinsic_triangulation, the_diagonal_of_a_square_is_delaunay_and_a_tie_and_flips) {
  TypeParam t(meshes::grid(1, 1).input());
  const auto h = properties::flippable_by_connectivity(t).at(0);
  EXPECT_TRUE(t.is_locally_delaunay(h));
  EXPECT_EQ(t.delaunay_sign(h), CGAL::ZERO);
  EXPECT_EQ(t.flip_edge(h), Move_status::done);
  EXPECT_EQ(t.delaunay_sign(h), CGAL::ZERO);
  EXPECT_EQ(t.squared_length(edge(h, t.mesh())), 2);
}

TYPED_TEST(Intrinsic_triangulation, reports_lengths_and_areas_in_the_units_of_the_input) {
  for (const double unit : {1.0, 0x1p300, 0x1p-300}) {
    TypeParam t(meshes::scaled(meshes::grid(3, 2, 3, 4), unit).input());
    EXPECT_EQ(properties::total_area(t), 72 * unit * unit);
    for (const auto e : edges(t.mesh())) {
      const double l = t.squared_length(e) / unit / unit;
      EXPECT_TRUE(l == 9 || l == 16 || l == 25) << l;
    }
  }
}

} // namespace
