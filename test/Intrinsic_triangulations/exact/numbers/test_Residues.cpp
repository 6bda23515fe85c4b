// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/numbers/Residues.h>

#include <CGAL/Intrinsic_triangulations/exact/numbers/Conjugate_bound.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Multiquadratic_number.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Proof_watch.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using CGAL::Gmpz;
using IT::Residues;

Gmpz random_integer(std::mt19937_64& random, unsigned words) {
  Gmpz result(0);
  for (unsigned n = 0; n < words; ++n)
    result = result * Gmpz(4294967296.0) + Gmpz(static_cast<unsigned long>(random() >> 32U));
  return random() % 2 == 0 ? result : -result;
}

TEST(Residues, are_images_of_rational_arithmetic) {
  std::mt19937_64 random(1);
  for (std::size_t n = 0; n < 5; ++n) {
    const IT::Residue_fields fields(n);
    for (int i = 0; i < 200; ++i) {
      const Gmpq x(random_integer(random, 5), random_integer(random, 3)),
          y(random_integer(random, 2), random_integer(random, 4));
      EXPECT_TRUE((Residues(x) + Residues(y) - Residues(x + y)).is_zero());
      EXPECT_TRUE((Residues(x) - Residues(y) - Residues(x - y)).is_zero());
      EXPECT_TRUE((Residues(x) * Residues(y) - Residues(x * y)).is_zero());
      EXPECT_TRUE((Residues(x) / Residues(y) - Residues(x / y)).is_zero());
      EXPECT_FALSE((Residues(x) - Residues(y)).is_zero());
      const double d = std::ldexp(static_cast<double>(random()) - 0x1p63,
                                  static_cast<int>(random() % 400) - 200);
      EXPECT_TRUE((Residues(d) - Residues(Gmpq(d))).is_zero());
    }
    EXPECT_TRUE(IT::Residue_fields::are_defined());
    Residues(0).inverse();
    EXPECT_FALSE(IT::Residue_fields::are_defined());
  }
}

TEST(Residues, have_all_square_roots_and_are_fields_with_them) {
  std::mt19937_64 random(2);
  const IT::Residue_fields fields(3);
  for (int i = 0; i < 200; ++i) {
    const Gmpz m = random_integer(random, 3), n = random_integer(random, 2);
    const Residues a = Residues::sqrt_of(m), b = Residues::sqrt_of(n);
    EXPECT_TRUE((a * a - Residues(m)).is_zero());
    const Residues product = a * b;
    EXPECT_TRUE((product * product - Residues(m * n)).is_zero());
    const Residues x = a + b + Residues(7);
    EXPECT_TRUE((x * x.inverse() - Residues(1)).is_zero());
  }
}

// the bound of a random polynomial in roots against the greatest of its conjugates
TEST(Conjugate_bound, exceeds_all_conjugates) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 300; ++i) {
    constexpr unsigned k = 5;
    std::vector<double> root;
    for (unsigned g = 0; g < k; ++g)
      root.push_back(std::sqrt(static_cast<double>(random() % 1000 + 2)));
    std::vector<std::vector<double>> values(1U << k); // of each choice of signs
    std::vector<IT::Conjugate_bound> bounds;
    for (std::uint32_t s = 0; s < values.size(); ++s)
      for (unsigned g = 0; g < k; ++g) values[s].push_back((s >> g & 1U) != 0 ? -root[g] : root[g]);
    for (unsigned g = 0; g < k; ++g) bounds.emplace_back(0, 0, std::log2(root[g]));
    for (int step = 0; step < 12; ++step) {
      const std::size_t a = random() % bounds.size(), b = random() % bounds.size();
      const auto operation = random() % 3;
      const auto apply = [&](const auto& x, const auto& y) {
        return operation == 0 ? x + y : operation == 1 ? x - y : x * y;
      };
      for (auto& v : values) v.push_back(apply(v[a], v[b]));
      bounds.push_back(apply(bounds[a], bounds[b]));
    }
    for (std::size_t n = 0; n < bounds.size(); ++n) {
      double greatest = 0;
      for (const auto& v : values) greatest = std::max(greatest, std::abs(v[n]));
      if (std::isfinite(greatest)) {
        EXPECT_GE(bounds[n].bits_of_integer(0), std::log2(greatest) - 1e-9);
      }
    }
  }
  EXPECT_EQ(IT::Conjugate_bound(0.375).bits_of_integer(0), 2); // 3 / 8 times 8, below 4
  EXPECT_THROW(IT::Conjugate_bound(1) / IT::Conjugate_bound(2), std::length_error);
}

TEST(Long_coefficients, end_when_coefficients_have_become_long) {
  IT::Square_class_basis basis;
  IT::Multiquadratic_number x(1);
  for (const int n : {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37}) {
    const auto root = basis.sqrt_of(Gmpq(n));
    x += IT::Multiquadratic_number(basis, *root);
  }
  basis.limit_products(1 << 20);
  EXPECT_THROW(
      {
        while (true) x *= x;
      },
      std::length_error);
}

TEST(Proof_watch, asks_and_ends) {
  int asked = 0;
  EXPECT_TRUE(IT::Proof_watch::goes_on());
  {
    const IT::Proof_watch watch([&asked] { return ++asked < 3; });
    while (IT::Proof_watch::goes_on()) {
    }
    EXPECT_TRUE(watch.is_stopped());
    EXPECT_EQ(asked, 3);
    {
      const IT::Proof_watch inner([] { return true; });
      EXPECT_TRUE(IT::Proof_watch::goes_on());
    }
    EXPECT_FALSE(IT::Proof_watch::goes_on());
  }
  EXPECT_TRUE(IT::Proof_watch::goes_on());
}

} // namespace
