// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_simplification/simplification/hierarchy.h>
#include <CGAL/Intrinsic_simplification/simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplification/simplify.h>

#include "expect_coarse.h"
#include "operator_test_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

using namespace operator_test;
using T = IT::Corresponding_triangulation;

TEST(Hierarchy, has_the_surfaces_that_simplify_makes) {
  const T fine = delaunay(rough_torus(16, .2, 3));
  IT::Simplify_options options;
  options.kept_vertices = {7, 200};
  const std::vector<IT::Simplification> levels = IT::hierarchy(fine, 3, .25, options);
  ASSERT_EQ(levels.size(), 3U);
  std::size_t wanted = 256;
  for (const IT::Simplification& level : levels) {
    wanted /= 4;
    options.vertices = wanted;
    const IT::Simplification alone = IT::simplify(fine, options);
    EXPECT_EQ(level.kept.size(), wanted);
    EXPECT_EQ(level.kept, alone.kept);
    EXPECT_EQ(level.surface.squared_lengths, alone.surface.squared_lengths);
    EXPECT_EQ(level.stretch.upper, alone.stretch.upper);
    EXPECT_EQ(level.removed, alone.removed);
    for (const std::uint32_t v : {7U, 200U}) EXPECT_EQ(std::ranges::count(level.kept, v), 1);
    expect_surface(fine, level);
    expect_distances_within(fine, level);
  }
}

TEST(Hierarchy, has_prolongations_that_compose) {
  const T fine = delaunay(rough_torus(16, .2, 3));
  const std::vector<IT::Simplification> levels = IT::hierarchy(fine, 3);
  ASSERT_EQ(levels.size(), 3U);
  Eigen::SparseMatrix<double> product = IT::prolongation(levels[0]);
  for (std::size_t i = 1; i < levels.size(); ++i) {
    const Eigen::SparseMatrix<double> step = IT::prolongation(levels[i - 1], levels[i]);
    ASSERT_EQ(step.rows(), static_cast<Eigen::Index>(levels[i - 1].kept.size()));
    product = product * step;
    const Eigen::MatrixXd direct = IT::prolongation(levels[i]), found = product;
    // a vertex that all levels but the last have has the place there that the last level knows
    for (const std::uint32_t v : levels[i - 1].kept)
      EXPECT_EQ((found - direct).row(static_cast<Eigen::Index>(v)).cwiseAbs().maxCoeff(), 0);
    EXPECT_GE(found.minCoeff(), 0);
    EXPECT_LT((found.rowwise().sum().array() - 1).abs().maxCoeff(), 1e-14);
  }
}

// Where the maps are isometries, linear functions stay linear at all levels: the product of the
// steps takes them to the same as the direct matrix.
TEST(Hierarchy, takes_linear_functions_through_all_levels) {
  const Shape shape = rough_grid(20, .3, 0, 2);
  const T fine = delaunay(shape);
  IT::Simplify_options options; // the corners of the square stay; other border vertices are flat
  options.kept_vertices = {0, 20, 420, 440};
  for (const auto h : halfedges(fine.mesh()))
    if (CGAL::is_border(h, fine.mesh()))
      options.kept_vertices.push_back(fine.input_vertex(target(h, fine.mesh())));
  const std::vector<IT::Simplification> levels = IT::hierarchy(fine, 3, .6, options);
  ASSERT_EQ(levels.size(), 3U);
  const auto function = [&](std::uint32_t v) {
    return 3 * shape.points[v][0] - 2 * shape.points[v][1] + 1;
  };
  const std::vector<std::uint32_t>& last = levels.back().kept;
  Eigen::VectorXd values(static_cast<Eigen::Index>(last.size()));
  for (std::size_t c = 0; c < last.size(); ++c)
    values[static_cast<Eigen::Index>(c)] = function(last[c]);
  const Eigen::VectorXd direct = IT::prolongation(levels[2]) * values;
  const Eigen::VectorXd in_steps =
      IT::prolongation(levels[0]) *
      (IT::prolongation(levels[0], levels[1]) * (IT::prolongation(levels[1], levels[2]) * values));
  for (std::uint32_t v = 0; v < shape.points.size(); ++v) {
    EXPECT_NEAR(direct[static_cast<Eigen::Index>(v)], function(v), 1e-10);
    EXPECT_NEAR(in_steps[static_cast<Eigen::Index>(v)], function(v), 1e-10);
  }
}

TEST(Hierarchy, refuses_ratios_out_of_range_and_stops_when_asked) {
  const T fine = delaunay(rough_torus(20, .2, 3));
  for (const double ratio : {0., 1., -1., 2., std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(IT::hierarchy(fine, 2, ratio), IT::Invalid_input);
  EXPECT_TRUE(IT::hierarchy(fine, 0).empty());
  IT::Simplify_options options;
  std::size_t calls = 0;
  options.progress = [&](const IT::Simplify_progress& p) {
    ++calls;
    EXPECT_EQ(p.removed + p.left, 400U);
    return false;
  };
  const std::vector<IT::Simplification> levels = IT::hierarchy(fine, 9, .5, options);
  ASSERT_EQ(levels.size(), 2U); // tries are counted through all levels
  EXPECT_EQ(calls, 1U);
  EXPECT_EQ(levels[0].status, IT::Status::done);
  EXPECT_EQ(levels[1].status, IT::Status::cancelled);
}

} // namespace
