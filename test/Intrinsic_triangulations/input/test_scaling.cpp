// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "refusals.h"

#include <CGAL/Intrinsic_triangulations/input/scaling.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace CGAL::Intrinsic_triangulations;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Scaling, brings_the_mean_edge_near_1_by_a_power_of_two) {
  for (const double factor : {1e-300, 1e-160, 1e-20, 0.3, 1.0, 7.0, 1e20, 1e120, 1e300}) {
    meshes::Mesh m = meshes::scaled(meshes::sphere(2), factor);
    const auto before = m.points;
    const int s = scale_points(m.map(), m.points);
    const auto [a, b, c] = m.triangles[0];
    const double length =
        std::hypot(m.points[a][0] - m.points[b][0], m.points[a][1] - m.points[b][1],
                   m.points[a][2] - m.points[b][2]);
    EXPECT_GT(length, 0.25) << factor;
    EXPECT_LT(length, 8) << factor;
    for (std::size_t v = 0; v < before.size(); ++v)
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(std::ldexp(m.points[v][k], -s), before[v][k]) << factor;
  }
}

TEST(Scaling, looks_at_edges_and_not_at_where_the_mesh_lies) {
  meshes::Mesh m =
      meshes::translated(meshes::scaled(meshes::grid(4, 4), 0x1p-20), {1e8, -1e8, 1e8});
  const int s = scale_points(m.map(), m.points);
  EXPECT_GE(s, 19);
  EXPECT_LE(s, 21);
}

TEST(Scaling, leaves_a_mesh_alone_that_is_one_point) {
  meshes::Mesh m = meshes::grid(1, 1);
  for (auto& p : m.points) p = {0, 0, 0};
  EXPECT_EQ(scale_points(m.map(), m.points), 0);
  for (auto& p : m.points) p = {3, 4, 5};
  EXPECT_EQ(scale_points(m.map(), m.points), 0);
}

TEST(Scaling, names_the_vertex_with_a_coordinate_that_is_not_finite) {
  for (const double bad : {nan, infinity, -infinity}) {
    meshes::Mesh m = meshes::grid(3, 3);
    m.points[7][1] = bad;
    refusals::expect_invalid([&] { scale_points(m.map(), m.points); }, Element_kind::vertex, 7,
                             {"vertex 7"});
  }
}

TEST(Scaling, names_the_vertex_that_cannot_be_scaled_exactly) {
  meshes::Mesh m = meshes::scaled(meshes::grid(3, 3), 1e300);
  m.points[5][2] = 3 * std::numeric_limits<double>::denorm_min();
  refusals::expect_invalid([&] { scale_points(m.map(), m.points); }, Element_kind::vertex, 5);
}

TEST(Scaling, brings_the_largest_squared_length_near_1_by_a_power_of_four) {
  for (const double factor : {1e-300, 1e-20, 0.3, 1.0, 2.0, 5.0, 1e20, 1e300}) {
    std::vector<double> l{factor, factor / 2, factor / 1024};
    const int s = scale_squared_lengths(l);
    EXPECT_GT(l[0], 0.2) << factor;
    EXPECT_LT(l[0], 8) << factor;
    EXPECT_EQ(std::ldexp(l[0], -2 * s), factor);
    EXPECT_EQ(l[0], 1024 * l[2]);
  }
}

TEST(Scaling, names_the_edge_with_a_bad_squared_length) {
  for (const double bad : {nan, infinity, -1.0}) {
    std::vector<double> l{1, 1, bad, 1};
    refusals::expect_invalid([&] { scale_squared_lengths(l); }, Element_kind::edge, 2);
  }
}

} // namespace
