// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/input/renumbering.h>

#include "gallery.h"
#include "validity.h"

#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Points = std::vector<std::array<double, 3>>;

Points random_points(std::uint32_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Points points(n);
  for (std::array<double, 3>& p : points) p = {unit(random), unit(random), unit(random)};
  return points;
}

bool is_permutation_of_numbers(std::vector<std::uint32_t> v, std::uint32_t n) {
  std::sort(v.begin(), v.end());
  std::vector<std::uint32_t> expected(n);
  std::iota(expected.begin(), expected.end(), 0U);
  return v == expected;
}

} // namespace

TEST(Renumbering, keeps_the_complex_and_leads_back_to_the_numbers_before) {
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    const IT::Gluing_map before(s.gluing);
    IT::Gluing_map m = before;
    const Points old_points = random_points(m.number_of_vertices(), 3);
    Points points = old_points;
    const IT::Input_names back = IT::renumber(m, points);
    ASSERT_TRUE(is_permutation_of_numbers(back.faces.users(), before.number_of_faces()));
    ASSERT_TRUE(is_permutation_of_numbers(back.vertices.users(), before.number_of_vertices()));
    for (std::uint32_t e = 0; e < m.number_of_edges(); ++e) {
      EXPECT_EQ(back.edges.here(back.edges.user(e)), e);
      std::set<std::uint32_t> ends, old_ends;
      for (std::uint32_t h = 2 * e; h < 2 * e + 2; ++h) {
        ends.insert(back.vertices.user(m.source(IT::Gluing_map::Halfedge{h}).index));
        old_ends.insert(
            before.source(IT::Gluing_map::Halfedge{2 * back.edges.user(e) + h % 2}).index);
      }
      EXPECT_EQ(ends, old_ends);
    }
    for (std::uint32_t f = 0; f < m.number_of_faces(); ++f)
      EXPECT_EQ(back.faces.here(back.faces.user(f)), f);
    EXPECT_EQ(IT::delta_complex_defect(m).value_or("none"), "none");
    for (std::uint32_t v = 0; v < points.size(); ++v)
      EXPECT_EQ(points[v], old_points[back.vertices.user(v)]);
    const IT::Gluing a = IT::gluing_from_map(before), b = IT::gluing_from_map(m);
    const auto old = [&](std::uint32_t h) { return 3 * back.faces.user(h / 3) + h % 3; };
    for (std::uint32_t h = 0; h < b.origin.size(); ++h) {
      EXPECT_EQ(back.vertices.user(b.origin[h]), a.origin[old(h)]);
      EXPECT_EQ(b.glue[h] == IT::Gluing::none ? IT::Gluing::none : old(b.glue[h]), a.glue[old(h)]);
    }
  }
}

TEST(Renumbering, isolated_vertices_stay_isolated) {
  IT::Gluing_map m(gallery::two_fans_and_an_isolated_vertex().gluing);
  Points points = gallery::two_fans_and_an_isolated_vertex().points;
  const IT::Input_names back = IT::renumber(m, points);
  for (std::uint32_t v = 0; v < m.number_of_vertices(); ++v)
    EXPECT_EQ(m.halfedge(IT::Gluing_map::Vertex{v}).index == IT::Gluing::none,
              back.vertices.user(v) == 4);
}

TEST(Renumbering, small_meshes_are_never_badly_ordered) {
  EXPECT_FALSE(IT::is_badly_ordered(IT::Gluing_map(gallery::flat_torus(40, 30).gluing)));
  EXPECT_FALSE(IT::is_badly_ordered(IT::Gluing_map()));
}

TEST(Renumbering, large_mesh_ordered_along_random_points_is_bad_and_along_its_own_good) {
  const std::uint32_t n = 300; // 180000 faces, more than 2^17
  IT::Gluing_map m(gallery::flat_torus(n, n).gluing);
  EXPECT_FALSE(IT::is_badly_ordered(m));
  Points grid(m.number_of_vertices()); // that of the lower left corner of each cell
  for (std::uint32_t cell = 0; cell < n * n; ++cell)
    grid[m.source(m.halfedge(IT::Gluing_map::Face{2 * cell})).index] = {
        static_cast<double>(cell % n), static_cast<double>(cell / n), 0};
  Points noise = random_points(m.number_of_vertices(), 11);
  const IT::Input_names back = IT::renumber(m, noise);
  EXPECT_TRUE(IT::is_badly_ordered(m));
  Points points;
  for (const std::uint32_t v : back.vertices.users()) points.push_back(grid[v]);
  IT::renumber(m, points);
  EXPECT_FALSE(IT::is_badly_ordered(m));
  EXPECT_TRUE(IT::is_valid_delta_complex(m));
}

TEST(Renumbering, long_rows_of_a_grid_are_well_ordered) {
  // rows of 9000 faces: all edges between them join faces that are far apart
  EXPECT_FALSE(IT::is_badly_ordered(IT::Gluing_map(gallery::flat_torus(4500, 15).gluing)));
}

TEST(Renumbering, curve_survives_coordinates_near_the_limits_of_double) {
  for (const double scale : {1e300, 1.7e308, 1e-300, 0.0}) {
    Points points = gallery::disc_fan(12).points;
    for (std::array<double, 3>& p : points)
      for (double& x : p) x *= scale;
    EXPECT_TRUE(is_permutation_of_numbers(IT::morton_order(points), 13));
  }
}
