// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/parametrization/pack_components.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

// Components of maps beside each other.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Box = Eigen::AlignedBox2d;

struct Parts {
  Eigen::MatrixX2d uv;
  std::vector<std::uint32_t> component; // any numbers, in any order
};

// Clouds of points about the same place, with sizes over some powers of two.
Parts random_parts(std::uint32_t count, double powers, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  Parts p{Eigen::MatrixX2d(12 * count, 2), {}};
  for (std::uint32_t i = 0; i < count; ++i) {
    const double width = std::exp2(powers * unit(random)),
                 height = std::exp2(powers * unit(random));
    for (std::uint32_t k = 0; k < 12; ++k) {
      p.uv.row(12 * i + k) << 3 + width * unit(random), height * unit(random) - 5;
      p.component.push_back((7 * i + 3) % 1009);
    }
  }
  return p;
}

std::vector<Box> boxes_of(const Eigen::MatrixX2d& uv, std::size_t count) {
  std::vector<Box> boxes(count);
  for (Eigen::Index r = 0; r < uv.rows(); ++r)
    boxes[static_cast<std::size_t>(r / 12)].extend(Eigen::Vector2d(uv.row(r).transpose()));
  return boxes;
}

} // namespace

TEST(Pack_components, Boxes_are_disjoint_and_components_only_move) {
  std::mt19937 random(1);
  for (const std::uint32_t count : {2U, 3U, 10U, 100U})
    for (const double powers : {0., 1., 8.}) {
      SCOPED_TRACE(std::to_string(count) + " of sizes over powers " + std::to_string(powers));
      Parts p = random_parts(count, powers, random);
      const Eigen::MatrixX2d before = p.uv;
      IT::pack_components(p.uv, p.component);
      const std::vector<Box> boxes = boxes_of(p.uv, count);
      double area = 0, longest = 0;
      Box all;
      for (const Box& b : boxes) {
        area += b.volume();
        longest = std::max(longest, b.sizes().maxCoeff());
        all.extend(b);
      }
      const double gap = 0.02 * std::max(std::sqrt(area), longest),
                   error = 1e-13 * all.max().norm();
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_GE(boxes[i].exteriorDistance(boxes[j]), gap - error);
      EXPECT_LE(all.min().norm(), error);
      for (std::uint32_t i = 0; i < count; ++i) {
        const Eigen::MatrixX2d move = p.uv.middleRows(12 * i, 12) - before.middleRows(12 * i, 12);
        EXPECT_LE((move.rowwise() - move.row(0)).cwiseAbs().maxCoeff(), error);
      }
      // equal squares fill their shelves but for one place, and the last shelf
      if (powers == 0) {
        EXPECT_LE(all.volume(), 4 * area);
      }
    }
}

TEST(Pack_components, One_component_and_rows_without_stay_where_they_are) {
  std::mt19937 random(2);
  Parts p = random_parts(1, 1, random);
  const Eigen::MatrixX2d before = p.uv;
  IT::pack_components(p.uv, p.component);
  EXPECT_EQ(p.uv, before);
  p = random_parts(3, 1, random);
  const Eigen::RowVector2d place = p.uv.row(5);
  p.component[5] = IT::Gluing::none;
  IT::pack_components(p.uv, p.component);
  EXPECT_EQ(p.uv.row(5), place);
}

TEST(Pack_components, Points_and_segments_are_taken_apart) {
  Parts p{Eigen::MatrixX2d::Zero(4, 2), {4, 1, 2, 1}};
  IT::pack_components(p.uv, p.component);
  EXPECT_EQ(p.uv.row(1), p.uv.row(3));
  for (const auto& [i, j] : {std::array{0, 1}, {0, 2}, {1, 2}})
    EXPECT_GT((p.uv.row(i) - p.uv.row(j)).norm(), 0);
  p.uv.row(3) << 0, 9;
  const double length = (p.uv.row(3) - p.uv.row(1)).norm();
  IT::pack_components(p.uv, p.component);
  EXPECT_NEAR((p.uv.row(3) - p.uv.row(1)).norm(), length, 1e-14);
  EXPECT_GT((p.uv.row(0) - p.uv.row(2)).norm(), 0.1);
}

TEST(Pack_components, Bad_input_is_refused) {
  std::mt19937 random(3);
  Parts p = random_parts(2, 1, random);
  p.component.pop_back();
  EXPECT_THROW(IT::pack_components(p.uv, p.component), IT::Invalid_input);
  p = random_parts(2, 1, random);
  p.uv(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(IT::pack_components(p.uv, p.component), IT::Invalid_input);
}
