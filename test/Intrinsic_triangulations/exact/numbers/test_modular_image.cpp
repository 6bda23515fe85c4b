// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/numbers/modular_image.h>

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using CGAL::Gmpz;

template <class>
class Modular_image : public ::testing::Test {};

template <std::size_t i>
using Prime = std::integral_constant<std::uint64_t, IT::modular_primes[i]>;
using Primes = ::testing::Types<Prime<0>, Prime<1>, Prime<2>, Prime<3>>;
TYPED_TEST_SUITE(Modular_image, Primes);

TYPED_TEST(Modular_image, roots_are_consistent) {
  using Image = IT::Modular_image<TypeParam::value>;
  IT::Square_class_basis basis;
  IT::Modular_roots<TypeParam::value> roots(basis);
  for (int a = 0; a < 40; ++a)
    for (int b = 0; b < 40; ++b) {
      const Image x = roots(*basis.sqrt_of(Gmpq(a))), y = roots(*basis.sqrt_of(Gmpq(b))),
                  z = roots(*basis.sqrt_of(Gmpq(a * b)));
      EXPECT_EQ(x * y, z);
      EXPECT_EQ(x * x, Image(a));
    }
}

TYPED_TEST(Modular_image, is_a_homomorphism_of_rationals) {
  using Image = IT::Modular_image<TypeParam::value>;
  std::mt19937_64 random(8);
  for (int i = 0; i < 200; ++i) {
    const auto rational = [&random] {
      return Gmpq(Gmpz(static_cast<long>(random())), Gmpz(1 + static_cast<long>(random() >> 1)));
    };
    const Gmpq x = rational(), y = rational();
    EXPECT_EQ(Image(x) + Image(y), Image(x + y)) << "seed 8, round " << i;
    EXPECT_EQ(Image(x) - Image(y), Image(x - y)) << "seed 8, round " << i;
    EXPECT_EQ(Image(x) * Image(y), Image(x * y)) << "seed 8, round " << i;
    EXPECT_EQ(Image(x) / Image(y), Image(x / y)) << "seed 8, round " << i;
    EXPECT_EQ(-Image(x), Image(-x)) << "seed 8, round " << i;
  }
  EXPECT_EQ(Image(-3), Image(Gmpq(-3)));
  EXPECT_EQ(Image(0.375), Image(3) / Image(8));
}

TYPED_TEST(Modular_image, divides_by_sums_of_roots) {
  using Image = IT::Modular_image<TypeParam::value>;
  IT::Square_class_basis basis;
  IT::Modular_roots<TypeParam::value> roots(basis);
  Image sum(1);
  for (int n = 2; n < 100; ++n) {
    sum += roots(*basis.sqrt_of(Gmpq(n)));
    ASSERT_TRUE(sum.is_proven_nonzero());
    EXPECT_EQ(sum * (Image(1) / sum), Image(1));
  }
}

TYPED_TEST(Modular_image, proves_that_sums_over_the_largest_basis_are_not_zero) {
  using Image = IT::Modular_image<TypeParam::value>;
  std::mt19937_64 random(9);
  IT::Square_class_basis basis;
  IT::Modular_roots<TypeParam::value> roots(basis);
  Image sum;
  std::vector<Image> terms;
  while (basis.dimension() < IT::Square_class_basis::max_dimension)
    terms.push_back(roots(*basis.sqrt_of(Gmpq(Gmpz(static_cast<long>(random() >> 2))))));
  for (const Image& t : terms) sum += t * t * t;
  EXPECT_TRUE(sum.is_proven_nonzero());
  for (const Image& t : terms) sum -= t * (t * t);
  EXPECT_FALSE(sum.is_proven_nonzero());
  EXPECT_TRUE(sum.is_defined());
}

TYPED_TEST(Modular_image, is_undefined_where_a_denominator_vanishes) {
  using Image = IT::Modular_image<TypeParam::value>;
  const Gmpq p(Gmpz(static_cast<long>(TypeParam::value)));
  const Image x(Gmpq(1) / p);
  EXPECT_FALSE(x.is_defined());
  EXPECT_FALSE((x * Image(0)).is_defined());
  EXPECT_FALSE((Image(1) / Image(p)).is_defined());
  EXPECT_FALSE((x - x).is_proven_nonzero());
  EXPECT_FALSE(Image(p).is_proven_nonzero());
  EXPECT_TRUE(Image(p).is_defined());
}

} // namespace
