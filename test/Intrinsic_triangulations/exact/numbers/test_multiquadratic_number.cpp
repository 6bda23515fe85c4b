// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/numbers/Multiquadratic_number.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>

#include "wide_numbers.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using wide_numbers::may_be_zero;
using wide_numbers::Wide;
using wide_numbers::wide;
using CGAL::Gmpz;
using Number = IT::Multiquadratic_number;

Number root(IT::Square_class_basis& basis, const Gmpq& x) { return {basis, *basis.sqrt_of(x)}; }

Gmpq random_rational(std::mt19937_64& random) {
  return Gmpq(static_cast<int>(random() % 2001) - 1000, 1 + static_cast<int>(random() % 60));
}

Number random_number(IT::Square_class_basis& basis, std::mt19937_64& random,
                     const std::vector<int>& radicands) {
  Number result(random_rational(random));
  for (std::size_t m = 1; m < (std::size_t(1) << radicands.size()); ++m) {
    Gmpq n(1);
    for (std::size_t i = 0; i < radicands.size(); ++i)
      if ((m >> i & 1U) != 0) n *= Gmpq(radicands[i]);
    result += Number(random_rational(random)) * root(basis, n);
  }
  return result;
}

class Precision_of_1000_bits : public ::testing::Test {
protected:
  IT::Mpfr_precision precision_{1000};
};
using Multiquadratic_number = Precision_of_1000_bits;

TEST_F(Multiquadratic_number, satisfies_identities_of_roots) {
  IT::Square_class_basis basis;
  const Number r2 = root(basis, Gmpq(2)), r3 = root(basis, Gmpq(3)), r6 = root(basis, Gmpq(6));
  EXPECT_EQ(r2 * r3, r6);
  EXPECT_EQ((r2 + r3) * (r2 + r3), 5 + 2 * r6);
  EXPECT_EQ(root(basis, Gmpq(1, 2)), r2 / 2);
  EXPECT_EQ(1 / (r2 + r3), r3 - r2);
  EXPECT_EQ(root(basis, Gmpq(18)) - 3 * r2, 0);
  EXPECT_EQ(r6 / r3 - r2, Number());
  EXPECT_FALSE((r2 + r3 - r6).is_zero());
  // 1 / (1 + sqrt 2 + sqrt 3) = (2 + sqrt 2 - sqrt 6) / 4
  EXPECT_EQ(1 / (1 + r2 + r3), (2 + r2 - r6) / 4);
}

TEST_F(Multiquadratic_number, satisfies_denestings) {
  IT::Square_class_basis basis;
  const Number r2 = root(basis, Gmpq(2)), r5 = root(basis, Gmpq(5)), r10 = root(basis, Gmpq(10));
  // sqrt(7 + 2 sqrt 10) = sqrt 2 + sqrt 5, and its inverse
  const Number nested = r2 + r5;
  EXPECT_EQ(nested * nested, 7 + 2 * r10);
  EXPECT_EQ(3 / nested, r5 - r2);
  // the golden ratio: g^2 = g + 1, and g^10 = 55 g + 34
  const Number g = (1 + r5) / 2;
  Number power(1);
  for (int i = 0; i < 10; ++i) power *= g;
  EXPECT_EQ(g * g, g + 1);
  EXPECT_EQ(power, 55 * g + 34);
}

TEST_F(Multiquadratic_number, is_a_rational_number_without_roots) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 300; ++i) {
    const Gmpq x = random_rational(random) * Gmpq(0x1p-70), y = random_rational(random);
    EXPECT_EQ((Number(x) + y).coefficient(0), x + y);
    EXPECT_EQ((Number(x) - y).coefficient(0), x - y);
    EXPECT_EQ((Number(x) * y).coefficient(0), x * y);
    EXPECT_EQ((-Number(x)).coefficient(0), -x);
    if (y.sign() != CGAL::ZERO) {
      EXPECT_EQ((Number(x) / y).coefficient(0), x / y);
    }
    EXPECT_TRUE((Number(x) * y).is_rational());
  }
  EXPECT_EQ(Number(0.1).coefficient(0), Gmpq(0.1));
}

TEST_F(Multiquadratic_number, times_its_inverse_is_one) {
  std::mt19937_64 random(5);
  const std::vector<int> all = {2, 3, 5, 7, 33};
  for (std::size_t k = 0; k <= all.size(); ++k)
    for (int i = 0; i < 10; ++i) {
      IT::Square_class_basis basis;
      const Number x = random_number(basis, random, {all.begin(), all.begin() + int(k)});
      if (x.is_zero()) continue;
      EXPECT_EQ(x * x.inverse(), 1) << "seed 5, k " << k;
      EXPECT_EQ(x.inverse().inverse(), x) << "seed 5, k " << k;
    }
}

