// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/corner_angles.h>

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

// What the formulas replace.
double law_of_cosines(const Sides& l) {
  const double c = (l[0] * l[0] + l[2] * l[2] - l[1] * l[1]) / (2 * l[0] * l[2]);
  return std::acos(std::clamp(c, -1.0, 1.0));
}

double sum_of(const Sides& s) { return s[0] + s[1] + s[2]; }

// The bound of `quadruple_area_from_squared_lengths()`.
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

TEST(Corner_angles, inner_product_from_lengths_is_as_accurate_as_stated) {
  std::mt19937_64 random(seed);
  double plain = 0;
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions; ++n) {
      const Sides s = draw_lengths(shape, width, random);
      const Gmpq p = exact_p_from_lengths(s);
      const double y = std::min(s[0], s[2]);
      const double scale = std::abs(CGAL::to_double(p)) + y * y;
      const auto scaled_error = [&](double x) {
        return std::abs(CGAL::to_double(Gmpq(x) - p)) / scale;
      };
      EXPECT_LE(scaled_error(IT::twice_inner_product_from_lengths(s[0], s[1], s[2])),
                4 * u * (1 + 8 * u));
      plain = std::max(plain, scaled_error(s[0] * s[0] + s[2] * s[2] - s[1] * s[1]));
      EXPECT_EQ(IT::twice_inner_product_from_lengths(Gmpq(s[0]), Gmpq(s[1]), Gmpq(s[2])), p);
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
      EXPECT_LE(angle_error(IT::corner_angle_from_squared_lengths(s[0], s[1], s[2]), d, p), bound);
    }
  });
}

TEST(Corner_angles, angle_from_lengths_is_accurate_to_nine_u) {
  std::mt19937_64 random(seed);
  double by_cosines = 0;
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions; ++n) {
      const Sides s = draw_lengths(shape, width, random);
      const Gmpq d = exact_d_from_lengths(s), p = exact_p_from_lengths(s);
      // four roundings below each root (halved) or one more, one per root, and atan2: at most 9 u
      EXPECT_LE(angle_error(IT::corner_angle_from_lengths(s[0], s[1], s[2]), d, p), 9 * u);
      by_cosines = std::max(by_cosines, angle_error(law_of_cosines(s), d, p));
    }
  });
  EXPECT_GT(by_cosines, 0.5);
}

TEST(Corner_angles, angles_of_a_triangle_sum_to_pi) {
  std::mt19937_64 random(seed);
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions; ++n) {
      Sides s = draw_lengths(shape, width, random);
      std::array<double, 3> angles;
      for (double& angle : angles) {
        angle = IT::corner_angle_from_lengths(s[0], s[1], s[2]);
        s = rotated(s);
      }
      // relative errors of 9 u each
      EXPECT_NEAR(IT::boundary_geodesic_curvature(angles), 0, 9 * u * std::numbers::pi);
    }
  });
}

TEST(Corner_angles, closed_forms) {
  constexpr double pi = std::numbers::pi;
  // equilateral, right isosceles, and half an equilateral triangle, as squared lengths
  EXPECT_DOUBLE_EQ(IT::corner_angle_from_squared_lengths(1.0, 1.0, 1.0), pi / 3);
  EXPECT_DOUBLE_EQ(IT::corner_angle_from_squared_lengths(1.0, 2.0, 1.0), pi / 2);
  EXPECT_DOUBLE_EQ(IT::corner_angle_from_squared_lengths(2.0, 1.0, 1.0), pi / 4);
  EXPECT_DOUBLE_EQ(IT::corner_angle_from_squared_lengths(4.0, 1.0, 3.0), pi / 6);
  EXPECT_DOUBLE_EQ(IT::corner_angle_from_lengths(2.0, 2.0, 2.0), pi / 3);
  EXPECT_DOUBLE_EQ(IT::corner_angle_from_lengths(3.0, 5.0, 4.0), pi / 2);
  EXPECT_DOUBLE_EQ(IT::corner_angle_from_lengths(4.0, 3.0, 5.0), std::atan2(3.0, 4.0));
  EXPECT_EQ(IT::corner_angle_from_lengths(3.0L, 5.0L, 4.0L), std::numbers::pi_v<long double> / 2);
  // the cosine of the angle between 3 and 7 opposite 8 is -1/7; 5, 7, 8 has an angle of pi / 3
  EXPECT_DOUBLE_EQ(IT::corner_angle_from_lengths(3.0, 8.0, 7.0), std::acos(-1.0 / 7));
  EXPECT_DOUBLE_EQ(IT::corner_angle_from_lengths(5.0, 7.0, 8.0), pi / 3);
  // flat triangles
  EXPECT_EQ(IT::corner_angle_from_lengths(1.0, 3.0, 2.0), pi);
  EXPECT_EQ(IT::corner_angle_from_lengths(3.0, 1.0, 2.0), 0);
  EXPECT_EQ(IT::corner_angle(0.0, -1.0), pi);
  EXPECT_EQ(IT::corner_angle(Gmpq(0), Gmpq(1)), 0);
  EXPECT_DOUBLE_EQ(IT::corner_angle(Gmpq(24), Gmpq(24)), pi / 4);
}

