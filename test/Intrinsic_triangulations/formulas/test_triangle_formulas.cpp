// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>

#include "slivers.h"
#include "wide_numbers.h"

#include <CGAL/CORE_Expr.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using wide_numbers::may_be_zero;
using wide_numbers::Wide;
using wide_numbers::wide;
using namespace slivers;
using Point = std::array<double, 3>;

constexpr int repetitions = 200;

// What the formulas replace: each must be seen to fail, or the tests would not tell them apart.
double textbook_heron(const Sides& l) {
  const double s = (l[0] + l[1] + l[2]) / 2;
  return 4 * std::sqrt(std::max(0.0, s * (s - l[0]) * (s - l[1]) * (s - l[2])));
}
double plain_squared_area(const Sides& L) {
  const double p = L[0] + L[2] - L[1];
  return 4 * L[0] * L[2] - p * p;
}
double plain_cross_product(const Point& p, const Point& q, const Point& r) {
  const Point v{q[0] - p[0], q[1] - p[1], q[2] - p[2]}, w{r[0] - p[0], r[1] - p[1], r[2] - p[2]};
  return 2 * std::sqrt(CGAL::square(v[1] * w[2] - v[2] * w[1]) +
                       CGAL::square(v[2] * w[0] - v[0] * w[2]) +
                       CGAL::square(v[0] * w[1] - v[1] * w[0]));
}

Gmpq exact_d_from_points(const Point& p, const Point& q, const Point& r) {
  Gmpq pq(0), qr(0), rp(0);
  for (unsigned c = 0; c < 3; ++c) {
    pq += square(Gmpq(p[c]) - Gmpq(q[c]));
    qr += square(Gmpq(q[c]) - Gmpq(r[c]));
    rp += square(Gmpq(r[c]) - Gmpq(p[c]));
  }
  return exact_d(pq, qr, rp);
}

TEST(Triangle_formulas, triangle_inequality_is_decided_exactly_in_doubles) {
  std::mt19937_64 random(seed);
  int violated = 0;
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions; ++n) {
      Sides s = draw_lengths(shape, width, random);
      const auto longest = std::max_element(s.begin(), s.end());
      double sum = 0;
      for (const double& x : s) sum += &x == &*longest ? 0 : x;
      for (int step = -2; step <= 2; ++step) { // ulps around equality
        *longest = sum * (1 + step * 2 * u);
        const std::array<Gmpq, 3> q{Gmpq(s[0]), Gmpq(s[1]), Gmpq(s[2])};
        const bool expected = q[0] + q[1] >= q[2] && q[1] + q[2] >= q[0] && q[2] + q[0] >= q[1];
        violated += expected ? 0 : 1;
        EXPECT_EQ(IT::satisfies_triangle_inequality(s[0], s[1], s[2]), expected);
        EXPECT_EQ(IT::satisfies_triangle_inequality(q[0], q[1], q[2]), expected);
      }
    }
  });
  EXPECT_GT(violated, 1000);
}

TEST(Triangle_formulas, triangle_inequality_of_other_cases) {
  EXPECT_TRUE(IT::satisfies_triangle_inequality(3.0, 4.0, 5.0));
  EXPECT_TRUE(IT::satisfies_triangle_inequality(1.0, 2.0, 3.0));
  EXPECT_FALSE(IT::satisfies_triangle_inequality(1.0, 2.0, 3.0000001));
  EXPECT_FALSE(IT::satisfies_triangle_inequality(-1.0, 2.0, 2.0));
  EXPECT_FALSE(IT::satisfies_triangle_inequality(std::nan(""), 2.0, 2.0));
  using Interval = CGAL::Interval_nt<>;
  const Interval about_three(2.9, 3.1);
  EXPECT_TRUE(CGAL::is_indeterminate(
      IT::satisfies_triangle_inequality(Interval(1), Interval(2), about_three)));
  EXPECT_TRUE(
      CGAL::certainly(IT::satisfies_triangle_inequality(Interval(2), Interval(2), about_three)));
}

TEST(Triangle_formulas, squared_area_from_squared_lengths_is_accurate_to_two_u) {
  std::mt19937_64 random(seed);
  double plain = 0;
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions; ++n) {
      const Sides s = draw_squares(shape, width, random);
      const Gmpq d = exact_d_from_squares(s);
      Sides sorted = s;
      std::sort(sorted.begin(), sorted.end());
      // two roundings of the final sums, and those of the lost parts: see the bound documented
      const double bound = 2 * u + 20 * u * u * 4 * sorted[0] * sorted[1] / CGAL::to_double(d);
      EXPECT_LE(error(IT::squared_quadruple_area(s[0], s[1], s[2]), d), bound);
      // roots halve the error and add one rounding, u
      EXPECT_LE(root_error(IT::quadruple_area_from_squared_lengths(s[0], s[1], s[2]), d),
                u + bound / 2);
      plain = std::max(plain, error(plain_squared_area(s), d));
      EXPECT_EQ(IT::squared_quadruple_area(Gmpq(s[0]), Gmpq(s[1]), Gmpq(s[2])), d);
    }
  });
  EXPECT_GT(plain, 1e3); // no digit is right
}

