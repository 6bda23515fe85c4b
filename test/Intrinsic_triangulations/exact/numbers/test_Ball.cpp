// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>

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
using Interval = CGAL::Interval_nt<false>;

Interval interval(const Interval& x) { return x; }
template <class Center>
Interval interval(const IT::Ball<Center>& x) {
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

// (a + b) - a - b is zero, whatever the rounding; with c added at the end it is c, which shows if
// enough bits are kept
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

// Chains of rotations by rational angles: balls contain the exact complex number, and grow at most
// linearly.

template <class FT>
class Complex_ball_of : public testing::Test {};
using Numbers = testing::Types<Interval, IT::Ball<IT::Double_double>, IT::Ball<IT::Mpfr_number>>;
TYPED_TEST_SUITE(Complex_ball_of, Numbers);

template <class FT>
auto rounding() {
  return CGAL::Protect_FPU_rounding<true>(std::is_same_v<FT, Interval> ? CGAL_FE_UPWARD
                                                                       : CGAL_FE_TONEAREST);
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

using Short = IT::Ball<IT::Double_double>;
using Long = IT::Ball<IT::Mpfr_number>;

// high + low, where low is some part of a unit of high in the last place
template <class FT>
FT sum(double high, double low) {
  return FT(high) + FT(low);
}

bool is_nearest(double x, const Gmpq& exact) {
  const Gmpq error = CGAL::abs(Gmpq(x) - exact);
  return error <= CGAL::abs(Gmpq(std::nextafter(x, HUGE_VAL)) - exact) &&
         error <= CGAL::abs(Gmpq(std::nextafter(x, -HUGE_VAL)) - exact);
}

TEST(Nearest_double, is_the_same_for_all_numbers_and_nearest) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> mantissa(1, 2), part(-0.5, 0.5);
  std::uniform_int_distribution<int> exponent(-200, 200), sign(0, 1);
  for (int i = 0; i < 20000; ++i) {
    const int k = i % 50 == 0 ? 0 : exponent(random);
    const double high = (sign(random) != 0 ? 1 : -1) *
                        std::ldexp(i % 7 == 0 ? 1. : mantissa(random), k),
                 low = std::ldexp(part(random), k - 52);
    const Gmpq exact = Gmpq(high) + Gmpq(low);
    const auto a = IT::nearest_double(sum<Short>(high, low)),
               b = IT::nearest_double(sum<Long>(high, low));
    const IT::Mpfr_precision precision(4096);
    const auto c = IT::nearest_double(sum<Long>(high, low));
    ASSERT_TRUE(a && b && c);
    EXPECT_TRUE(is_nearest(*a, exact));
    EXPECT_EQ(*a, *b);
    EXPECT_EQ(*a, *c);
  }
}

TEST(Nearest_double, is_not_told_near_the_middle_nor_of_zero) {
  for (const double high : {1., 1.5, -3., 1e-30, 1e200}) {
    const double unit = std::nextafter(std::abs(high), HUGE_VAL) - std::abs(high);
    const Gmpq middle = Gmpq(high) + Gmpq(unit / 2);
    EXPECT_FALSE(IT::nearest_double(sum<Short>(high, unit / 2))) << high;
    EXPECT_FALSE(IT::nearest_double(sum<Long>(high, unit / 2))) << high;
    for (const double beside : {1 - 0x1p-40, 1 + 0x1p-40}) {
      const auto x = IT::nearest_double(sum<Short>(high, beside * unit / 2));
      ASSERT_TRUE(x) << high;
      EXPECT_EQ(CGAL::compare(Gmpq(*x), middle), beside > 1 ? CGAL::LARGER : CGAL::SMALLER);
    }
  }
  EXPECT_FALSE(IT::nearest_double(Short(0)));
  EXPECT_FALSE(IT::nearest_double(Short(1) / Short(0)));
  EXPECT_FALSE(IT::nearest_double(Short::around(IT::Double_double(1), 0x1p-53)));
  EXPECT_FALSE(IT::nearest_double(Short(1) / Short(3) * Short(3) - Short(1)));
}

TEST(Raise_precision, takes_doubles_pairs_of_doubles_and_powers_of_two_until_it_is_enough) {
  std::vector<unsigned> tried;
  const auto until = [&tried](unsigned enough) {
    return [&tried, enough](unsigned bits) {
      tried.push_back(bits);
      return bits >= enough;
    };
  };
  EXPECT_TRUE(IT::raise_precision(53, 4096, until(1000)));
  EXPECT_EQ(tried, (std::vector<unsigned>{53, 106, 256, 512, 1024}));
  tried.clear();
  EXPECT_FALSE(IT::narrow_enclosures(53, 4096, until(5000)));
  EXPECT_EQ(tried, (std::vector<unsigned>{53, 106, 256, 1024, 2048, 4096}));
}

} // namespace
