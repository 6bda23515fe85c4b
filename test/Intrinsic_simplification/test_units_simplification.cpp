// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification.h>

#include "operator_test_meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// On a surface that is 2^30 times as large or as small, results are those on the surface times a
// power of that, bit for bit.

namespace {

using namespace operator_test;

struct Found {
  std::vector<IT::Simplification> results;
  std::vector<double> lengths, areas; // of candidates
  Eigen::MatrixXcd vectors;           // the prolongation
};

Found find(Shape shape, double unit) {
  for (auto& p : shape.points)
    for (double& x : p) x *= unit;
  IT::Corresponding_triangulation t(shape.input());
  IT::flip_to_delaunay(t);
  Found found;
  IT::Simplify_options options;
  options.vertices = 20;
  found.results.push_back(IT::simplify(t, options));
  found.vectors = IT::vector_prolongation(
      t, IT::Corresponding_triangulation(found.results[0].surface), found.results[0]);
  found.results.push_back(IT::simplify(t, options, IT::curvature_cost(t)));
  found.results.push_back(IT::simplify(t, options, IT::area_cost(t)));
  found.results.push_back(IT::simplify(t, options, IT::balanced_cost(t)));
  const auto by_name = [&](const char* name) {
    return IT::with_named_cost(
        name, t, [&](auto&& cost) { return IT::simplify(t, options, std::move(cost)); });
  };
  const std::array names{"stretch", "curvature", "area", "balanced"};
  for (std::size_t k = 0; k < names.size(); ++k)
    EXPECT_EQ(by_name(names[k]).kept, found.results[k].kept) << names[k];
  found.results.push_back(IT::simplify(t, options, [&](const IT::Removal_candidate& c) {
    found.lengths.push_back(c.mean_length);
    found.areas.push_back(c.area);
    return c.curvature + c.stretch;
  }));
  found.results.push_back(IT::remove_flat_vertices(t, 0.3));
  found.results.push_back(IT::hierarchy(t, 2).back());
  return found;
}

TEST(Units_of_coarse_surfaces, of_coarse_surfaces_are_the_users) {
  const Shape shape = rough_torus(8, .3, 2);
  const Found one = find(shape, 1);
  for (const int exponent : {-30, 30}) {
    const Found other = find(shape, std::ldexp(1, exponent));
    for (std::size_t i = 0; i < one.results.size(); ++i) {
      const IT::Simplification &a = one.results[i], &b = other.results[i];
      EXPECT_GT(a.removed, 0U);
      EXPECT_EQ(a.kept, b.kept);
      EXPECT_EQ(a.stretch.lower, b.stretch.lower);
      EXPECT_EQ(a.stretch.upper, b.stretch.upper);
      ASSERT_EQ(a.surface.squared_lengths.size(), b.surface.squared_lengths.size());
      for (std::size_t e = 0; e < a.surface.squared_lengths.size(); ++e)
        EXPECT_EQ(std::ldexp(a.surface.squared_lengths[e], 2 * exponent),
                  b.surface.squared_lengths[e]);
    }
    EXPECT_EQ(one.vectors, other.vectors);
    ASSERT_EQ(one.lengths.size(), other.lengths.size());
    for (std::size_t k = 0; k < one.lengths.size(); ++k) {
      EXPECT_EQ(std::ldexp(one.lengths[k], exponent), other.lengths[k]);
      EXPECT_EQ(std::ldexp(one.areas[k], 2 * exponent), other.areas[k]);
    }
  }
}

} // namespace