TEST(Triangle_formulas, area_from_lengths_is_accurate_to_six_u) {
  std::mt19937_64 random(seed);
  double textbook = 0;
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions; ++n) {
      const Sides s = draw_lengths(shape, width, random);
      const Gmpq d = exact_d_from_lengths(s);
      // nine roundings under the root, which halves them, and its own: 5.5 u
      EXPECT_LE(root_error(IT::quadruple_area_from_lengths(s[0], s[1], s[2]), d), 6 * u);
      textbook = std::max(textbook, root_error(textbook_heron(s), d));
    }
  });
  EXPECT_GT(textbook, 0.1);
}

TEST(Triangle_formulas, area_from_points_is_accurate_to_seven_u) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  double plain = 0;
  for_each_shape([&](Shape shape, double width) {
    for (int n = 0; n < repetitions; ++n) {
      std::array<Point, 3> x;
      const double along = shape == Shape::cap ? 0.5 + 0.1 * unit(random) : 1;
      const double across = shape == Shape::random ? 1 : width;
      for (unsigned c = 0; c < 3; ++c) {
        x[0][c] = unit(random);
        x[1][c] = x[0][c] + unit(random);
        x[2][c] = x[0][c] + along * (x[1][c] - x[0][c]) + across * unit(random);
      }
      const Gmpq d = exact_d_from_points(x[0], x[1], x[2]);
      if (CGAL::to_double(d) < 1e-40) continue; // drawn collinear; far below all others
      // 3 u per component, 9 u for the sum of squares, 5.5 u for the root; u^2 over the sine of
      // the angle between the short sides, at least 1e-15 / 4, times the 16 roundings of the parts
      EXPECT_LE(root_error(IT::quadruple_area_from_points<double>(x[0], x[1], x[2]), d), 7 * u)
          << "width " << width;
      plain = std::max(plain, root_error(plain_cross_product(x[0], x[1], x[2]), d));
    }
  });
  EXPECT_GT(plain, 1e-3);
}

TEST(Triangle_formulas, integer_triangles_are_exact_in_every_number_type) {
  for (const auto& s : {std::array<int, 4>{3, 4, 5, 24}, std::array<int, 4>{5, 12, 13, 120},
                        std::array<int, 4>{13, 14, 15, 336}, std::array<int, 4>{3, 25, 26, 144}}) {
    const auto check = [&]<class FT>(const FT&) {
      const auto x = static_cast<FT>(s[0]), y = static_cast<FT>(s[1]), z = static_cast<FT>(s[2]),
                 area = static_cast<FT>(s[3]);
      EXPECT_EQ(IT::quadruple_area_from_lengths(y, z, x), area);
      EXPECT_EQ(IT::quadruple_area_from_squared_lengths(FT(z * z), FT(x * x), FT(y * y)), area);
    };
    check(0.0F);
    check(0.0);
    check(0.0L);
    check(CORE::Expr(0));
    EXPECT_EQ(IT::squared_quadruple_area(Gmpq(s[0] * s[0]), Gmpq(s[1] * s[1]), Gmpq(s[2] * s[2])),
              Gmpq(s[3] * s[3]));
  }
}

TEST(Triangle_formulas, equilateral_triangle_in_exact_roots) {
  const CORE::Expr two(2);
  EXPECT_EQ(IT::quadruple_area_from_lengths(two, two, two),
            CORE::Expr(4) * CGAL::sqrt(CORE::Expr(3)));
  EXPECT_NEAR(IT::quadruple_area_from_lengths(2.0, 2.0, 2.0), 4 * std::sqrt(3.0), 8 * u * 7);
}

