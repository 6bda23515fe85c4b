// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.h>

#include <gtest/gtest.h>

#include <initializer_list>
#include <random>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using CGAL::Gmpz;

// factor^2 times the product of the representatives must be x
::testing::AssertionResult is_root_of(const IT::Square_class_basis& basis,
                                      const std::optional<IT::Square_root>& root, const Gmpq& x) {
  if (!root) return ::testing::AssertionFailure() << "no root";
  if (root->factor.sign() == CGAL::NEGATIVE) return ::testing::AssertionFailure() << "negative";
  if (root->factor * root->factor * Gmpq(basis.product(root->radical)) != x)
    return ::testing::AssertionFailure() << "wrong square";
  return ::testing::AssertionSuccess();
}

Gmpz random_integer(std::mt19937_64& random, int words) {
  Gmpz result(0);
  for (int i = 0; i < words; ++i) result = (result << 60L) + Gmpz(static_cast<long>(random() >> 4));
  return result + 1;
}

TEST(Square_class_basis, squares_need_no_representative) {
  IT::Square_class_basis basis;
  for (const Gmpq& x : {Gmpq(0), Gmpq(1), Gmpq(4), Gmpq(9, 16), Gmpq(1000003) * Gmpq(1000003)}) {
    const auto root = basis.sqrt_of(x);
    EXPECT_TRUE(is_root_of(basis, root, x));
    EXPECT_EQ(root->radical, 0U);
  }
  EXPECT_EQ(basis.dimension(), 0U);
}

TEST(Square_class_basis, reduces_products_of_classes) {
  for (const std::initializer_list<int>& order :
       {std::initializer_list<int>{2, 3, 6, 12, 18}, {6, 2, 3, 18, 12}, {12, 18, 6, 3, 2}}) {
    IT::Square_class_basis basis;
    for (const int n : order) EXPECT_TRUE(is_root_of(basis, basis.sqrt_of(Gmpq(n)), Gmpq(n)));
    EXPECT_TRUE(is_root_of(basis, basis.sqrt_of(Gmpq(1, 2)), Gmpq(1, 2)));
    EXPECT_EQ(basis.dimension(), 2U);
  }
}

TEST(Square_class_basis, finds_the_rank_of_random_products_of_primes) {
  std::mt19937_64 random(1);
  constexpr int primes[] = {2, 3, 5, 7, 11, 13, 37, 41, 43, 1009};
  for (int round = 0; round < 50; ++round) {
    IT::Square_class_basis basis;
    std::vector<unsigned> echelon; // independent elimination on exponents
    for (int i = 0; i < 14; ++i) {
      const unsigned exponents = static_cast<unsigned>(random() & random() & 1023U);
      Gmpq x(random_integer(random, 2), random_integer(random, 1));
      x *= x;
      for (unsigned p = 0; p < 10; ++p)
        if ((exponents >> p & 1U) != 0) x *= p % 2 == 0 ? Gmpq(primes[p]) : Gmpq(1, primes[p]);
      EXPECT_TRUE(is_root_of(basis, basis.sqrt_of(x), x)) << "seed 1, round " << round;
      unsigned rest = exponents;
      for (const unsigned row : echelon) rest = std::min(rest, rest ^ row);
      if (rest != 0) echelon.push_back(rest);
      EXPECT_EQ(basis.dimension(), echelon.size()) << "seed 1, round " << round;
    }
  }
}

TEST(Square_class_basis, handles_numbers_of_hundreds_of_bits) {
  std::mt19937_64 random(2);
  IT::Square_class_basis basis;
  for (int i = 0; i < 10; ++i) {
    const Gmpq d(random_integer(random, 4)),
        s(random_integer(random, 2), random_integer(random, 1));
    const auto first = basis.sqrt_of(d);
    ASSERT_TRUE(is_root_of(basis, first, d));
    const auto second = basis.sqrt_of(d * s * s);
    ASSERT_TRUE(is_root_of(basis, second, d * s * s));
    EXPECT_EQ(first->radical, second->radical);
    EXPECT_EQ(second->factor, first->factor * s);
  }
  EXPECT_EQ(basis.dimension(), 10U);
}

TEST(Square_class_basis, is_right_for_multiples_of_the_primes_of_its_symbols) {
  IT::Square_class_basis basis;
  // the primes tried first, where Legendre symbols vanish
  const Gmpq p(2147483647), q(2147483629);
  for (const Gmpq& x : {Gmpq(2), p, p * Gmpq(2), p * p * Gmpq(2), q, p * q, p * p * p * q * Gmpq(8),
                        Gmpq(3) * q, Gmpq(6) * p, Gmpq(3) / p})
    EXPECT_TRUE(is_root_of(basis, basis.sqrt_of(x), x));
  EXPECT_EQ(basis.dimension(), 4U); // 2, p, q, 3
}

TEST(Square_class_basis, roots_stay_valid_while_it_grows) {
  IT::Square_class_basis basis;
  const auto root = basis.sqrt_of(Gmpq(6));
  for (int n = 2; n < 60; ++n) ASSERT_TRUE(basis.sqrt_of(Gmpq(n)).has_value());
  EXPECT_TRUE(is_root_of(basis, root, Gmpq(6)));
}

TEST(Square_class_basis, is_full_at_its_largest_dimension_and_still_answers) {
  std::mt19937_64 random(3);
  IT::Square_class_basis basis;
  std::vector<Gmpq> numbers;
  while (basis.dimension() < IT::Square_class_basis::max_dimension) {
    numbers.emplace_back(random_integer(random, 3));
    ASSERT_TRUE(is_root_of(basis, basis.sqrt_of(numbers.back()), numbers.back()));
  }
  EXPECT_FALSE(basis.sqrt_of(Gmpq(random_integer(random, 3))).has_value());
  const Gmpq x = numbers[3] * numbers[17] * numbers[63] * numbers[120] * Gmpq(25, 7) * Gmpq(7);
  EXPECT_TRUE(is_root_of(basis, basis.sqrt_of(x), x));
  EXPECT_EQ(basis.dimension(), IT::Square_class_basis::max_dimension);
}

} // namespace
