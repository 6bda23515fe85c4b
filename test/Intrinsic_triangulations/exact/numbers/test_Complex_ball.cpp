// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <type_traits>

// Chains of rotations by rational angles: balls must contain the exact complex number, and must not grow faster than linearly.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using Interval = CGAL::Interval_nt<false>;

template <class FT>
class Complex_ball_of : public testing::Test {};
using Numbers = testing::Types<Interval, IT::Ball<IT::Double_double>, IT::Ball<IT::Mpfr_number>>;
TYPED_TEST_SUITE(Complex_ball_of, Numbers);

template <class FT>
auto rounding() {
  return CGAL::Protect_FPU_rounding<true>(std::is_same_v<FT, Interval> ? CGAL_FE_UPWARD
                                                                       : CGAL_FE_TONEAREST);
}

Interval interval(const Interval& x) { return x; }
template <class Center>
Interval interval(const IT::Ball<Center>& x) {
  const CGAL::Protect_FPU_rounding<true> upwards;
  return x.interval();
}

double radius(const Interval& x) { return (x.sup() - x.inf()) / 2; }
template <class Center>
double radius(const IT::Ball<Center>& x) {
  return static_cast<double>(x.radius());
}

template <class FT>
double unit() {
  if constexpr (std::is_same_v<FT, Interval>)
    return 0x1p-52;
  else
    return std::is_same_v<FT, IT::Ball<IT::Double_double>> ? 0x1p-102 : 0x1p-254;
}

template <class FT>
void expect_contains(const FT& x, const Gmpq& exact) {
  const Interval i = interval(x);
  EXPECT_LE(Gmpq(i.inf()), exact);
  EXPECT_GE(Gmpq(i.sup()), exact);
}

TYPED_TEST(Complex_ball_of, contains_products_of_quotients) {
  const auto mode = rounding<TypeParam>();
  std::mt19937 random(1);
  const auto number = [&random] { return static_cast<double>(random() % 2001) - 1000; };
  for (int round = 0; round < 50; ++round) {
    IT::Complex_ball<TypeParam> z;
    Gmpq x = 1, y = 0;
    for (int step = 0; step < 20; ++step) {
      const double p = number(), q = number() + 0.5, d = 1 + std::abs(number());
      const IT::Complex_ball<TypeParam> w{TypeParam(p), TypeParam(q), TypeParam(d)};
      z = step % 2 == 0 ? z * w : -(z * w);
      const Gmpq r = (x * Gmpq(p) - y * Gmpq(q)) / Gmpq(d);
      y = (x * Gmpq(q) + y * Gmpq(p)) / Gmpq(d);
      x = r;
      if (step % 2 != 0) x = -x, y = -y;
      expect_contains(z.real(), x);
      expect_contains(z.imaginary(), y);
    }
  }
}

TYPED_TEST(Complex_ball_of, grows_linearly) {
  const auto mode = rounding<TypeParam>();
  const IT::Complex_ball<TypeParam> turn{TypeParam(3.), TypeParam(4.), TypeParam(5.)};
  IT::Complex_ball<TypeParam> z;
  const int n = 1000;
  for (int i = 0; i < n; ++i) z = z * turn;
  // a factor and a product have 3 units each; |x| + |y| is at most sqrt(2)
  EXPECT_LE(radius(z.real()), 6.1 * n * unit<TypeParam>() * std::sqrt(2.) + 0x1p-1050);
}

TYPED_TEST(Complex_ball_of, knows_nothing_of_what_underflows_or_is_divided_by_zero) {
  const auto mode = rounding<TypeParam>();
  IT::Complex_ball<TypeParam> z;
  const IT::Complex_ball<TypeParam> tiny{TypeParam(0x1p-500), TypeParam(0.), TypeParam(1.)};
  z = tiny * tiny;
  EXPECT_TRUE(std::isinf(interval(z.real()).sup()));
  const TypeParam around_zero = TypeParam(1.) - TypeParam(1.);
  const IT::Complex_ball<TypeParam> quotient{TypeParam(1.), TypeParam(1.), around_zero};
  EXPECT_TRUE(std::isinf(interval(quotient.imaginary()).sup()));
}

TYPED_TEST(Complex_ball_of, has_the_errors_of_its_parts) {
  const auto mode = rounding<TypeParam>();
  const TypeParam third = TypeParam(1.) / TypeParam(3.), seventh = TypeParam(1.) / TypeParam(7.);
  const IT::Complex_ball<TypeParam> z{third, seventh, TypeParam(3.) * third * third};
  expect_contains(z.real(), Gmpq(1));
  expect_contains(z.imaginary(), Gmpq(3) / Gmpq(7));
}

} // namespace
