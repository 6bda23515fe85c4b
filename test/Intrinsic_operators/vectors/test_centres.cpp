// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/vectors/centres.h>

#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include "Following.h"
#include "delaunay.h"
#include "meshes.h"
#include "operator_test_meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

// Centres of points and of cells.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                          IT::Integer_coordinates>;
using Heat = IT::Vector_heat_method<Exact>;
using Weighted_points = std::vector<std::pair<IT::Surface_point, double>>;

std::array<double, 3> place_of(const Exact& t, const IT::Surface_point& p, const meshes::Mesh& m) {
  return IT::point_in_space(t, *IT::locate_on_input(t, p), m.points);
}

IT::Surface_point at_vertex(const Exact& t, std::uint32_t v) {
  const IT::Intrinsic_view<Exact> view(t);
  std::uint32_t h = view.outgoing_halfedge(v);
  if (view.is_border(h)) return {h ^ 1U, {0, 1, 0}};
  return {h, {1, 0, 0}};
}

TEST(Karcher_mean, in_a_convex_part_of_the_plane_is_the_weighted_mean) {
  const meshes::Mesh shape = meshes::scaled(meshes::random_planar(60, 1000, 2), 0.01);
  Exact t = delaunay<Exact>(shape.input());
  const Heat heat(t);
  for (std::uint32_t i = 0; i < 30; i += 7) {
    Weighted_points points{{at_vertex(t, i), 1}, {at_vertex(t, 59 - i), 2}};
    for (const std::uint32_t f : {10U, 50U})
      points.push_back(
          {{t.numbers().halfedge(halfedge(t.numbers().face_at(f), t.mesh())), {0.2, 0.3, 0.5}},
           0.5 + f});
    std::array<double, 2> expected{0, 0};
    double all = 0;
    for (const auto& [p, w] : points) {
      const auto x = place_of(t, p, shape);
      for (std::size_t c = 0; c < 2; ++c) expected[c] += w * x[c];
      all += w;
    }
    const IT::Karcher_mean mean = IT::karcher_mean(heat, points);
    EXPECT_EQ(mean.status, IT::Status::done);
    const auto x = place_of(t, mean.point, shape);
    for (std::size_t c = 0; c < 2; ++c) EXPECT_NEAR(x[c], expected[c] / all, 1e-3);
    EXPECT_LE(mean.steps, 5U);
  }
}

TEST(Karcher_mean, of_one_point_is_that_point_and_of_an_octant_of_the_sphere_its_centre) {
  const meshes::Mesh shape = meshes::sphere(4);
  Exact t = delaunay<Exact>(shape.input());
  const Heat heat(t);
  const auto one = place_of(t, IT::karcher_mean(heat, {{at_vertex(t, 9), 3}}).point, shape);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(one[c], shape.points[9][c], 1e-3);
  Weighted_points corners;
  for (std::uint32_t i = 0; i < shape.points.size(); ++i) // the points of the octahedron
    for (std::size_t c = 0; c < 3; ++c)
      if (shape.points[i][c] > 1 - 1e-9) corners.push_back({at_vertex(t, i), 1});
  ASSERT_EQ(corners.size(), 3U);
  const IT::Karcher_mean mean = IT::karcher_mean(heat, corners);
  for (const double x : place_of(t, mean.point, shape)) EXPECT_NEAR(x, std::sqrt(1. / 3), 0.02);
}

