// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_simplification/embedding/embed_convex.h>

#include "operator_test_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

// Points are in the unit of the lengths: on a surface that is 2^30 times as large, bit for bit.

namespace {

using namespace operator_test;

TEST(UnitsOfEmbedding, ofPointsAreTheUsers) {
  Shape small = tetrahedron(), large = small;
  for (auto& p : large.points)
    for (double& x : p) x *= 0x1p30;
  const IT::Convex_polyhedron p = IT::embed_convex(IT::Corresponding_triangulation(small.input())),
                              q = IT::embed_convex(IT::Corresponding_triangulation(large.input()));
  ASSERT_EQ(p.points.size(), q.points.size());
  for (std::size_t v = 0; v < p.points.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(std::ldexp(p.points[v][k], 30), q.points[v][k]);
  EXPECT_EQ(std::ldexp(p.certificate.within, 30), q.certificate.within);
  EXPECT_EQ(p.largest_error, q.largest_error);
}

} // namespace
