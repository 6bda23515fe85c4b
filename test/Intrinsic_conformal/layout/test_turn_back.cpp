// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/layout/turn_back.h>
#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Triangles grid(std::uint32_t n) {
  Triangles result;
  for (std::uint32_t i = 0; i + 1 < n; ++i)
    for (std::uint32_t j = 0; j + 1 < n; ++j) {
      const std::uint32_t a = i * n + j, b = a + n, c = b + 1, d = a + 1;
      result.push_back({a, b, c});
      result.push_back({a, c, d});
    }
  return result;
}

std::size_t turned(const Triangles& triangles, const Eigen::MatrixX2d& z) {
  const IT::Map_certificate c = IT::certify_map(triangles, z);
  return c.flipped + c.degenerate;
}

// The inner part of a grid is smaller than the distance of doubles at its place.
TEST(TurnBack, turnsTrianglesThatRoundingTurnedOver) {
  constexpr std::uint32_t n = 5;
  const Triangles triangles = grid(n);
  const double unit = std::ldexp(1., -49); // the distance of doubles between 8 and 16
  for (const double step : {0.4, 0.6, 0.9}) {
    Eigen::MatrixX2d z(n * n, 2);
    for (std::uint32_t v = 0; v < n * n; ++v)
      for (std::uint32_t c = 0; c < 2; ++c) {
        const double k = (c == 0 ? v / n : v % n) - 2.;
        z(v, c) = 10.25 + (std::abs(k) == 2 ? k / 2 : k * step * unit);
      }
    const Eigen::MatrixX2d before = z;
    ASSERT_EQ(turned(triangles, z) > 0, step < 0.5);
    IT::internal::turn_back(triangles, z);
    EXPECT_EQ(turned(triangles, z), 0U);
    EXPECT_LE((z - before).cwiseAbs().maxCoeff(), 32 * unit);
    if (step > 0.5) { // right triangles stay where they are
      EXPECT_EQ(z, before);
    }
  }
}

TEST(TurnBack, leavesFoldsAsTheyAre) {
  const Triangles triangles{{0, 1, 2}, {1, 0, 3}};
  Eigen::MatrixX2d z(4, 2);
  z << 0, 0, 1, 0, 0, 1, 0, 0.5;
  const Eigen::MatrixX2d before = z;
  IT::internal::turn_back(triangles, z);
  EXPECT_EQ(z, before);
  z(3, 1) = std::nan("");
  IT::internal::turn_back(triangles, z);
  EXPECT_EQ(z.topRows(3), before.topRows(3));
}

} // namespace
