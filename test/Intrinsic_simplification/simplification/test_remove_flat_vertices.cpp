// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_simplification/simplification/remove_flat_vertices.h>
#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>

#include "coarse_meshes.h"
#include "expect_coarse.h"
#include "operator_test_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace {

using namespace operator_test;
using T = IT::Corresponding_triangulation;

TEST(Remove_flat_vertices, leaves_the_corners_of_a_cube) {
  const T fine = delaunay(cube_of_grids(4));
  const IT::Simplification s = IT::remove_flat_vertices(fine);
  EXPECT_EQ(s.kept.size(), 8U);
  EXPECT_EQ(s.status, IT::Status::done);
  EXPECT_NEAR(s.stretch.lower, 1, 1e-12);
  EXPECT_NEAR(s.stretch.upper, 1, 1e-12);
  expect_surface(fine, s);
  expect_distances_within(fine, s);
}

TEST(Remove_flat_vertices, goes_along_a_straight_border_and_asks_for_exact_angles) {
  Shape shape = grid(6);
  EXPECT_EQ(IT::remove_flat_vertices(delaunay(shape)).kept.size(), 4U);
  // A hill of 1e-7: its curvature is below 1e-12, and not zero.
  shape.points[24][2] = 1e-7;
  const T hill = delaunay(shape);
  const IT::Simplification exact = IT::remove_flat_vertices(hill);
  EXPECT_GT(exact.kept.size(), 4U);
  EXPECT_EQ(std::ranges::count(exact.kept, 24U), 1);
  EXPECT_EQ(IT::remove_flat_vertices(hill, 1e-6).kept.size(), 4U);
  for (const double within : {-1., HUGE_VAL, std::nan("")})
    EXPECT_THROW(IT::remove_flat_vertices(hill, within), IT::Invalid_input) << within;
}

// A vertex with spokes of given squared lengths, and between them given squared lengths of the rim.
IT::Intrinsic_input star_of(const std::vector<double>& spokes, const std::vector<double>& rim) {
  const auto n = static_cast<std::uint32_t>(spokes.size());
  Shape s;
  s.points.resize(n + 1);
  for (std::uint32_t k = 0; k < n; ++k) s.triangles.push_back({n, k, (k + 1) % n});
  const IT::Gluing_map map = s.gluing_map();
  std::vector<double> lengths;
  for (const auto e : edges(map)) {
    std::uint32_t a = source(halfedge(e, map), map).index, b = target(halfedge(e, map), map).index;
    if (a > b) std::swap(a, b);
    lengths.push_back(b == n ? spokes[a] : rim[b == a + 1 ? a : b]);
  }
  return {map, lengths};
}

// Whether the last vertex goes if only flat ones may.
bool is_flat(const IT::Intrinsic_input& input) {
  const T t = delaunay(input);
  IT::Simplify_options options;
  for (std::uint32_t v = 0; v + 1 < t.number_of_vertices(); ++v) options.kept_vertices.push_back(v);
  const IT::Simplification s = IT::remove_flat_vertices(t, 0, options);
  EXPECT_EQ(s.not_flattened + s.blocked_by_border, 0U);
  return s.removed == 1;
}

// Angles of many planes and fields: a quarter turn and an eighth are all that a rational angle in a
// field of one root can be, and all else needs its class to close.
TEST(Remove_flat_vertices, decides_stars_whose_angles_are_of_several_fields) {
  // right angles of the classes 2, 6, 15 and 5
  std::vector<double> spokes{1, 2, 3, 5}, rim{3, 5, 8, 6};
  EXPECT_TRUE(is_flat(star_of(spokes, rim)));
  for (double& side : rim) { // a near miss
    const double before = std::exchange(side, std::nextafter(side, 9));
    EXPECT_FALSE(is_flat(star_of(spokes, rim)));
    side = before;
  }
  // eight angles of pi / 4; and two of them with three right angles
  EXPECT_TRUE(is_flat(star_of({1, 2, 1, 2, 1, 2, 1, 2}, {1, 1, 1, 1, 1, 1, 1, 1})));
  EXPECT_TRUE(is_flat(star_of({1, 2, 1, 3, 7}, {1, 1, 4, 10, 8})));
  // six angles of pi / 3: one class, no multiple of pi / 2 each
  EXPECT_TRUE(is_flat(star_of({1, 1, 1, 1, 1, 1}, {1, 1, 1, 1, 1, 1})));
  // 2 pi / 3 and pi / 3 in the class 3, and two right angles in class 1
  EXPECT_TRUE(is_flat(star_of({1, 1, 1, 4}, {3, 1, 5, 5})));
  // right angles, and two of one class that differ from them by the same; and not by the same
  EXPECT_TRUE(is_flat(star_of({1, 1, 1, 1}, {2, 2, 2 + 0x1p-50, 2 - 0x1p-50})));
  EXPECT_FALSE(is_flat(star_of({1, 1, 1, 1}, {2, 2, 2 + 0x1p-50, 2 - 0x1p-51})));
}

// A fan with its centre at the origin, around in the plane of two vectors.
Shape fan(int n, const std::array<double, 3>& u, const std::array<double, 3>& v) {
  Shape s;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * 3.14159265358979 * k / n;
    const double x = std::round(1e6 * std::cos(angle)), y = std::round(9e5 * std::sin(angle));
    s.points.push_back({x * u[0] + y * v[0], x * u[1] + y * v[1], x * u[2] + y * v[2]});
  }
  s.points.push_back({0, 0, 0});
  for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(n); ++k)
    s.triangles.push_back(
        {k, (k + 1) % static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(n)});
  return s;
}

TEST(Remove_flat_vertices, decides_large_fans) {
  for (const int n : {130, 1000}) {
    Shape shape = fan(n, {1, 2, 3}, {-2, 1, 5}); // the plane has irrational areas
    EXPECT_TRUE(is_flat(shape.input()));
    shape.points[17][0] += 0x1p-20; // out of the plane: the angle grows by 1e-25
    EXPECT_FALSE(is_flat(shape.input()));
  }
}

TEST(Remove_flat_vertices, reads_the_input_whatever_was_done_to_the_triangulation) {
  const Shape shape = cube_of_grids(3);
  const IT::Intrinsic_triangulation<> plain(shape.input());
  EXPECT_EQ(IT::remove_flat_vertices(plain).kept.size(), 8U);
  const IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>> rounded(
      shape.input());
  EXPECT_EQ(IT::remove_flat_vertices(rounded).kept.size(), 8U);
  T refined = delaunay(shape);
  const auto f = *faces(refined.mesh()).begin();
  ASSERT_EQ(refined.insert_vertex(halfedge(f, refined.mesh()), {.3, .3, .4}).status,
            IT::Move_status::done);
  EXPECT_EQ(IT::remove_flat_vertices(refined).kept.size(), 8U);
  // lengths alone, without correspondence: nobody knows the faces of the input any more
  const IT::Intrinsic_triangulation<> lengths(star_of({1, 1, 1}, {3, 3, 3}));
  EXPECT_THROW(IT::remove_flat_vertices(lengths), IT::Invalid_input);
}

} // namespace