TEST(Karcher_mean, refuses_what_has_no_centre) {
  Exact t(meshes::box(1, 1, 1).input());
  const Heat heat(t);
  EXPECT_THROW(IT::karcher_mean(heat, {}), std::invalid_argument);
  for (const double weight : {0., -1., std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(IT::karcher_mean(heat, {{at_vertex(t, 0), weight}}), std::invalid_argument);
}

TEST(Karcher_mean, refuses_points_of_different_components) {
  constexpr std::uint32_t n = 8;
  const Exact t(operator_test::beside(operator_test::cube(), operator_test::cube(), 5).input());
  const Heat heat(t);
  const IT::Surface_point here = at_vertex(t, 0), there = at_vertex(t, n);
  EXPECT_THROW(IT::karcher_mean(heat, {{here, 1}, {there, 1}}), std::invalid_argument);
  EXPECT_THROW(IT::karcher_mean(heat, {{here, 1}, {there, 2}}), std::invalid_argument);
  EXPECT_NO_THROW(IT::karcher_mean(heat, {{here, 1}, {there, 0}}));
  const IT::Voronoi_centres centres =
      IT::voronoi_centres(heat, {here}, IT::parameters::maximum_rounds(0));
  for (std::uint32_t i = 0; i < 2 * n; ++i)
    EXPECT_EQ(centres.cell[i], i < n ? 0U : IT::Gluing::none) << i;
}

TEST(Voronoi_centres, have_cells_that_are_many_hundred_edges_long) {
  const std::uint32_t length = 4000, row = length + 1;
  Exact t(meshes::grid(length, 2).input());
  const IT::Voronoi_centres centres =
      IT::voronoi_centres(Heat(t), {at_vertex(t, row + 2), at_vertex(t, 2 * row - 3)},
                          IT::parameters::maximum_rounds(0));
  for (std::uint32_t i = 0; i < 3 * row; ++i) {
    const std::uint32_t x = i % row;
    if (x < 1999 || x > 2001) {
      EXPECT_EQ(centres.cell[i], x < 2000 ? 0U : 1U) << i;
    }
  }
}

TEST(Voronoi_centres, in_the_plane_are_the_centroids_of_their_cells) {
  const meshes::Mesh shape = meshes::grid(16, 16);
  Exact t(shape.input());
  const Heat heat(t);
  std::vector<IT::Surface_point> sites;
  for (const std::uint32_t v : {0U, 20U, 60U, 100U}) sites.push_back(at_vertex(t, v));
  const IT::Voronoi_centres centres =
      IT::voronoi_centres(heat, sites, IT::parameters::maximum_rounds(60).tolerance(1e-6));
  const Eigen::VectorXd mass = IT::lumped_mass_matrix(t).diagonal();
  std::array<double, 4> area{};
  std::array<std::array<double, 2>, 4> sum{};
  for (std::uint32_t i = 0; i < shape.points.size(); ++i) {
    const std::uint32_t s = centres.cell[i];
    ASSERT_LT(s, 4U);
    area[s] += mass[i];
    for (std::size_t c = 0; c < 2; ++c) sum[s][c] += mass[i] * shape.points[i][c];
  }
  for (std::size_t s = 0; s < 4; ++s) {
    const auto x = place_of(t, centres.sites[s], shape);
    for (std::size_t c = 0; c < 2; ++c) EXPECT_NEAR(x[c], sum[s][c] / area[s], 0.02);
    EXPECT_GT(area[s], 0.6 * 64); // they started in a corner
    EXPECT_LT(area[s], 1.5 * 64);
  }
}

TEST(Voronoi_centres, spread_over_the_sphere) {
  const meshes::Mesh shape = meshes::potato(3, 5);
  Exact t = delaunay<Exact>(shape.input());
  const Heat heat(t);
  std::vector<IT::Surface_point> sites;
  for (std::uint32_t v = 0; v < 8; ++v) sites.push_back(at_vertex(t, v));
  const IT::Voronoi_centres centres =
      IT::voronoi_centres(heat, sites, IT::parameters::maximum_rounds(30));
  std::vector<double> area(8, 0);
  const Eigen::VectorXd mass = IT::lumped_mass_matrix(t).diagonal();
  for (std::size_t i = 0; i < centres.cell.size(); ++i)
    area.at(centres.cell[i]) += mass[static_cast<Eigen::Index>(i)];
  for (const double a : area) EXPECT_GT(a, mass.sum() / 8 / 2.5);
  EXPECT_THROW(IT::voronoi_centres(heat, {}), std::invalid_argument);
}

TEST(Centres, stop_when_they_are_told_to) {
  const Exact t(meshes::grid(8, 8).input());
  const Heat heat(t);
  const Weighted_points points{{at_vertex(t, 0), 1}, {at_vertex(t, 8), 1}, {at_vertex(t, 40), 1}};
  std::size_t calls = 0;
  const Following twice{[&calls](const auto&) { return ++calls < 3; }};
  const IT::Karcher_mean mean =
      IT::karcher_mean(heat, points, IT::parameters::tolerance(1e-300).visitor(twice));
  EXPECT_EQ(mean.status, IT::Status::cancelled);
  EXPECT_EQ(calls, 3U);
  calls = 0;
  const std::vector<IT::Surface_point> sites{points[0].first, points[1].first};
  const IT::Voronoi_centres stopped =
      IT::voronoi_centres(heat, sites, IT::parameters::tolerance(0).visitor(twice));
  EXPECT_EQ(stopped.status, IT::Status::cancelled);
  EXPECT_EQ(stopped.steps, 2U);
  EXPECT_EQ(stopped.cell.size(), 81U);
  const auto in_two_steps = [&](double tolerance) {
    return IT::voronoi_centres(heat, sites, IT::parameters::maximum_rounds(2).tolerance(tolerance));
  };
  EXPECT_EQ(in_two_steps(0).status, IT::Status::cap);
  EXPECT_EQ(in_two_steps(1e9).status, IT::Status::done);
  EXPECT_EQ(in_two_steps(1e9).steps, 1U);
}

} // namespace
