// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>

#include "slivers.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using namespace slivers;

constexpr int repetitions = 50;

double sum_of(const Sides& s) { return s[0] + s[1] + s[2]; }

double angle(double ij, double jk, double ki) {
  return IT::corner_angle(std::sqrt(IT::squared_quadruple_area(ij, jk, ki)),
                          IT::twice_inner_product(ij, jk, ki));
}

// The bound of the root of `squared_quadruple_area()`.
double area_bound(Sides s, const Gmpq& d) {
  std::sort(s.begin(), s.end());
  return 2 * u + 40 * u * u * s[0] * s[1] / CGAL::to_double(d);
}

TEST(Corner_angles, inner_product_from_squared_lengths_is_accurate_to_one_u) {
  std::mt19937_64 random(seed);
  double plain = 0;
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions; ++n) {
      const Sides s = draw_squares(shape, width, random);
      const Gmpq p = exact_p_from_squares(s);
      if (p == Gmpq(0)) continue;
      // one rounding of the result, and four of the lost parts
      const double bound = u + 4 * u * u * sum_of(s) / std::abs(CGAL::to_double(p));
      EXPECT_LE(error(IT::twice_inner_product(s[0], s[1], s[2]), p), bound);
      plain = std::max(plain, error(s[0] + s[2] - s[1], p));
      EXPECT_EQ(IT::twice_inner_product(Gmpq(s[0]), Gmpq(s[1]), Gmpq(s[2])), p);
    }
  });
  EXPECT_GT(plain, 0.1);
}

TEST(Corner_angles, angle_from_squared_lengths_is_accurate_near_zero_and_pi) {
  std::mt19937_64 random(seed);
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions; ++n) {
      const Sides s = draw_squares(shape, width, random);
      const Gmpq d = exact_d_from_squares(s), p = exact_p_from_squares(s);
      const double p_over_s = std::abs(CGAL::to_double(p)) / sum_of(s);
      if (p_over_s == 0) continue;
      // the relative errors of a and p, not magnified, and atan2: 2 u
      const double bound = area_bound(s, d) + (u + 4 * u * u / p_over_s) + 2 * u;
      EXPECT_LE(angle_error(angle(s[0], s[1], s[2]), d, p), bound);
    }
  });
}

TEST(Corner_angles, angles_of_a_triangle_sum_to_pi) {
  std::mt19937_64 random(seed);
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions; ++n) {
      Sides s = draw_squares(shape, width, random);
      const double bound = area_bound(s, exact_d_from_squares(s)) + 4 * u;
      std::array<double, 3> angles;
      for (double& a : angles) {
        a = angle(s[0], s[1], s[2]);
        s = rotated(s);
      }
      EXPECT_NEAR(IT::boundary_geodesic_curvature(angles), 0, bound * std::numbers::pi);
    }
  });
}

TEST(Corner_angles, closed_forms) {
  constexpr double pi = std::numbers::pi;
  // equilateral, right isosceles, and half an equilateral triangle, as squared lengths
  EXPECT_DOUBLE_EQ(angle(1.0, 1.0, 1.0), pi / 3);
  EXPECT_DOUBLE_EQ(angle(1.0, 2.0, 1.0), pi / 2);
  EXPECT_DOUBLE_EQ(angle(2.0, 1.0, 1.0), pi / 4);
  EXPECT_DOUBLE_EQ(angle(4.0, 1.0, 3.0), pi / 6);
  EXPECT_DOUBLE_EQ(angle(9, 25, 16), pi / 2);
  EXPECT_DOUBLE_EQ(angle(16, 9, 25), std::atan2(3.0, 4.0));
  // the cosine of the angle between 3 and 7 opposite 8 is -1/7; 5, 7, 8 has an angle of pi / 3
  EXPECT_DOUBLE_EQ(angle(9, 64, 49), std::acos(-1.0 / 7));
  EXPECT_DOUBLE_EQ(angle(25, 49, 64), pi / 3);
  // flat triangles
  EXPECT_EQ(angle(1, 9, 4), pi);
  EXPECT_EQ(angle(9, 1, 4), 0);
  EXPECT_EQ(IT::corner_angle(0.0, -1.0), pi);
  EXPECT_EQ(IT::corner_angle(24.0L, 24.0L), std::numbers::pi_v<long double> / 4);
}

TEST(Corner_angles, eccentric_needle_of_kahan_keeps_its_angles) {
  // sides 1, 1, 2^-50: apex 2 asin(2^-51), base angles acos(2^-51)
  const double w = 0x1p-50;
  EXPECT_DOUBLE_EQ(angle(1, w * w, 1), w);
  EXPECT_DOUBLE_EQ(angle(1, 1, w * w), std::acos(w / 2));
}

TEST(Corner_angles, intervals_enclose_the_inner_product) {
  using Interval = CGAL::Interval_nt<>;
  std::mt19937_64 random(seed);
  for_each_shape([&](Shape shape, double width) {
    const Sides s = draw_squares(shape, width, random);
    const Interval p = IT::twice_inner_product(Interval(s[0]), Interval(s[1]), Interval(s[2]));
    const Gmpq exact = exact_p_from_squares(s);
    EXPECT_TRUE(Gmpq(p.inf()) <= exact && exact <= Gmpq(p.sup()));
  });
}

TEST(Corner_angles, curvature_of_known_vertices) {
  constexpr double pi = std::numbers::pi;
  EXPECT_DOUBLE_EQ(IT::angle_defect(std::vector<double>(3, pi / 2)), pi / 2); // cube
  EXPECT_DOUBLE_EQ(IT::angle_defect(std::array<double, 3>{pi / 3, pi / 3, pi / 3}),
                   pi); // tetrahedron
  EXPECT_DOUBLE_EQ(IT::angle_defect(std::vector<double>{}), 2 * pi);
  EXPECT_DOUBLE_EQ(IT::boundary_geodesic_curvature(std::vector<double>{pi / 2}), pi / 2);
  EXPECT_EQ(IT::angle_defect(std::vector<long double>{}), 2 * std::numbers::pi_v<long double>);
  // 2 pi is no double: four times the double next to pi / 2 leaves the rest of 2 pi, 2.449e-16
  EXPECT_DOUBLE_EQ(IT::angle_defect(std::vector<double>(4, pi / 2)), 2.4492935982947064e-16);
}

TEST(Corner_angles, angle_defect_of_a_vertex_of_high_degree_is_accurate) {
  // 1e5 subtractions without compensation lose digits; 2 pi is held to twice double precision
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> angles(100000);
  Gmpq sum(0);
  double plain = 2 * std::numbers::pi;
  for (double& angle : angles) {
    angle = 1e-4 * unit(random);
    sum += Gmpq(angle);
    plain -= angle;
  }
  const Gmpq two_pi = Gmpq(2 * std::numbers::pi) + Gmpq(2.4492935982947064e-16);
  EXPECT_LE(error(IT::angle_defect(angles), two_pi - sum), 2 * u);
  EXPECT_GT(error(plain, two_pi - sum), 20 * u);
}

} // namespace