TEST(Triangle_formulas, intervals_enclose_the_area) {
  std::mt19937_64 random(seed);
  using Interval = CGAL::Interval_nt<>;
  for_each_shape([&](Shape shape, double width) {
    const Sides s = draw_squares(shape, width, random);
    const Gmpq d = exact_d_from_squares(s);
    const Interval x(s[0]), y(s[1]), z(s[2]);
    const Interval squared = IT::squared_quadruple_area(x, y, z);
    EXPECT_LE(Gmpq(squared.inf()), d);
    EXPECT_GE(Gmpq(squared.sup()), d);
    const Interval root = IT::quadruple_area_from_squared_lengths(x, y, z);
    EXPECT_LE(square(Gmpq(root.inf())), d);
    EXPECT_GE(square(Gmpq(root.sup())), d);
    const std::array<Interval, 3> p{0, 0, 0}, q{s[0], 0, 0}, r{0, width, 0};
    EXPECT_TRUE(IT::quadruple_area_from_points<Interval>(p, q, r).do_overlap(2 * s[0] * width));
    // lengths: sorted by midpoints, so that needles enclose tightly: under 16 roundings outwards
    const Sides l = draw_lengths(shape, width, random);
    const Interval heron =
        IT::quadruple_area_from_lengths(Interval(l[0]), Interval(l[1]), Interval(l[2]));
    EXPECT_LE(square(Gmpq(heron.inf())), exact_d_from_lengths(l));
    EXPECT_GE(square(Gmpq(heron.sup())), exact_d_from_lengths(l));
    EXPECT_LE(heron.sup() - heron.inf(), 32 * u * heron.sup());
  });
}

TEST(Triangle_formulas, balls_of_256_bits_enclose_the_area) {
  const Wide d = IT::squared_quadruple_area(Wide(1.0), Wide(1.0), Wide(0x1p-90));
  EXPECT_TRUE(may_be_zero(d - wide(exact_d_from_squares({1.0, 1.0, 0x1p-90}))));
  EXPECT_FALSE(may_be_zero(d));
}

TEST(Triangle_formulas, points_of_a_kernel_are_accepted) {
  const CGAL::Simple_cartesian<double>::Point_3 p(0, 0, 0), q(3, 0, 0), r(0, 4, 0);
  EXPECT_EQ(IT::quadruple_area_from_points<double>(p, q, r), 24);
  EXPECT_EQ(IT::quadruple_area_from_points<CORE::Expr>(p, q, r), CORE::Expr(24));
}

TEST(Triangle_formulas, degenerate_triangles_have_no_area) {
  EXPECT_EQ(IT::quadruple_area_from_lengths(1.0, 2.0, 3.0), 0);
  EXPECT_EQ(IT::quadruple_area_from_lengths(1.0, 1.0, 0.0), 0);
  EXPECT_EQ(IT::squared_quadruple_area(1.0, 9.0, 4.0), 0);
  EXPECT_EQ(IT::quadruple_area_from_squared_lengths(1.0, 1.0, 0.0), 0);
  // collinear points whose squared lengths are rounded: zero or tiny, never not-a-number
  const double l = 0.1, m = 0.7, n = l + m;
  const double a = IT::quadruple_area_from_squared_lengths(l * l, m * m, n * n);
  EXPECT_LE(a, 1e-7); // sqrt(u) times the sides
  EXPECT_GE(a, 0);
}

TEST(Triangle_formulas, powers_of_two_scale_exactly) {
  std::mt19937_64 random(seed);
  for_each_shape([&](Shape shape, double width) {
    const Sides l = draw_lengths(shape, width, random), s = draw_squares(shape, width, random);
    for (const int e : {-100, -1, 3, 120}) {
      const double f = std::ldexp(1.0, e), ff = f * f;
      EXPECT_EQ(IT::quadruple_area_from_lengths(f * l[0], f * l[1], f * l[2]),
                ff * IT::quadruple_area_from_lengths(l[0], l[1], l[2]));
      EXPECT_EQ(IT::quadruple_area_from_squared_lengths(ff * s[0], ff * s[1], ff * s[2]),
                ff * IT::quadruple_area_from_squared_lengths(s[0], s[1], s[2]));
    }
  });
}

TEST(Triangle_formulas, order_of_the_sides_does_not_matter) {
  std::mt19937_64 random(seed);
  for_each_shape([&](Shape shape, double width) {
    Sides l = draw_lengths(shape, width, random), s = draw_squares(shape, width, random);
    const double from_lengths = IT::quadruple_area_from_lengths(l[0], l[1], l[2]);
    const double from_squares = IT::squared_quadruple_area(s[0], s[1], s[2]);
    for (int n = 0; n < 6; ++n) {
      l = rotated(l);
      s = rotated(s);
      if (n == 2) {
        std::swap(l[0], l[1]);
        std::swap(s[0], s[1]);
      }
      EXPECT_EQ(IT::quadruple_area_from_lengths(l[0], l[1], l[2]), from_lengths);
      EXPECT_EQ(IT::squared_quadruple_area(s[0], s[1], s[2]), from_squares);
    }
  });
}

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

#if CGAL_PRECONDITIONS_ENABLED
TEST(Triangle_formulas, violated_triangle_inequality_is_refused) {
  EXPECT_THROW(IT::quadruple_area_from_lengths(1.0, 1.0, 3.0), CGAL::Precondition_exception);
  EXPECT_THROW(IT::quadruple_area_from_squared_lengths(1.0, 1.0, 9.0),
               CGAL::Precondition_exception);
}
#endif

} // namespace
