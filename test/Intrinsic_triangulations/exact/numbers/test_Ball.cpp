// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

// Every ball must contain the exact rational result of the same operations.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;

template <class Center>
CGAL::Interval_nt<false> interval(const IT::Ball<Center>& x) {
  const CGAL::Protect_FPU_rounding<true> upwards;
  return x.interval();
}

template <class Center>
class Ball_of : public testing::Test {};
using Centers = testing::Types<IT::Double_double, IT::Mpfr_number>;
TYPED_TEST_SUITE(Ball_of, Centers);

double random_double(std::mt19937& random) {
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-30, 30);
  return std::ldexp(mantissa(random), exponent(random));
}

TYPED_TEST(Ball_of, contains_what_rational_numbers_give) {
  std::mt19937 random(1);
  std::size_t certain = 0;
  for (int round = 0; round < 2000; ++round) {
    const double first = random_double(random);
    IT::Ball<TypeParam> x(first);
    Gmpq exact(first);
    for (int step = 0; step < 12; ++step) {
      const double d = random_double(random);
      const IT::Ball<TypeParam> y(d);
      switch (random() % 5) {
      case 0:
        x = x + y, exact = exact + Gmpq(d);
        break;
      case 1:
        x = x - y, exact = exact - Gmpq(d);
        break;
      case 2:
        x = x * y, exact = exact * Gmpq(d);
        break;
      case 3:
        x = x / y, exact = exact / Gmpq(d);
        break;
      default:
        x = square(x), exact = exact * exact;
      }
    }
    const auto i = interval(x);
    if (!(i.sup() < std::numeric_limits<double>::infinity())) continue;
    EXPECT_LE(Gmpq(i.inf()), exact);
    EXPECT_GE(Gmpq(i.sup()), exact);
    const CGAL::Uncertain<CGAL::Sign> s = x.sign();
    if (!CGAL::is_certain(s)) continue;
    ++certain;
    EXPECT_EQ(CGAL::get_certain(s), CGAL::sign(exact));
  }
  EXPECT_GT(certain, 1900U);
}

// (a + b) - a - b is zero, whatever was lost; with c added at the end it is c, which shows if enough bits are kept
TYPED_TEST(Ball_of, keeps_its_bits_through_cancellation) {
  for (const int bits : {40, 60, 90, 110, 200, 240}) {
    const double small = std::ldexp(1.0, -bits);
    const IT::Ball<TypeParam> third = IT::Ball<TypeParam>(1.0) / IT::Ball<TypeParam>(3.0);
    const IT::Ball<TypeParam> x = (third + IT::Ball<TypeParam>(small)) - third;
    const bool is_seen = CGAL::is_certain(x.sign());
    EXPECT_EQ(is_seen, bits < (std::is_same_v<TypeParam, IT::Double_double> ? 95 : 250)) << bits;
    EXPECT_TRUE(!is_seen || CGAL::get_certain(x.sign()) == CGAL::POSITIVE);
  }
}

TYPED_TEST(Ball_of, takes_roots_that_square_back) {
  std::mt19937 random(2);
  for (int round = 0; round < 1000; ++round) {
    const IT::Ball<TypeParam> x(std::abs(random_double(random)));
    const IT::Ball<TypeParam> rest = square(sqrt(x)) - x;
    EXPECT_FALSE(CGAL::is_certain(rest.sign())); // zero is inside
    const auto i = interval(rest), whole = interval(x);
    EXPECT_LE(i.sup() - i.inf(), whole.sup() * 0x1p-95);
  }
  const auto zero = interval(sqrt(IT::Ball<TypeParam>(0.0)));
  EXPECT_LE(zero.inf(), 0);
  EXPECT_GE(zero.sup(), 0);
}

TYPED_TEST(Ball_of, is_sure_of_nothing_where_numbers_overflow_or_divisors_may_be_zero) {
  const IT::Ball<TypeParam> large(1e200), third = IT::Ball<TypeParam>(1.0) / 3.0;
  const IT::Ball<TypeParam> maybe_zero = third + third + third - IT::Ball<TypeParam>(1.0);
  EXPECT_FALSE(CGAL::is_certain((IT::Ball<TypeParam>(1.0) / maybe_zero).sign()));
  EXPECT_FALSE(CGAL::is_certain((IT::Ball<TypeParam>(1.0) / IT::Ball<TypeParam>(0.0)).sign()));
  const IT::Ball<TypeParam> product = large * large * large;
  const auto i = interval(product);
  EXPECT_TRUE(!(i.sup() < std::numeric_limits<double>::infinity()) || i.inf() > 1e300);
}

TYPED_TEST(Ball_of, tells_exact_zero_from_what_only_may_be) {
  EXPECT_TRUE(CGAL::certainly(IT::Ball<TypeParam>(0.0).sign() == CGAL::ZERO));
  const IT::Ball<TypeParam> third = IT::Ball<TypeParam>(1.0) / 3.0;
  EXPECT_FALSE(CGAL::is_certain((third + third + third - IT::Ball<TypeParam>(1.0)).sign()));
  EXPECT_TRUE(CGAL::certainly((third - IT::Ball<TypeParam>(0.25)).sign() == CGAL::POSITIVE));
}

// as above
TEST(Ball, keeps_as_many_bits_as_the_precision_of_the_thread_says) {
  const auto is_seen = [](double small) {
    IT::Ball<IT::Mpfr_number> x(1);
    for (const double d : {small, -1.0}) x = x + d;
    return CGAL::is_certain(x.sign());
  };
  EXPECT_TRUE(is_seen(0x1p-240));
  EXPECT_FALSE(is_seen(0x1p-260));
  const IT::Mpfr_precision wide(1024);
  EXPECT_TRUE(is_seen(0x1p-1000));
  {
    const IT::Ball<IT::Mpfr_number> fine = IT::Ball<IT::Mpfr_number>(1) + 0x1p-1000;
    const IT::Mpfr_precision narrow(64);
    EXPECT_FALSE(is_seen(0x1p-100));
    IT::Ball<IT::Mpfr_number> copy(0);
    copy = fine; // as it is
    EXPECT_TRUE(copy.is_identical(fine));
  }
  EXPECT_TRUE(is_seen(0x1p-1000));
}

} // namespace
