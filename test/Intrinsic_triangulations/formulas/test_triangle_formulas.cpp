// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>

#include "slivers.h"
#include "wide_numbers.h"

#include <CGAL/CORE_Expr.h>
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
using wide_numbers::may_be_zero;
using wide_numbers::Wide;
using wide_numbers::wide;
using namespace slivers;

constexpr int repetitions = 200;

// What the formulas replace: each must be seen to fail, or the tests would not tell them apart.
double plain_squared_area(const Sides& L) {
  const double p = L[0] + L[2] - L[1];
  return 4 * L[0] * L[2] - p * p;
}

// Two roundings of the final sums, and those of the lost parts: see the bound documented.
double squared_area_bound(Sides s, const Gmpq& d) {
  std::sort(s.begin(), s.end());
  return 2 * u + 80 * u * u * s[0] * s[1] / CGAL::to_double(d);
}
// The bound of the root.
double area_bound(const Sides& s, const Gmpq& d) { return squared_area_bound(s, d) / 2 + u; }

TEST(Triangle_formulas, squared_area_from_squared_lengths_is_accurate_to_two_u) {
  std::mt19937_64 random(seed);
  double plain = 0;
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions; ++n) {
      const Sides s = draw_squares(shape, width, random);
      const Gmpq d = exact_d_from_squares(s);
      EXPECT_LE(error(IT::squared_quadruple_area(s[0], s[1], s[2]), d), squared_area_bound(s, d));
      plain = std::max(plain, error(plain_squared_area(s), d));
      EXPECT_EQ(IT::squared_quadruple_area(Gmpq(s[0]), Gmpq(s[1]), Gmpq(s[2])), d);
    }
  });
  EXPECT_GT(plain, 1e3); // no digit is right
}

TEST(Triangle_formulas, integer_triangles_are_exact_in_every_number_type) {
  for (const auto& s : {std::array<int, 4>{3, 4, 5, 24}, std::array<int, 4>{5, 12, 13, 120},
                        std::array<int, 4>{13, 14, 15, 336}, std::array<int, 4>{3, 25, 26, 144}}) {
    const auto check = [&]<class FT>(const FT&) {
      const auto x = static_cast<FT>(s[0]), y = static_cast<FT>(s[1]), z = static_cast<FT>(s[2]),
                 area = static_cast<FT>(s[3]);
      EXPECT_EQ(IT::squared_quadruple_area(FT(z * z), FT(x * x), FT(y * y)), FT(area * area));
    };
    check(0.0F);
    check(0.0);
    check(0.0L);
    check(CORE::Expr(0));
    EXPECT_EQ(IT::squared_quadruple_area(Gmpq(s[0] * s[0]), Gmpq(s[1] * s[1]), Gmpq(s[2] * s[2])),
              Gmpq(s[3] * s[3]));
  }
}

TEST(Triangle_formulas, intervals_enclose_the_area_and_the_inner_product) {
  std::mt19937_64 random(seed);
  using Interval = CGAL::Interval_nt<>;
  for_each_shape([&](Shape shape, double width) {
    const Sides s = draw_squares(shape, width, random);
    const Gmpq d = exact_d_from_squares(s);
    const Interval x(s[0]), y(s[1]), z(s[2]);
    const Interval squared = IT::squared_quadruple_area(x, y, z);
    EXPECT_LE(Gmpq(squared.inf()), d);
    EXPECT_GE(Gmpq(squared.sup()), d);
    const Interval p = IT::twice_inner_product(x, y, z);
    const Gmpq exact = exact_p_from_squares(s);
    EXPECT_TRUE(Gmpq(p.inf()) <= exact && exact <= Gmpq(p.sup()));
  });
}

TEST(Triangle_formulas, balls_of_256_bits_enclose_the_area) {
  const Wide d = IT::squared_quadruple_area(Wide(1.0), Wide(1.0), Wide(0x1p-90));
  EXPECT_TRUE(may_be_zero(d - wide(exact_d_from_squares({1.0, 1.0, 0x1p-90}))));
  EXPECT_FALSE(may_be_zero(d));
}

TEST(Triangle_formulas, degenerate_triangles_have_no_area) {
  EXPECT_EQ(IT::squared_quadruple_area(1.0, 9.0, 4.0), 0);
  EXPECT_EQ(IT::squared_quadruple_area(1.0, 1.0, 0.0), 0);
  // collinear points whose squared lengths are rounded
  const double l = 0.1, m = 0.7, n = l + m;
  EXPECT_NEAR(IT::squared_quadruple_area(l * l, m * m, n * n), 0, 1e-14);
}

TEST(Triangle_formulas, powers_of_two_scale_exactly) {
  std::mt19937_64 random(seed);
  for_each_shape([&](Shape shape, double width) {
    const Sides s = draw_squares(shape, width, random);
    for (const int e : {-200, -2, 6, 240}) {
      const double f = std::ldexp(1.0, e);
      EXPECT_EQ(IT::squared_quadruple_area(f * s[0], f * s[1], f * s[2]),
                f * f * IT::squared_quadruple_area(s[0], s[1], s[2]));
    }
  });
}

TEST(Triangle_formulas, order_of_the_sides_does_not_matter) {
  std::mt19937_64 random(seed);
  for_each_shape([&](Shape shape, double width) {
    Sides s = draw_squares(shape, width, random);
    const double from_squares = IT::squared_quadruple_area(s[0], s[1], s[2]);
    for (int n = 0; n < 6; ++n) {
      s = rotated(s);
      if (n == 2) std::swap(s[0], s[1]);
      EXPECT_EQ(IT::squared_quadruple_area(s[0], s[1], s[2]), from_squares);
    }
  });
}

