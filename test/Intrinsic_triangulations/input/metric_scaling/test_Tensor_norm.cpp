// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/input/metric_scaling/Tensor_norm.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Tensor_norm;

namespace {

TEST(Tensor_norm, is_euclidean_by_default) { EXPECT_EQ(Tensor_norm()({3, 4}), 5); }

TEST(Tensor_norm, measures_vectors_by_its_tensor) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 100; ++i) {
    const double xx = 2 + unit(random), yy = 2 + unit(random), xy = 0.9 * unit(random);
    const double x = unit(random), y = unit(random);
    const double square = xx * x * x + 2 * xy * x * y + yy * y * y;
    EXPECT_NEAR(Tensor_norm::from_tensor(xx, xy, yy)({x, y}), std::sqrt(square), 1e-14);
  }
}

TEST(Tensor_norm, of_a_tensor_that_is_not_positive_definite_is_not_a_number) {
  const double tensors[][3] = {{-1, 0, 1}, {1, 0, -1},  {1, 2, 1},       {1, 1, 1},
                               {0, 0, 1},  {0, 1, 1},   {NAN, 0, 1},     {1, NAN, 1},
                               {1, 0, 0},  {1, 0, NAN}, {INFINITY, 0, 1}};
  for (const auto& t : tensors) {
    EXPECT_TRUE(std::isnan(Tensor_norm::from_tensor(t[0], t[1], t[2])({1, 0})));
    EXPECT_TRUE(std::isnan(Tensor_norm::from_tensor(t[0], t[1], t[2])({1, 2})));
  }
}

TEST(Tensor_norm, stretches_along_and_across_a_direction) {
  const double root = std::sqrt(0.5);
  for (const double ratio : {1.0, 1e3, 1e12}) {
    const Tensor_norm n = Tensor_norm::from_stretches({5, 5}, ratio, 2);
    EXPECT_NEAR(n({root, root}), ratio, 1e-15 * ratio);
    EXPECT_NEAR(n({root, -root}), 2, 1e-14); // its own accuracy, however large the ratio
    EXPECT_NEAR(n({0, root}), std::hypot(ratio, 2) / 2, 1e-15 * ratio);
  }
}

} // namespace
