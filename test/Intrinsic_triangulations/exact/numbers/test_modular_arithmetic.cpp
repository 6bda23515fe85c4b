// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/numbers/modular_arithmetic.h>

#include <gtest/gtest.h>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

TEST(Modular_arithmetic, agrees_with_trial_division_on_small_numbers) {
  for (std::uint64_t n = 0; n < 5000; ++n) {
    bool expected = n > 1;
    for (std::uint64_t d = 2; d * d <= n; ++d) expected = expected && n % d != 0;
    EXPECT_EQ(IT::is_prime(n), expected) << n;
  }
}

TEST(Modular_arithmetic, refuses_strong_pseudoprimes) {
  EXPECT_FALSE(IT::is_prime(2047));                 // to base 2
  EXPECT_FALSE(IT::is_prime(3215031751U));          // to bases 2, 3, 5, 7
  EXPECT_FALSE(IT::is_prime(3825123056546413051U)); // to bases 2 to 23
  EXPECT_TRUE(IT::is_prime(2147483647U));
  EXPECT_TRUE(IT::is_prime(18446744073709551557U)); // the largest below 2^64
}

TEST(Modular_arithmetic, satisfies_fermats_little_theorem_near_two_to_the_64) {
  constexpr std::uint64_t p = 18446744073709551557U;
  for (std::uint64_t a = p - 20; a < p; ++a) {
    EXPECT_EQ(IT::power_modulo(a, p - 1, p), 1U);
    EXPECT_EQ(IT::product_modulo(a, IT::power_modulo(a, p - 2, p), p), 1U);
  }
}

} // namespace
