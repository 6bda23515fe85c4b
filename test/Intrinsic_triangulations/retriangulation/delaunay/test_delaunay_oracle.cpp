// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracle.h"
#include "properties.h"

#include <CGAL/CORE_Expr.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <string>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Exact = IT::Intrinsic_triangulation<>;

struct Named_mesh {
  std::string name;
  meshes::Mesh mesh;
};

// Squared lengths and weights come from intervals with a relative width of about 1e-14 after few
// flips; midpoints are read. 1e-11 leaves room for weights of needles.
constexpr double tolerance = 1e-11;

void expect_same(const meshes::Mesh& mesh, const oracle::Answer& expected) {
  Exact t(mesh.input());
  const auto result = IT::flip_to_delaunay(t);
  EXPECT_EQ(result.status, IT::Status::done);
  const auto report = IT::check_delaunay(t);
  EXPECT_EQ(report.non_delaunay_edges, 0U);
  EXPECT_EQ(report.cocircular_edges.size(), expected.ties);
  EXPECT_EQ(t.metric().statistics().probable_zero, 0U);
  properties::expect_same_tessellation(properties::tessellation(t), expected.tessellation,
                                       tolerance);
  properties::expect_same_laplacian(properties::laplacian(t), expected.laplacian, tolerance);
  EXPECT_NEAR(properties::total_area(t), expected.area, tolerance * expected.area);
}

void expect_oracle_agrees(const Named_mesh& m, std::size_t least_ties) {
  SCOPED_TRACE(m.name);
  const oracle::Answer expected = oracle::delaunay(m.mesh);
  EXPECT_GE(expected.ties, least_ties);
  expect_same(m.mesh, expected);
}

TEST(Delaunay_oracle, agrees_on_boxes_whose_squares_are_ties) {
  // all unit squares: one tie each
  expect_oracle_agrees({"cube", meshes::box(1, 1, 1)}, 6);
  expect_oracle_agrees({"cube with 3 x 3 faces", meshes::box(3, 3, 3)}, 54);
  expect_oracle_agrees({"box", meshes::box(1, 2, 4)}, 28);
}

TEST(Delaunay_oracle, agrees_on_prisms_with_long_walls) {
  expect_oracle_agrees({"wedge", meshes::prism({{0, 0}, {4, 0}, {0, 3}}, 5)}, 15);
  expect_oracle_agrees({"thin wedge", meshes::prism({{0, 0}, {24, 1}, {0, 7}}, 4)}, 1);
  expect_oracle_agrees({"pentagon", meshes::prism({{0, 0}, {5, -1}, {7, 3}, {4, 8}, {-1, 5}}, 3)},
                       1);
  expect_oracle_agrees(
      {"hexagon", meshes::prism({{2, 0}, {4, 1}, {4, 3}, {2, 4}, {0, 3}, {0, 1}}, 2)}, 1);
}

TEST(Delaunay_oracle, agrees_on_a_thick_l) { expect_oracle_agrees({"L", meshes::l_shape(3)}, 10); }

TEST(Delaunay_oracle, agrees_on_stairs) {
  expect_oracle_agrees({"stairs", meshes::stairs(3, 4)}, 24);
  expect_oracle_agrees({"sheared stairs", meshes::stairs(3, 4, 2)}, 1);
  expect_oracle_agrees({"much sheared stairs", meshes::stairs(2, 5, 7)}, 0);
}

TEST(Delaunay_oracle, agrees_on_ties_that_span_several_planes) {
  // whole squares are left of the lattice where the shear is small against its width
  for (const std::uint32_t shear : {0U, 1U, 2U, 3U})
    expect_oracle_agrees(
        {"lattice, shear " + std::to_string(shear), meshes::folded_lattice(4, 6, shear)},
        shear < 3 ? 5 : 0);
}

TEST(Delaunay_oracle, agrees_on_height_fields_of_small_integers) {
  for (unsigned seed = 1; seed <= 12; ++seed)
    expect_oracle_agrees(
        {"heights 0 and 1, seed " + std::to_string(seed), meshes::integer_height_field(5, 2, seed)},
        0);
  for (unsigned seed = 1; seed <= 12; ++seed)
    expect_oracle_agrees(
        {"heights 0 to 4, seed " + std::to_string(seed), meshes::integer_height_field(6, 5, seed)},
        0);
}

TEST(Delaunay_oracle, agrees_on_random_integer_terrains) {
  for (unsigned seed = 1; seed <= 15; ++seed)
    expect_oracle_agrees({"seed " + std::to_string(seed), meshes::integer_terrain(30, 8, seed)}, 0);
}

TEST(Delaunay_oracle, agrees_on_caps_that_flip_away) {
  for (std::size_t f = 0; f < 5; ++f)
    expect_oracle_agrees(
        {"cap at face " + std::to_string(f), meshes::with_cap(meshes::box(2, 1, 1), f)}, 1);
}

TEST(Delaunay_oracle, agrees_in_exact_algebraic_arithmetic_on_tiny_meshes) {
  // every flip nests one square root more, and root bounds of CORE::Expr explode
  for (const meshes::Mesh& m :
       {meshes::box(1, 1, 1), meshes::integer_height_field(1, 9, 3),
        meshes::integer_height_field(2, 2, 5), meshes::prism({{0, 0}, {9, 0}, {0, 2}}, 1),
        meshes::Mesh{{{0, 0, 0}, {7, 1, 0}, {0, 0, 1}, {8, 0, 2}},
                     {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}}})
    expect_same(m, oracle::delaunay<CORE::Expr>(m));
}

} // namespace
