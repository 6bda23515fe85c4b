// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/numbers/Word_integer.h>
#include <CGAL/Intrinsic_triangulations/formulas/nonnegative_intervals.h>

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using CGAL::Gmpz;
using Interval = CGAL::Interval_nt<false>;

Gmpz integer(std::int64_t x) { return Gmpz(static_cast<long>(x)); }

TEST(Word_integer, Agrees_with_integers_of_variable_length) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 10000; ++i) {
    const auto next = [&] { return static_cast<std::int64_t>(random()) >> (random() % 64); };
    const std::int64_t x = next(), y = next(), z = next(), w = next();
    using Number = IT::Word_integer<4>;
    const Number a = Number(x) * Number(y) - Number(z) * Number(w);
    const Gmpz b = integer(x) * integer(y) - integer(z) * integer(w);
    EXPECT_EQ(a.sign(), static_cast<int>(b.sign()));
    const Number c = Number(z) + Number(y), m = a.magnitude(), n = c.magnitude();
    const Gmpz p = CGAL::abs(b), q = CGAL::abs(integer(z) + integer(y));
    EXPECT_EQ(is_less(m, n), p < q);
    // 2^5 (|a| |c|) - |c| (|c| + 32 |a|) + |c|^2 = 0, which carries across all words
    const auto left = full_product(m.shifted(5), n), right = full_product(n, n + m.shifted(5));
    EXPECT_TRUE((left - right + full_product(n, n)).is_zero());
    EXPECT_EQ((full_product(m, m) - full_product(n, n)).sign(),
              static_cast<int>((p * p - q * q).sign()));
  }
}

TEST(Nonnegative_intervals, Flips_contain_the_exact_values_and_are_as_narrow_as_in_general) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> value(0, 1), width(0, 0.125);
  const CGAL::Protect_FPU_rounding<true> upwards;
  for (int i = 0; i < 10000; ++i) {
    IT::Diamond_values<Interval> d;
    IT::Diamond_values<Gmpq> q;
    const auto set = [&](Interval& interval, Gmpq& inside, double least) {
      const double low = least + value(random);
      interval = Interval(low, low + width(random));
      inside = Gmpq(i % 2 == 0 ? interval.inf() : interval.sup());
    };
    set(d.ij, q.ij, 0.25), set(d.jk, q.jk, 0), set(d.ki, q.ki, 0), set(d.im, q.im, 0);
    set(d.mj, q.mj, 0), set(d.area_f, q.area_f, 0), set(d.area_g, q.area_g, 0);
    const IT::Flipped_values<Interval> fast = IT::flipped_nonnegative(d), slow = IT::flipped(d);
    const IT::Flipped_values<Gmpq> exact = IT::flipped(q);
    const auto check = [](const Interval& f, const Interval& s, const Gmpq& e) {
      EXPECT_TRUE(Gmpq(f.inf()) <= e && e <= Gmpq(f.sup()));
      EXPECT_LE(f.sup() - f.inf(), (s.sup() - s.inf()) * (1 + 0x1p-40) + 0x1p-45);
    };
    check(fast.km, slow.km, exact.km);
    check(fast.area_f, slow.area_f, exact.area_f);
    check(fast.area_g, slow.area_g, exact.area_g);
  }
}

} // namespace
