// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/numbers/Gaussian_residue.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using CGAL::Gmpz;
using Image = IT::Gaussian_residue;

// each test in four fields
class Gaussian_residue : public ::testing::TestWithParam<std::size_t> {
protected:
  const IT::Prime_field& field() { return fields_[GetParam()]; }
  Gmpq prime() { return Gmpq(Gmpz(static_cast<unsigned long>(field().size()))); }

private:
  IT::Prime_fields fields_;
};
INSTANTIATE_TEST_SUITE_P(Primes, Gaussian_residue, ::testing::Range<std::size_t>(0, 4));

TEST_P(Gaussian_residue, roots_are_consistent) {
  const IT::Residue_scope scope(field());
  IT::Square_class_basis basis;
  const auto roots = [&basis](const IT::Square_root& r) { return Image(basis, r); };
  for (int a = 0; a < 40; ++a)
    for (int b = 0; b < 40; ++b) {
      const Image x = roots(*basis.sqrt_of(Gmpq(a))), y = roots(*basis.sqrt_of(Gmpq(b))),
                  z = roots(*basis.sqrt_of(Gmpq(a * b)));
      EXPECT_EQ(x * y, z);
      EXPECT_EQ(x * x, Image(a));
    }
}

TEST_P(Gaussian_residue, is_a_homomorphism_of_rationals) {
  const IT::Residue_scope scope(field());
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

TEST_P(Gaussian_residue, divides_by_sums_of_roots) {
  const IT::Residue_scope scope(field());
  IT::Square_class_basis basis;
  const auto roots = [&basis](const IT::Square_root& r) { return Image(basis, r); };
  Image sum(1);
  for (int n = 2; n < 100; ++n) {
    sum = sum + roots(*basis.sqrt_of(Gmpq(n)));
    ASSERT_FALSE(sum.is_zero());
    EXPECT_EQ(sum * (Image(1) / sum), Image(1));
  }
}

TEST_P(Gaussian_residue, proves_that_sums_over_the_largest_basis_are_not_zero) {
  const IT::Residue_scope scope(field());
  std::mt19937_64 random(9);
  IT::Square_class_basis basis;
  const auto roots = [&basis](const IT::Square_root& r) { return Image(basis, r); };
  Image sum(0);
  std::vector<Image> terms;
  while (basis.dimension() < IT::Square_class_basis::max_dimension)
    terms.push_back(roots(*basis.sqrt_of(Gmpq(Gmpz(static_cast<long>(random() >> 2))))));
  for (const Image& t : terms) sum = sum + t * t * t;
  EXPECT_FALSE(sum.is_zero());
  for (const Image& t : terms) sum = sum - t * (t * t);
  EXPECT_TRUE(sum.is_zero());
  EXPECT_TRUE(scope.is_defined());
}

TEST_P(Gaussian_residue, is_undefined_where_a_denominator_vanishes) {
  const Gmpq p = prime();
  const auto is_defined = [this](const auto& compute) {
    const IT::Residue_scope scope(field());
    compute();
    return scope.is_defined();
  };
  EXPECT_FALSE(is_defined([&] { Image(Gmpq(1) / p); }));
  EXPECT_FALSE(is_defined([&] { Image(Gmpq(1) / p) * Image(0); }));
  EXPECT_FALSE(is_defined([&] { Image(1) / Image(p); }));
  EXPECT_TRUE(is_defined([&] { EXPECT_TRUE(Image(p).is_zero()); }));
  EXPECT_TRUE(is_defined([&] { Image(1) / Image(3); }));
}

TEST_P(Gaussian_residue, belongs_to_the_field_of_the_innermost_scope) {
  IT::Prime_fields others;
  const IT::Residue_scope outer(field());
  {
    const IT::Residue_scope inner(others[GetParam() + 1]);
    EXPECT_FALSE(Image(prime()).is_zero());
    EXPECT_TRUE((Image(1) / Image(0)).is_zero());
    EXPECT_FALSE(inner.is_defined());
  }
  EXPECT_TRUE(Image(prime()).is_zero());
  EXPECT_TRUE(outer.is_defined());
}

} // namespace
