// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/local_coordinates.h>

#include "slivers.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using namespace slivers;
using Vector = IT::Planar_vector<double>;
using Triangle = IT::Planar_triangle<double>;
using Coordinates = std::array<double, 3>;

constexpr int repetitions = 50;

template <class FT>
FT squared_distance(const IT::Planar_vector<FT>& p, const IT::Planar_vector<FT>& q) {
  return (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]);
}

IT::Planar_vector<Gmpq> exact(const Vector& v) { return {Gmpq(v[0]), Gmpq(v[1])}; }
IT::Planar_triangle<Gmpq> exact(const Triangle& f) {
  return {exact(f[0]), exact(f[1]), exact(f[2])};
}

// The largest relative error of three coordinates.
double error_of(const Coordinates& b, const std::array<Gmpq, 3>& expected) {
  double result = 0;
  for (unsigned c = 0; c < 3; ++c)
    if (expected[c] != Gmpq(0)) result = std::max(result, error(b[c], expected[c]));
  return result;
}

// What the area ratios replace: rounded differences and products.
Coordinates plain_area_ratios(const Triangle& f, const Vector& p) {
  const auto cross = [](const Vector& a, const Vector& b, const Vector& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  };
  const double area = cross(f[0], f[1], f[2]);
  return {cross(f[1], f[2], p) / area, cross(f[2], f[0], p) / area, cross(f[0], f[1], p) / area};
}

// A counterclockwise triangle somewhere in the plane, with doubles as coordinates.
Triangle draw_triangle(Shape shape, double width, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  while (true) {
    const double along = shape == Shape::needle ? 1 : 0.5 + 0.3 * unit(random);
    const double across = shape == Shape::random ? 1 : width;
    Triangle f{{{unit(random), unit(random)}, {}, {}}};
    for (unsigned c = 0; c < 2; ++c) {
      f[1][c] = f[0][c] + 1 + unit(random);
      f[2][c] = f[0][c] + along * (f[1][c] - f[0][c]) + across * unit(random);
    }
    const IT::Planar_triangle<Gmpq> q = exact(f);
    const Gmpq area =
        (q[1][0] - q[0][0]) * (q[2][1] - q[0][1]) - (q[1][1] - q[0][1]) * (q[2][0] - q[0][0]);
    // not much thinner than meant, so that second order terms stay below u
    if (CGAL::to_double(area) > 0.05 * width * width * (shape == Shape::random ? 0 : 1) &&
        CGAL::to_double(area) > 1e-15)
      return f;
  }
}

TEST(Local_coordinates, layout_of_known_triangles) {
  // 3-4-5 on each of its sides
  const Triangle right = IT::planar_layout(9.0, 25.0, 16.0, 24.0);
  EXPECT_EQ(right, (Triangle{{{0, 0}, {3, 0}, {0, 4}}}));
  EXPECT_EQ(IT::planar_layout_from_lengths(3.0, 5.0, 4.0), right);
  // obtuse at i: k is to the left of i, where Eq. 26 needs its negative root
  EXPECT_EQ(IT::planar_layout(81.0, 289.0, 100.0, 144.0), (Triangle{{{0, 0}, {9, 0}, {-6, 8}}}));
  EXPECT_EQ(IT::planar_layout_from_lengths(9.0, 17.0, 10.0), (Triangle{{{0, 0}, {9, 0}, {-6, 8}}}));
  const IT::Diamond_values<double> d{9, 25, 16, 16, 25, 24, 24};
  const auto kite = IT::planar_layout(d);
  EXPECT_EQ(kite, (std::array<Vector, 4>{{{0, 0}, {3, 0}, {0, 4}, {0, -4}}}));
}

TEST(Local_coordinates, layout_coordinates_are_accurate) {
  std::mt19937_64 random(seed);
  double by_eq_26 = 0;
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions; ++n) {
      const Sides l = draw_lengths(shape, width, random);
      const Gmpq d = exact_d_from_lengths(l), p = exact_p_from_lengths(l);
      const Gmpq two_l = Gmpq(2) * Gmpq(l[0]);
      const Triangle f = IT::planar_layout_from_lengths(l[0], l[1], l[2]);
      EXPECT_EQ(f[1][0], l[0]);
      // the area's 6 u and a quotient
      EXPECT_LE(root_error(f[2][1], d / square(two_l)), 7 * u);
      // the inner product's 4 u (|p| + y^2) and a quotient
      const double scale = std::abs(CGAL::to_double(p)) + std::pow(std::min(l[0], l[2]), 2);
      EXPECT_LE(std::abs(CGAL::to_double(Gmpq(f[2][0]) - p / two_l)), 6 * u * scale / (2 * l[0]));
      const double h = f[2][1];
      const double x = std::sqrt(std::max(0.0, l[2] * l[2] - h * h));
      by_eq_26 = std::max(by_eq_26, std::abs(x - std::abs(f[2][0])) * 2 * l[0] / scale);
    }
  });
  EXPECT_GT(by_eq_26, 1e3 * u); // near right angles
}

