// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Edge_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Session.h>
#include <CGAL/Intrinsic_triangulations/triangulation/measures.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace source_test_Kept_crossings {

namespace IT = CGAL::Intrinsic_triangulations;

template <class Correspondence>
using Exact =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Correspondence>;

/// A grid with some vertices pulled up: input edges that thousands of intrinsic ones will cross.
IT::Intrinsic_input spikes(double height) {
  auto mesh = meshes::grid(9, 9);
  for (const std::size_t v : {22U, 47U, 64U, 75U}) mesh.points[v][2] = height;
  return mesh.input();
}

template <class T>
auto refined(T& t, std::uint64_t maximum) {
  return IT::delaunay_refine(t, IT::parameters::minimum_angle(25).maximum_insertions(maximum))
      .counts;
}

/// Lists that are kept say the same as curves that are followed from face to face.
template <class T>
void expect_crossings_of_curves(const T& t) {
  const IT::Integer_coordinates& c = t.correspondence();
  ASSERT_TRUE(c.knows_crossings());
  const IT::Edge_crossings followed = IT::edge_crossings(t, c);
  for (std::uint32_t e = 0; e < c.number_of_edges(); ++e)
    ASSERT_TRUE(std::ranges::equal(c.entered_on(e), followed.entered_on(e))) << e;
}

TEST(Kept_crossings, are_not_kept_where_curves_are_short) {
  Exact<IT::Integer_coordinates> t(meshes::integer_terrain(60, 200, 3).input());
  EXPECT_GT(refined(t, 100000).inserted_vertices(), 20U);
  EXPECT_FALSE(t.correspondence().knows_crossings());
}

TEST(Kept_crossings, of_spikes_are_those_of_curves_through_all_moves) {
  Exact<IT::Integer_coordinates> t(spikes(1e5));
  const std::size_t input_vertices = num_vertices(t.mesh());
  refined(t, 3000);
  expect_crossings_of_curves(t);
  refined(t, 2000);
  expect_crossings_of_curves(t);
  std::vector<decltype(t)::vertex_descriptor> inserted;
  for (const auto v : CGAL::make_range(vertices(t.mesh())))
    if (t.index(v) >= input_vertices && t.index(v) % 7 == 0) inserted.push_back(v);
  std::size_t removed = 0;
  {
    IT::Move_session session(t);
    for (const auto v : inserted) removed += session.remove_vertex(v) == IT::Move_status::done;
  }
  EXPECT_GT(removed, 100U);
  expect_crossings_of_curves(t);
}

/// A strip below a row of points that is nearly straight, and above the row a fan of slivers from
/// its first point, which are thinner than the strip by millions.
IT::Intrinsic_input slivers(std::uint32_t n) {
  meshes::Mesh mesh;
  const double width = n - 1;
  for (std::uint32_t k = 0; k < n; ++k)
    mesh.points.push_back({double(k), k * (k - width) * 0x1p-40, 0});
  for (std::uint32_t k = 0; k < n; ++k) mesh.points.push_back({double(k), -1, 0});
  mesh.points.push_back({width / 2, width / 2, 0});
  for (std::uint32_t k = 0; k + 1 < n; ++k) {
    mesh.triangles.push_back({n + k, n + k + 1, k + 1});
    mesh.triangles.push_back({n + k, k + 1, k});
    if (k > 0) mesh.triangles.push_back({0, k, k + 1});
  }
  mesh.triangles.push_back({0, n - 1, 2 * n});
  return mesh.input();
}

TEST(Kept_crossings, of_slivers_are_those_of_curves_and_areas_sum_to_that_of_the_plane) {
  const std::uint32_t n = 400;
  Exact<IT::Integer_coordinates> t(slivers(n));
  EXPECT_EQ(IT::delaunay_refine(t, IT::parameters::minimum_angle(20)).status, IT::Status::done);
  expect_crossings_of_curves(t);
  std::size_t across_turns = 0;
  for (std::uint32_t e = 0; e < t.correspondence().number_of_edges(); ++e)
    across_turns += t.correspondence().normal_coordinate(e) > 256 ? 1 : 0;
  EXPECT_GT(across_turns, 100U);
  const double width = n - 1;
  EXPECT_NEAR(IT::total_area(t) / (width + width * width / 4), 1, 1e-12);
}

TEST(Kept_crossings, change_nothing_but_time) {
  // without correspondence and with signposts, coordinates of their own serve
  Exact<IT::Integer_coordinates> t(spikes(1e7));
  Exact<IT::No_correspondence> u(spikes(1e7));
  Exact<IT::Signposts> v(spikes(1e7));
  const auto counts = refined(t, 2500);
  EXPECT_TRUE(t.correspondence().knows_crossings());
  EXPECT_EQ(refined(u, 2500).flips, counts.flips);
  EXPECT_EQ(refined(v, 2500).flips, counts.flips);
  for (const auto e : CGAL::make_range(edges(t.mesh()))) ASSERT_EQ(t.length(e), u.length(e));
}

TEST(Kept_crossings, refinement_of_spikes_ends) {
  // by curves that are followed again and again, minutes
  Exact<IT::Integer_coordinates> t(spikes(1e5));
  const auto result = IT::delaunay_refine(t, IT::parameters::minimum_angle(25));
  EXPECT_EQ(result.status, IT::Status::done);
  EXPECT_GT(result.counts.inserted_vertices(), 10000U);
}

} // namespace source_test_Kept_crossings