TEST(Corner_angles, eccentric_needle_of_kahan_keeps_its_angles) {
  // sides 1, 1, 2^-50: apex 2 asin(2^-51), base angles acos(2^-51)
  const double w = 0x1p-50;
  EXPECT_DOUBLE_EQ(IT::corner_angle_from_lengths(1.0, w, 1.0), w);
  EXPECT_DOUBLE_EQ(IT::corner_angle_from_lengths(1.0, 1.0, w), std::acos(w / 2));
  EXPECT_NE(law_of_cosines({1.0, w, 1.0}), w);
}

TEST(Corner_angles, cotangents_in_closed_form) {
  // 13, 14, 15: 4A = 336, p = 169 + 196 - 225 = 140 between 13 and 14
  EXPECT_EQ(IT::twice_inner_product(Gmpq(169), Gmpq(225), Gmpq(196)), Gmpq(140));
  EXPECT_EQ(IT::cotangent(Gmpq(336), Gmpq(140)), Gmpq(5, 12));
  EXPECT_DOUBLE_EQ(IT::cotangent_from_lengths(13.0, 15.0, 14.0), 5.0 / 12);
  EXPECT_EQ(IT::cotangent_from_lengths(3.0, 5.0, 4.0), 0);
  EXPECT_DOUBLE_EQ(IT::cotangent_from_lengths(1.0, 1.0, 1.0), 1 / std::sqrt(3.0));
}

TEST(Corner_angles, cotangent_from_lengths_is_as_accurate_as_stated) {
  std::mt19937_64 random(seed);
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions; ++n) {
      const Sides s = draw_lengths(shape, width, random);
      const Gmpq d = exact_d_from_lengths(s), p = exact_p_from_lengths(s);
      const double a = std::sqrt(CGAL::to_double(d)), exact = CGAL::to_double(p) / a;
      const double y = std::min(s[0], s[2]);
      // 6 u of a, 4 u of p, the quotient's u, and the reference's own four roundings
      const double bound = 15 * u * std::abs(exact) + 4 * u * y * y / a;
      EXPECT_NEAR(IT::cotangent_from_lengths(s[0], s[1], s[2]), exact, bound * (1 + 8 * u));
    }
  });
}

TEST(Corner_angles, intervals_enclose_the_cotangent) {
  using Interval = CGAL::Interval_nt<>;
  std::mt19937_64 random(seed);
  for_each_shape([&](Shape shape, double width) {
    const Sides s = draw_squares(shape, width, random);
    const Interval p = IT::twice_inner_product(Interval(s[0]), Interval(s[1]), Interval(s[2]));
    const Gmpq exact = exact_p_from_squares(s);
    EXPECT_TRUE(Gmpq(p.inf()) <= exact && exact <= Gmpq(p.sup()));
    // of the two subtractions the one that may cancel is exact or of the smaller numbers
    if (shape == Shape::needle) {
      EXPECT_LE(p.sup() - p.inf(), 8 * u * (std::abs(p.sup()) + std::min(s[0], s[2])));
    }
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