TEST(Local_coordinates, layout_from_squared_lengths_is_accurate) {
  std::mt19937_64 random(seed);
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions; ++n) {
      const Sides s = draw_squares(shape, width, random);
      const Gmpq d = exact_d_from_squares(s), p = exact_p_from_squares(s);
      const double a = IT::quadruple_area_from_squared_lengths(s[0], s[1], s[2]);
      const Triangle f = IT::planar_layout(s[0], s[1], s[2], a);
      EXPECT_LE(root_error(f[1][0], Gmpq(s[0])), u * (1 + u));
      EXPECT_LE(root_error(f[2][1], d / (Gmpq(4) * Gmpq(s[0]))), root_error(a, d) + 3 * u);
      if (p == Gmpq(0)) continue;
      const double lost = 4 * u * u * (s[0] + s[1] + s[2]) / std::abs(CGAL::to_double(p));
      EXPECT_LE(root_error(std::abs(f[2][0]), square(p) / (Gmpq(4) * Gmpq(s[0]))), 4 * u + lost);
    }
  });
}

TEST(Local_coordinates, diamond_layout_has_the_diagonal_of_the_flip) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0.8, 1.2);
  for (int n = 0; n < repetitions; ++n) {
    IT::Diamond_values<double> d{
        unit(random), unit(random), unit(random), unit(random), unit(random), 0, 0};
    d.area_f = IT::quadruple_area_from_squared_lengths(d.ij, d.jk, d.ki);
    d.area_g = IT::quadruple_area_from_squared_lengths(d.ij, d.mj, d.im);
    const auto f = IT::planar_layout(d);
    // well-shaped and near one: each of some twenty operations adds at most a few u
    EXPECT_NEAR(squared_distance(f[2], f[3]), IT::flipped(d).km, 64 * u);
    EXPECT_NEAR(squared_distance(f[1], f[3]), d.mj, 64 * u);
    EXPECT_NEAR(squared_distance(f[0], f[3]), d.im, 64 * u);
    EXPECT_NEAR(squared_distance(f[1], f[2]), d.jk, 64 * u);
  }
}

TEST(Local_coordinates, area_ratios_are_accurate_coordinate_by_coordinate) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  double plain = 0;
  for_each_shape([&](Shape shape, double width) {
    if (width < 1e-12) return; // second order terms then exceed u
    for (int n = 0; n < repetitions; ++n) {
      const Triangle f = draw_triangle(shape, width, random);
      const Vector p{f[0][0] + unit(random), f[0][1] + unit(random)};
      const auto expected = IT::barycentric_coordinates_of_point(exact(f), exact(p));
      ASSERT_EQ(expected[0] + expected[1] + expected[2], Gmpq(1));
      // 3 u per cross product and one for the quotient
      EXPECT_LE(error_of(IT::barycentric_coordinates_of_point(f, p), expected), 8 * u);
      const auto expected_vector = IT::barycentric_coordinates_of_vector(exact(f), exact(p));
      ASSERT_EQ(expected_vector[0] + expected_vector[1] + expected_vector[2], Gmpq(0));
      EXPECT_LE(error_of(IT::barycentric_coordinates_of_vector(f, p), expected_vector), 8 * u);
      plain = std::max(plain, error_of(plain_area_ratios(f, p), expected));
    }
  });
  EXPECT_GT(plain, 1e-5);
}

TEST(Local_coordinates, solve_the_linear_system_of_the_corners) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions; ++n) {
      const auto f = exact(draw_triangle(shape, width, random));
      const auto p = exact(Vector{unit(random), unit(random)});
      const auto check = [&](const std::array<Gmpq, 3>& b, int sum) {
        EXPECT_EQ(b[0] * f[0][0] + b[1] * f[1][0] + b[2] * f[2][0], p[0]);
        EXPECT_EQ(b[0] * f[0][1] + b[1] * f[1][1] + b[2] * f[2][1], p[1]);
        EXPECT_EQ(b[0] + b[1] + b[2], Gmpq(sum));
      };
      check(IT::barycentric_coordinates_of_point(f, p), 1);
      check(IT::barycentric_coordinates_of_vector(f, p), 0);
    }
  });
}