TEST_F(Multiquadratic_number, inverse_uses_only_the_subfield_of_the_number) {
  IT::Square_class_basis basis;
  for (int p : {2, 3, 5, 7, 11}) root(basis, Gmpq(p));
  const Number x = root(basis, Gmpq(2 * 3 * 5)) + root(basis, Gmpq(5 * 7 * 11));
  EXPECT_EQ(x.inverse().number_of_terms(), 2U);
  EXPECT_EQ(x * x.inverse(), 1);
}

// The sum of 40 roots has 40 terms of 2^40 that are possible: its square takes 1600 products, not 3^40.
TEST_F(Multiquadratic_number, products_of_few_terms_take_few_steps) {
  IT::Square_class_basis basis;
  Number sum;
  int squares = 0;
  unsigned roots = 0;
  for (int p = 2; roots < 40; ++p) {
    bool is_prime = true;
    for (int q = 2; q * q <= p; ++q) is_prime = is_prime && p % q != 0;
    if (!is_prime) continue;
    sum += root(basis, Gmpq(p));
    squares += p;
    ++roots;
  }
  const Number square = sum * sum;
  EXPECT_EQ(square.number_of_terms(), 1 + 40U * 39 / 2);
  EXPECT_EQ(square.coefficient(0), Gmpq(squares));
  EXPECT_EQ(square.coefficient(3), Gmpq(2));
  EXPECT_EQ(square * sum, sum * square);
}

TEST_F(Multiquadratic_number, satisfies_the_laws_of_a_field) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 30; ++i) {
    IT::Square_class_basis basis;
    const Number x = random_number(basis, random, {2, 3, 7}),
                 y = random_number(basis, random, {6, 7}), z = random_number(basis, random, {3, 5});
    EXPECT_TRUE(((x + y) * z - x * z - y * z).is_zero()) << "seed 6, round " << i;
    EXPECT_TRUE((x * (y * z) - (x * y) * z).is_zero()) << "seed 6, round " << i;
    EXPECT_EQ(x * y, y * x) << "seed 6, round " << i;
    EXPECT_EQ((x / y) / z, x / (y * z)) << "seed 6, round " << i;
    EXPECT_EQ(x - y, -(y - x)) << "seed 6, round " << i;
  }
}

/*
Formulas in K and in intervals of 1000 bits. With t = c + sqrt(d), |c| <= 1000,
the value of t0 t1 - t2 t3 and its conjugates, at most 2^4 since only the classes of 2, 3, 5, 7 and
11 occur, four at a time, are below 2 * 1004^2 < 2^21. Times the denominators of the c, at most 60^4
< 2^24, it is an algebraic integer, whose norm is at least 1 if it is not zero. So the value is at
least 2^(-24 - 15 * 45) = 2^-699, while intervals are narrower than 2^-950: one that contains zero
proves zero.
*/
TEST_F(Multiquadratic_number, agrees_with_balls_on_zero) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 100; ++i) {
    IT::Square_class_basis basis;
    std::array<Number, 4> x;
    std::array<Wide, 4> v;
    for (std::size_t j = 0; j < 4; ++j) {
      const Gmpq c = random_rational(random), d(static_cast<int>(random() % 12));
      const IT::Square_root r = *basis.sqrt_of(d);
      x[j] = Number(c) + Number(basis, r);
      v[j] = wide(c) + sqrt(wide(d));
    }
    const auto nonzero = [](const auto& t) { return t[0] * t[1] - t[2] * t[3]; };
    const auto zero = [](const auto& t) {
      const auto s = t[0] + t[1], p = s * s - t[0] * t[0] - t[1] * t[1];
      return p * t[2] * t[3] - t[3] * t[0] * (t[1] * t[2] + t[2] * t[1]);
    };
    EXPECT_TRUE(zero(x).is_zero()) << "seed 7, round " << i;
    EXPECT_TRUE(may_be_zero(zero(v))) << "seed 7, round " << i;
    const Number n = nonzero(x);
    const Wide e = nonzero(v);
    EXPECT_EQ(n.is_zero(), may_be_zero(e)) << "seed 7, round " << i;
    EXPECT_TRUE(may_be_zero(wide(n) - e)) << "seed 7, round " << i;
  }
}

using Point = std::array<Gmpq, 3>;

Gmpq squared_distance(const Point& p, const Point& q) {
  Gmpq result(0);
  for (std::size_t k = 0; k < 3; ++k) result += (p[k] - q[k]) * (p[k] - q[k]);
  return result;
}

Gmpq squared_quadruple_area(const Point& p, const Point& q, const Point& r) {
  const Gmpq a = squared_distance(p, q), b = squared_distance(q, r), c = squared_distance(r, p);
  return Gmpq(4) * a * b - (a + b - c) * (a + b - c);
}

// a point of the circle of radius 5 around the origin in the plane of two vectors of one length
Point on_circle(const Point& u, const Point& v, const Gmpq& t) {
  const Gmpq s = Gmpq(1) + t * t;
  Point p;
  for (std::size_t k = 0; k < 3; ++k)
    p[k] = Gmpq(5) * ((Gmpq(1) - t * t) * u[k] + Gmpq(2) * t * v[k]) / s;
  return p;
}

