// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/Penner_coordinates.h>

#include <CGAL/Gmpq.h>
#include <CGAL/enum.h>

#include <gtest/gtest.h>

#include <random>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Q = CGAL::Gmpq;
using Values = IT::Ideal_diamond_values<Q>;

Values random_diamond(std::mt19937& random) {
  std::uniform_int_distribution<int> any(1, 1000);
  const auto q = [&] { return Q(any(random), any(random)); };
  return {q(), q(), q(), q(), q()};
}

TEST(Penner_coordinates, two_flips_are_the_identity) {
  std::mt19937 random(1);
  for (int n = 0; n < 1000; ++n) {
    const Values v = random_diamond(random);
    EXPECT_EQ(IT::ptolemy_flip(Values{IT::ptolemy_flip(v), v.mj, v.jk, v.ki, v.im}), v.ij);
  }
}

TEST(Penner_coordinates, ideal_delaunay_expression_is_the_sum_of_cosines_times_the_four_sides) {
  std::mt19937 random(2);
  for (int n = 0; n < 1000; ++n) {
    const Values v = random_diamond(random);
    const auto cosines = [&](const Q& a, const Q& b) {
      return (a * a + b * b - v.ij * v.ij) / (a * b);
    };
    EXPECT_EQ(IT::Ideal_delaunay_expression()(v),
              (cosines(v.jk, v.ki) + cosines(v.im, v.mj)) * v.jk * v.ki * v.im * v.mj);
  }
}

TEST(Penner_coordinates, flip_changes_the_sign_of_the_ideal_delaunay_expression) {
  std::mt19937 random(3);
  for (int n = 0; n < 1000; ++n) {
    const Values v = random_diamond(random);
    const Values flipped{IT::ptolemy_flip(v), v.mj, v.jk, v.ki, v.im};
    EXPECT_EQ(CGAL::sign(IT::Ideal_delaunay_expression()(flipped)),
              -CGAL::sign(IT::Ideal_delaunay_expression()(v)));
  }
}

TEST(Penner_coordinates, square_is_a_tie) {
  EXPECT_EQ(IT::Ideal_delaunay_expression()(Values{Q(7, 5), 1, 1, 1, 1}) > Q(0), true);
  EXPECT_EQ(IT::Ideal_delaunay_expression()(Values{5, 3, 4, 3, 4}), Q(0)); // a rectangle
}

} // namespace