TEST(Local_coordinates, corners_have_unit_coordinates) {
  std::mt19937_64 random(seed);
  for_each_shape([&](Shape shape, double width) {
    const Triangle f = draw_triangle(shape, width, random);
    for (unsigned c = 0; c < 3; ++c) {
      Coordinates unit{0, 0, 0};
      unit[c] = 1;
      EXPECT_EQ(IT::barycentric_coordinates_of_point(exact(f), exact(f[c])),
                (std::array<Gmpq, 3>{Gmpq(unit[0]), Gmpq(unit[1]), Gmpq(unit[2])}));
      const Coordinates b = IT::barycentric_coordinates_of_point(f, f[c]);
      for (unsigned k = 0; k < 3; ++k) EXPECT_NEAR(b[k], unit[k], 8 * u);
    }
  });
}

TEST(Local_coordinates, axis_layout_has_the_lengths_of_the_sides) {
  const std::array<double, 3> d = IT::axis_layout(25.0, 41.0, 34.0); // d = 3, 4, 5
  EXPECT_EQ(d, (std::array<double, 3>{3, 4, 5}));
  const Coordinates b{0.25, 0.5, 0.25};
  EXPECT_EQ(IT::axis_coordinates(d, b), (Coordinates{0.75, 2, 1.25}));
  EXPECT_EQ(IT::barycentric_from_axis_coordinates(d, Coordinates{0.75, 2, 1.25}), b);
  // vectors, too: the norm of D w is that of w in the triangle
  const Coordinates w{1, -3, 2}, x = IT::axis_coordinates(d, w);
  EXPECT_EQ(x[0] * x[0] + x[1] * x[1] + x[2] * x[2], 9.0 + 9 * 16 + 4 * 25);
  EXPECT_EQ(25.0 * 3 + 41 * 6 - 34 * 2, 9.0 + 9 * 16 + 4 * 25); // Eq. 23
  // a right angle lies at the origin
  EXPECT_EQ(IT::axis_layout(9.0, 25.0, 16.0)[0], 0);
}

TEST(Local_coordinates, axis_layout_is_accurate_on_acute_needles) {
  // isosceles, the base 10^-k: d_j^2 = d_k^2 = L_jk / 2 is lost in L_ij + L_ki
  for (int k = 1; k <= 15; ++k) {
    const double L = std::pow(10.0, -2 * k);
    const std::array<double, 3> d = IT::axis_layout(1.0, L, 1.0);
    EXPECT_LE(root_error(d[1], Gmpq(L) / Gmpq(2)), 2 * u);
    EXPECT_LE(root_error(d[2], Gmpq(L) / Gmpq(2)), 2 * u);
    EXPECT_LE(root_error(d[0], Gmpq(1) - Gmpq(L) / Gmpq(2)), 2 * u);
  }
}

TEST(Local_coordinates, intervals_enclose) {
  using Interval = CGAL::Interval_nt<>;
  std::mt19937_64 random(seed);
  const Triangle f = draw_triangle(Shape::random, 1, random);
  IT::Planar_triangle<Interval> wide;
  for (unsigned v = 0; v < 3; ++v) wide[v] = {Interval(f[v][0]), Interval(f[v][1])};
  const Vector p{0.25, 0.125};
  const auto expected = IT::barycentric_coordinates_of_point(exact(f), exact(p));
  const IT::Planar_vector<Interval> q{Interval(p[0]), Interval(p[1])};
  const auto ratios = IT::barycentric_coordinates_of_point(wide, q);
  for (unsigned c = 0; c < 3; ++c)
    EXPECT_TRUE(Gmpq(ratios[c].inf()) <= expected[c] && expected[c] <= Gmpq(ratios[c].sup()));
}

#if CGAL_PRECONDITIONS_ENABLED
TEST(Local_coordinates, impossible_requests_are_refused) {
  EXPECT_THROW(IT::axis_layout(1.0, 3.0, 1.0), CGAL::Precondition_exception); // obtuse
  EXPECT_THROW(IT::planar_layout(0.0, 1.0, 1.0, 0.0), CGAL::Precondition_exception);
  const Triangle flat{{{0, 0}, {1, 1}, {2, 2}}};
  EXPECT_THROW(IT::barycentric_coordinates_of_point(flat, Vector{1, 0}),
               CGAL::Precondition_exception);
}
#endif

} // namespace
