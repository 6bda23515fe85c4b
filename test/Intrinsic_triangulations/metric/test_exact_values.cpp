// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>

#include "meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

// What exact traits hand out is as good as their signs: on surfaces on which doubles that are carried along lose everything.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Exact = IT::Intrinsic_triangulation<>;
using Counted = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                            IT::Integer_coordinates>;

// a sphere, stretched along an axis that is none of the coordinates
meshes::Mesh stretched(double factor) {
  meshes::Mesh m = meshes::sphere(3);
  const double c = 0.6, s = 0.8;
  for (auto& [x, y, z] : m.points) {
    const double along = factor * (c * x + s * y), across = c * y - s * x;
    x = c * along - s * across, y = s * along + c * across;
  }
  return m;
}

template <class T>
double area(const T& t) {
  double sum = 0;
  for (const auto f : faces(t.mesh())) sum += t.area(f);
  return sum;
}

TEST(Exact_values, areas_sum_to_that_of_the_input_on_stretched_spheres) {
  for (const double factor : {1e3, 1e9, 1e15}) {
    Exact t(stretched(factor).input());
    const double before = area(t);
    const auto r = IT::flip_to_delaunay(t);
    EXPECT_GT(r.flips, 100U);
    // each of 512 faces to 1e-12, and so their sum
    EXPECT_NEAR(area(t) / before, 1, 1e-12);
    EXPECT_EQ(t.metric().statistics().probable_zero, 0U);
  }
}

TEST(Exact_values, areas_sum_to_that_of_the_input_where_one_vertex_is_far_away) {
  meshes::Mesh m = meshes::sphere(2);
  for (double& x : m.points[9]) x *= 1e100;
  for (const bool again : {false, true}) {
    Counted t(m.input());
    const double before = area(t);
    if (again) IT::flip_to_delaunay(t);
    EXPECT_NEAR(area(t) / before, 1, 1e-12);
    const IT::Quality q = IT::measure_quality(t);
    EXPECT_GE(q.minimum_angle, 0);
  }
}

// Faces of a pyramid over a regular polygon are isosceles: the cotangent at the base is half the base by the height.
TEST(Exact_values, weights_to_the_apex_of_a_steep_pyramid_are_right) {
  const std::uint32_t n = 200;
  const double height = 1e6;
  meshes::Mesh m;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    m.points.push_back({std::cos(angle), std::sin(angle), 0});
    m.triangles.push_back({i, (i + 1) % n, n});
    m.triangles.push_back({(i + 1) % n, i, n + 1});
  }
  m.points.push_back({0, 0, height});
  m.points.push_back({0, 0, -height});
  const Exact t(m.input());
  const auto L = IT::cotangent_laplacian(t);
  const double half = std::sin(std::numbers::pi / n), r = std::cos(std::numbers::pi / n);
  for (std::uint32_t i = 0; i < n; ++i)
    for (const std::uint32_t apex : {n, n + 1})
      // points are off the circle by 2^-53, which the base of length 0.03 sees 1e15 times as large as the weight
      EXPECT_NEAR(L.coeff(i, apex) * -std::hypot(height, r) / half, 1, 1e-11);
}

TEST(Exact_values, weights_are_zero_or_have_the_right_sign_and_repeat) {
  Exact t(stretched(1e9).input());
  IT::flip_to_delaunay(t);
  const auto first = IT::cotangent_laplacian(t), second = IT::cotangent_laplacian(t);
  for (int k = 0; k < first.outerSize(); ++k)
    for (decltype(IT::cotangent_laplacian(t))::InnerIterator i(first, k); i; ++i) {
      EXPECT_TRUE(i.row() == i.col() || i.value() <= 0);
      EXPECT_NEAR(second.coeff(i.row(), i.col()), i.value(), 1e-12 * std::abs(i.value()));
    }
}

} // namespace
