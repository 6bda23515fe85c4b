// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>

#include "meshes.h"

#include <CGAL/Intrinsic_triangulation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

template <class T>
class Measure_quality : public testing::Test {};
using Triangulations =
    testing::Types<IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits>,
                   IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>>;
TYPED_TEST_SUITE(Measure_quality, Triangulations);

// relative error of a few operations
constexpr double eps = 1e-14;

TYPED_TEST(Measure_quality, of_an_octahedron_is_that_of_equilateral_triangles) {
  TypeParam t(meshes::sphere(0).input());
  const IT::Quality q = IT::measure_quality(t);
  EXPECT_NEAR(q.minimum_angle, 60, 60 * eps);
  EXPECT_NEAR(q.maximum_angle, 60, 60 * eps);
  EXPECT_EQ(q.angles[5] + q.angles[6], 24U); // on the limit between both
  EXPECT_NEAR(q.maximum_aspect_ratio, 1, eps);
  EXPECT_NEAR(q.mean_aspect_ratio, 1, eps);
  EXPECT_NEAR(q.minimum_weight, 1 / std::sqrt(3.0), eps);
  EXPECT_NEAR(q.maximum_weight, 1 / std::sqrt(3.0), eps);
  EXPECT_EQ(q.weights[3], 12U);
}

TYPED_TEST(Measure_quality, does_not_count_faces_that_are_gone) {
  const double h = std::sqrt(3.0) / 2;
  TypeParam t(meshes::Mesh{{{{0, 0, 0}}, {{1, 0, 0}}, {{.5, h, 0}}}, {{{0, 1, 2}}}}.input());
  const auto v = t.insert_vertex(halfedge(*faces(t.mesh()).begin(), t.mesh()), {.25, .25, .5});
  ASSERT_EQ(v.status, IT::Move_status::done);
  ASSERT_EQ(t.remove_vertex(v.vertex), IT::Move_status::done);
  EXPECT_NEAR(IT::measure_quality(t).mean_aspect_ratio, 1, eps);
}

TYPED_TEST(Measure_quality, of_a_grid_is_that_of_half_squares) {
  TypeParam t(meshes::grid(3, 2).input());
  const IT::Quality q = IT::measure_quality(t);
  EXPECT_NEAR(q.minimum_angle, 45, 45 * eps);
  EXPECT_NEAR(q.maximum_angle, 90, 90 * eps);
  EXPECT_EQ(q.angles[4], 24U);
  EXPECT_EQ(q.angles[8] + q.angles[9], 12U);
  // R / (2 r) with legs 1: R = sqrt(2) / 2, r = 1 - sqrt(2) / 2
  EXPECT_NEAR(q.mean_aspect_ratio, std::sqrt(0.5) / (2 - std::sqrt(2.0)), 4 * eps);
  // diagonals have weight 0, the 7 other inner edges (cot 45 + cot 45) / 2; the border is not counted
  EXPECT_NEAR(q.minimum_weight, 0, eps);
  EXPECT_NEAR(q.maximum_weight, 1, eps);
  EXPECT_EQ(std::accumulate(q.weights.begin(), q.weights.end(), std::size_t{0}), 13U);
}

TYPED_TEST(Measure_quality, counts_obtuse_angles_and_negative_weights) {
  TypeParam t(meshes::sheared_grid(3, 3, 2).input());
  const IT::Quality q = IT::measure_quality(t);
  EXPECT_EQ(std::accumulate(q.angles.begin(), q.angles.end(), std::size_t{0}), 54U);
  EXPECT_GT(std::accumulate(q.angles.begin() + 9, q.angles.end(), std::size_t{0}), 0U);
  EXPECT_GT(q.weights[0], 0U);
  EXPECT_LT(q.minimum_weight, 0);
}

// Brute force: the arc tangent of every angle. Angles of all sizes, from slivers to obtuse ones.
TYPED_TEST(Measure_quality, counts_angles_as_arc_tangents_do) {
  for (const double shear : {0., .1, 1., 7., 60., 1e4}) {
    TypeParam t(meshes::sheared_grid(7, 5, shear).input());
    const IT::Quality q = IT::measure_quality(t);
    std::array<std::size_t, 18> angles{};
    double least = 180, greatest = 0;
    for (const auto f : faces(t.mesh())) {
      auto h = halfedge(f, t.mesh());
      for (int k = 0; k < 3; ++k, h = next(h, t.mesh())) {
        const auto squared = [&](auto g) { return t.squared_length(edge(g, t.mesh())); };
        const auto after = next(h, t.mesh()), last = next(after, t.mesh());
        const double angle =
            std::atan2(4 * t.area(f), squared(h) + squared(last) - squared(after)) *
            (180 / std::numbers::pi);
        ++angles[std::min(17, static_cast<int>(angle / 10))];
        least = std::min(least, angle);
        greatest = std::max(greatest, angle);
      }
    }
    EXPECT_NEAR(q.minimum_angle, least, 4e-16 * least);
    EXPECT_NEAR(q.maximum_angle, greatest, 4e-16 * greatest);
    EXPECT_EQ(q.angles, angles) << shear;
  }
}

TYPED_TEST(Measure_quality, believes_what_it_is_told_of_ties) {
  TypeParam t(meshes::grid(2, 2).input());
  const IT::Quality q = IT::measure_quality(t, [](auto) { return true; });
  EXPECT_EQ(q.minimum_weight, 0);
  EXPECT_EQ(q.maximum_weight, 0);
}

} // namespace
