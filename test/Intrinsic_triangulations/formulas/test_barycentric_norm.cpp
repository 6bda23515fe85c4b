// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/barycentric_norm.h>

#include "slivers.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using namespace slivers;
using Vector = std::array<double, 3>;

constexpr int repetitions = 50;

std::array<Gmpq, 3> exact(const Vector& v) { return {Gmpq(v[0]), Gmpq(v[1]), Gmpq(v[2])}; }

Gmpq exact_inner_product(const Sides& L, const Vector& u, const Vector& v) {
  return IT::barycentric_inner_product(Gmpq(L[0]), Gmpq(L[1]), Gmpq(L[2]), exact(u), exact(v));
}

double plain_eq_23(const Sides& L, const Vector& v) {
  return -L[0] * v[0] * v[1] - L[1] * v[1] * v[2] - L[2] * v[2] * v[0];
}

// Components with 51 bits that sum to zero exactly; some point along a side, or nearly so.
Vector draw_vector(std::mt19937_64& random) {
  constexpr std::int64_t most = std::int64_t{1} << 50;
  std::uniform_int_distribution<std::int64_t> large(-most, most), small(-1, 1);
  const bool along_a_side = random() % 2 == 0;
  const auto x = static_cast<double>(large(random)),
             y = static_cast<double>(along_a_side ? small(random) : large(random));
  std::array<double, 3> v{x, y, -x - y};
  std::rotate(v.begin(), v.begin() + static_cast<int>(random() % 3), v.end());
  return v;
}

// The bound of `squared_quadruple_area()` has a term of second order, which counts on flat caps.
double second_order(Sides L, const Gmpq& d) {
  std::sort(L.begin(), L.end());
  return 20 * u * u * 4 * L[0] * L[1] / CGAL::to_double(d);
}

TEST(Barycentric_norm, is_accurate_to_twelve_u_on_needles_and_caps) {
  std::mt19937_64 random(seed);
  double plain = 0;
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions; ++n) {
      const Sides L = draw_squares(shape, width, random);
      const Vector v = draw_vector(random);
      const Gmpq expected = exact_inner_product(L, v, v);
      if (expected == Gmpq(0)) continue;
      // 3 u per component (7 u squared), 4 u for the product with D, one for the sum, one for the
      // quotient
      EXPECT_LE(error(IT::barycentric_squared_norm(L[0], L[1], L[2], v), expected),
                12 * u + second_order(L, exact_d_from_squares(L)))
          << "width " << width;
      plain = std::max(plain, error(plain_eq_23(L, v), expected));
    }
  });
  EXPECT_GT(plain, 1e-3);
}

TEST(Barycentric_norm, inner_product_is_accurate_against_the_norms) {
  std::mt19937_64 random(seed);
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions; ++n) {
      const Sides L = draw_squares(shape, width, random);
      const Vector v = draw_vector(random), w = draw_vector(random);
      const double scale = std::sqrt(CGAL::to_double(exact_inner_product(L, v, v))) *
                           std::sqrt(CGAL::to_double(exact_inner_product(L, w, w)));
      const double difference =
          CGAL::to_double(Gmpq(IT::barycentric_inner_product(L[0], L[1], L[2], v, w)) -
                          exact_inner_product(L, v, w));
      EXPECT_LE(std::abs(difference), (12 * u + second_order(L, exact_d_from_squares(L))) * scale);
    }
  });
}

TEST(Barycentric_norm, sides_have_their_lengths) {
  std::mt19937_64 random(seed);
  const std::array<Vector, 3> sides{{{-1, 1, 0}, {0, -1, 1}, {1, 0, -1}}};
  for_each_shape([&](Shape shape, double width) {
    const Sides L = draw_squares(shape, width, random);
    for (unsigned s = 0; s < 3; ++s) {
      EXPECT_EQ(exact_inner_product(L, sides[s], sides[s]), Gmpq(L[s]));
      EXPECT_LE(error(IT::barycentric_squared_norm(L[0], L[1], L[2], sides[s]), Gmpq(L[s])),
                12 * u + second_order(L, exact_d_from_squares(L)));
      // <ij, ik> = p_i / 2, and ik = -ki
      const Vector& back = sides[(s + 2) % 3];
      EXPECT_EQ(exact_inner_product(L, sides[s], {-back[0], -back[1], -back[2]}) * Gmpq(2),
                Gmpq(L[s]) + Gmpq(L[(s + 2) % 3]) - Gmpq(L[(s + 1) % 3]));
    }
  });
}

TEST(Barycentric_norm, closed_forms) {
  // 3-4-5 with the right angle at i: from i to the middle of jk is half the hypotenuse
  const Vector i{1, 0, 0}, middle{0, 0.5, 0.5};
  EXPECT_DOUBLE_EQ(IT::barycentric_distance(9.0, 25.0, 16.0, i, middle), 2.5);
  EXPECT_DOUBLE_EQ(IT::barycentric_squared_distance(9.0, 25.0, 16.0, i, middle), 6.25);
  EXPECT_EQ(IT::barycentric_distance(9.0, 25.0, 16.0, i, i), 0);
  // the two legs are orthogonal
  EXPECT_EQ(IT::barycentric_inner_product(9.0, 25.0, 16.0, {-1, 1, 0}, {-1, 0, 1}), 0);
  // from a corner of an equilateral triangle to its centre: 1 / sqrt(3)
  EXPECT_EQ(IT::barycentric_squared_norm(Gmpq(1), Gmpq(1), Gmpq(1),
                                         {Gmpq(2, 3), Gmpq(-1, 3), Gmpq(-1, 3)}),
            Gmpq(1, 3));
  EXPECT_NEAR(IT::barycentric_norm(1.0, 1.0, 1.0, {2.0 / 3, -1.0 / 3, -1.0 / 3}),
              1 / std::sqrt(3.0), 12 * u);
}

TEST(Barycentric_norm, a_side_of_length_zero_is_no_obstacle) {
  EXPECT_EQ(IT::barycentric_squared_norm(0.0, 4.0, 4.0, {-1, 1, 0}), 0);
  EXPECT_EQ(IT::barycentric_squared_norm(0.0, 4.0, 4.0, {0, -1, 1}), 4);
  EXPECT_EQ(IT::barycentric_squared_norm(0.0, 0.0, 0.0, {0, -1, 1}), 0);
}

TEST(Barycentric_norm, intervals_enclose) {
  using Interval = CGAL::Interval_nt<>;
  std::mt19937_64 random(seed);
  for_each_shape([&](Shape shape, double width) {
    const Sides L = draw_squares(shape, width, random);
    const Vector v = draw_vector(random);
    const Interval norm = IT::barycentric_squared_norm(
        Interval(L[0]), Interval(L[1]), Interval(L[2]),
        std::array<Interval, 3>{Interval(v[0]), Interval(v[1]), Interval(v[2])});
    const Gmpq expected = exact_inner_product(L, v, v);
    EXPECT_TRUE(Gmpq(norm.inf()) <= expected && expected <= Gmpq(norm.sup()));
  });
}

TEST(Barycentric_norm, powers_of_two_scale_exactly) {
  std::mt19937_64 random(seed);
  for_each_shape([&](Shape shape, double width) {
    const Sides L = draw_squares(shape, width, random);
    const Vector v = draw_vector(random);
    const double norm = IT::barycentric_squared_norm(L[0], L[1], L[2], v);
    for (const double f : {0x1p-120, 0x1p+100})
      EXPECT_EQ(IT::barycentric_squared_norm(f * L[0], f * L[1], f * L[2], v), f * norm);
  });
}

} // namespace