// ---- angles

double sum_of(const Sides& s) { return s[0] + s[1] + s[2]; }

double angle(double ij, double jk, double ki) {
  return IT::corner_angle(std::sqrt(IT::squared_quadruple_area(ij, jk, ki)),
                          IT::twice_inner_product(ij, jk, ki));
}

TEST(Triangle_formulas, inner_product_from_squared_lengths_is_accurate_to_one_u) {
  std::mt19937_64 random(seed);
  double plain = 0;
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions / 4; ++n) {
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

TEST(Triangle_formulas, angle_from_squared_lengths_is_accurate_near_zero_and_pi) {
  std::mt19937_64 random(seed);
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions / 4; ++n) {
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

TEST(Triangle_formulas, angles_of_a_triangle_sum_to_pi) {
  std::mt19937_64 random(seed);
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions / 4; ++n) {
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

TEST(Triangle_formulas, closed_forms) {
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

TEST(Triangle_formulas, eccentric_needle_of_kahan_keeps_its_angles) {
  // sides 1, 1, 2^-50: apex 2 asin(2^-51), base angles acos(2^-51)
  const double w = 0x1p-50;
  EXPECT_DOUBLE_EQ(angle(1, w * w, 1), w);
  EXPECT_DOUBLE_EQ(angle(1, 1, w * w), std::acos(w / 2));
}

TEST(Triangle_formulas, curvature_of_known_vertices) {
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

TEST(Triangle_formulas, angle_defect_of_a_vertex_of_high_degree_is_accurate) {
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

// ---- diagonals

// A diamond with vertices at rational points of the plane: all values are rational.
struct Rational_diamond {
  IT::Diamond_values<Gmpq> values;
  Gmpq km;

  using Vertex = std::array<Gmpq, 2>;
  static Gmpq distance(const Vertex& p, const Vertex& q) {
    return square(p[0] - q[0]) + square(p[1] - q[1]);
  }
  static Gmpq twice_cross(const Vertex& p, const Vertex& q, const Vertex& r) {
    return Gmpq(2) * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
  }
  Rational_diamond(const Vertex& i, const Vertex& j, const Vertex& k, const Vertex& m)
      : values{distance(i, j), distance(j, k),       distance(k, i),      distance(i, m),
               distance(m, j), twice_cross(i, j, k), twice_cross(j, i, m)},
        km(distance(k, m)) {}
};

// The squared length of the diagonal by the course's Eq. 22, whose terms cancel on caps.
template <class FT>
FT squared_diagonal_by_eq_22(const IT::Diamond_values<FT>& d) {
  const FT sides = d.im + d.jk + d.mj + d.ki - d.ij;
  return (sides + ((d.im - d.mj) * (d.jk - d.ki) + d.area_f * d.area_g) / d.ij) / FT(2);
}

TEST(Triangle_formulas, all_forms_of_the_diagonal_agree_exactly) {
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<int> coordinate(1, 1000);
  const auto draw = [&] { return Gmpq(coordinate(random)); };
  for (int n = 0; n < repetitions; ++n) {
    const Rational_diamond d({Gmpq(0), draw()}, {Gmpq(2000), draw()}, {draw(), draw() + Gmpq(1000)},
                             {draw(), -draw()});
    ASSERT_GT(d.values.area_f, Gmpq(0));
    ASSERT_GT(d.values.area_g, Gmpq(0));
    EXPECT_EQ(squared_diagonal_by_eq_22(d.values), d.km);
    EXPECT_EQ(IT::flipped(d.values).km, d.km);
  }
}

TEST(Triangle_formulas, diagonal_of_two_caps_is_accurate_to_eight_u) {
  std::mt19937_64 random(seed);
  // ij is long, k and m are close to one point of it on both sides, at integer coordinates: all squared
  // lengths and areas are integers below 2^53, hence exact in doubles, but their products are not
  std::uniform_int_distribution<int> far(1 << 19, 1 << 20), near(-9, 9);
  const auto to_double = [](const Gmpq& q) {
    const double r = CGAL::to_double(q);
    EXPECT_EQ(Gmpq(r), q);
    return r;
  };
  double by_eq_22 = 0;
  int tested = 0;
  for (int n = 0; n < 20 * repetitions; ++n) {
    const int x = far(random), y = far(random);
    const auto draw = [&] {
      return Rational_diamond::Vertex{x / 3 + near(random), y / 3 + near(random)};
    };
    const Rational_diamond d({0, 0}, {x, y}, draw(), draw());
    if (d.values.area_f <= Gmpq(0) || d.values.area_g <= Gmpq(0)) continue;
    const IT::Diamond_values<double> v{to_double(d.values.ij),    to_double(d.values.jk),
                                       to_double(d.values.ki),    to_double(d.values.im),
                                       to_double(d.values.mj),    to_double(d.values.area_f),
                                       to_double(d.values.area_g)};
    // exact areas: 3 u per square, one for their sum, one for the quotient
    EXPECT_LE(error(IT::flipped(v).km, d.km), 8 * u);
    by_eq_22 = std::max(by_eq_22, error(squared_diagonal_by_eq_22(v), d.km));
    ++tested;
  }
  EXPECT_GT(tested, repetitions);
  EXPECT_GT(by_eq_22, 1e3 * u);
}

} // namespace