template <class FT, class Root>
IT::Diamond_values<FT> diamond(const std::array<Point, 4>& p, const Root& quadruple_area) {
  const auto length = [&p](std::size_t a, std::size_t b) {
    return FT(squared_distance(p[a], p[b]));
  };
  return {length(0, 2),
          length(2, 3),
          length(3, 0),
          length(0, 1),
          length(1, 2),
          quadruple_area(squared_quadruple_area(p[0], p[2], p[3])),
          quadruple_area(squared_quadruple_area(p[0], p[1], p[2]))};
}

using Plane = std::array<Point, 2>;
const std::array<Plane, 4> planes = {
    Plane{Point{1, 0, 0}, Point{0, 1, 0}}, Plane{Point{1, -1, 0}, Point{1, 1, 0}},
    Plane{Point{2, 1, 2}, Point{-2, 2, 1}}, Plane{Point{3, 4, 0}, Point{0, 0, 5}}};

TEST_F(Multiquadratic_number, certifies_cocircular_quadrilaterals_before_and_after_a_flip) {
  for (const auto& [u, v] : planes) {
    IT::Square_class_basis basis;
    const std::array<Point, 4> p = {on_circle(u, v, Gmpq(-1, 3)), on_circle(u, v, Gmpq(1, 7)),
                                    on_circle(u, v, Gmpq(2)), on_circle(u, v, Gmpq(-5))};
    const auto d = diamond<Number>(p, [&](const Gmpq& x) { return root(basis, x); });
    EXPECT_TRUE(IT::Delaunay_expression()(d).is_zero());
    EXPECT_LE(basis.dimension(), 1U);
    const IT::Flipped_values<Number> f = IT::flipped(d);
    const IT::Diamond_values<Number> e = {f.km, d.mj, d.jk, d.ki, d.im, f.area_f, f.area_g};
    EXPECT_TRUE(IT::Delaunay_expression()(e).is_zero());
    EXPECT_EQ(f.km, Number(squared_distance(p[1], p[3])));
  }
}

TEST_F(Multiquadratic_number, certifies_a_tie_across_two_planes) {
  // on an octahedron: the angles are 60 degrees at a corner, 120 at the centre of the next face
  IT::Square_class_basis basis;
  const Gmpq third(1, 3);
  const std::array<Point, 4> p = {Point{1, 0, 0}, Point{third, third, -third}, Point{0, 1, 0},
                                  Point{0, 0, 1}};
  const auto d = diamond<Number>(p, [&](const Gmpq& x) { return root(basis, x); });
  EXPECT_TRUE(IT::Delaunay_expression()(d).is_zero());
  EXPECT_EQ(basis.dimension(), 1U);
}

TEST_F(Multiquadratic_number, certifies_a_tie_of_irrational_lengths) {
  IT::Square_class_basis basis;
  IT::Diamond_values<Number> d;
  d.ij = Number(4) + root(basis, Gmpq(5));
  d.jk = d.ki = d.ij / 2 + 1; // q_f = 2
  d.im = d.mj = d.ij / 2 - 2; // q_g = -4
  d.area_f = root(basis, Gmpq(3));
  d.area_g = root(basis, Gmpq(12));
  EXPECT_TRUE(IT::Delaunay_expression()(d).is_zero());
  d.mj += 0x1p-200;
  EXPECT_FALSE(IT::Delaunay_expression()(d).is_zero());
}

TEST_F(Multiquadratic_number, a_flip_and_its_reverse_restore_a_folded_diamond) {
  IT::Square_class_basis basis;
  const std::array<Point, 4> p = {Point{0, 0, 0}, Point{1, -2, 1}, Point{3, 0, 0}, Point{1, 3, 1}};
  const auto d = diamond<Number>(p, [&](const Gmpq& x) { return root(basis, x); });
  EXPECT_EQ(basis.dimension(), 2U);
  const IT::Flipped_values<Number> f = IT::flipped(d);
  EXPECT_FALSE(f.km.is_rational());
  const IT::Flipped_values<Number> back =
      IT::flipped(IT::Diamond_values<Number>{f.km, d.mj, d.jk, d.ki, d.im, f.area_f, f.area_g});
  EXPECT_EQ(back.km, d.ij);
  EXPECT_EQ(back.area_f, d.area_g);
  EXPECT_EQ(back.area_g, d.area_f);
}

TEST_F(Multiquadratic_number, refuses_a_quadrilateral_that_misses_a_circle_by_little) {
  const auto& [u, v] = planes[0];
  std::array<Point, 4> p = {on_circle(u, v, Gmpq(-1, 3)), on_circle(u, v, Gmpq(1, 7)),
                            on_circle(u, v, Gmpq(2)), on_circle(u, v, Gmpq(-5))};
  p[1][2] += Gmpq(0x1p-300);
  IT::Square_class_basis basis;
  const auto d = diamond<Number>(p, [&](const Gmpq& x) { return root(basis, x); });
  EXPECT_FALSE(IT::Delaunay_expression()(d).is_zero());
}

} // namespace
