// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/lengths/Length_chain.h>

#include <gtest/gtest.h>

#include <CGAL/Gmpq.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace {

namespace internal = CGAL::Intrinsic_triangulations::internal;
using CGAL::Gmpq;
using internal::are_identical;
using internal::Length_chain;

// Folds of a sheet of paper at vertical lines: a step to the right by the square root of `square`,
// and up by `rise`. Coordinates of a link are a multiple of the root, and a rational.
Length_chain::Link step(int square, const Gmpq& rise) { return {square, {1, 0}, {rise, 1}}; }

// Squarefree numbers, whose roots depend on each other only where they are equal.
std::vector<int> primes(std::size_t count) {
  std::vector<int> result;
  for (int n = 2; result.size() < count; ++n) {
    bool is_prime = true;
    for (const int p : result) is_prime = is_prime && n % p != 0;
    if (is_prime) result.push_back(n);
  }
  return result;
}

// The length across sheets of many widths: (sum of the roots)^2 + (sum of the steps)^2.
TEST(LengthChain, addsHundredsOfRoots) {
  std::mt19937 random(1);
  Length_chain a{3, {}}, b{3, {}};
  for (const int p : primes(200)) {
    const int rise = static_cast<int>(random() % 9);
    a.links.push_back(step(p, rise));
    // in two parts, of a third and two thirds
    b.links.push_back({p, {1, 0}, {Gmpq(rise, 2), Gmpq(1, 3)}});
    b.links.push_back({4 * p, {1, 0}, {Gmpq(rise, 2), Gmpq(1, 3)}});
  }
  EXPECT_TRUE(are_identical(a, b));
  EXPECT_TRUE(are_identical(a, b.reversed()));
  EXPECT_TRUE(are_identical(a.reversed(), b));
  b.links[100].shift.x += Gmpq(1, 1 << 20);
  EXPECT_FALSE(are_identical(a, b));
  EXPECT_FALSE(are_identical(a, b.reversed()));
}

// |1 + sqrt(2)|^2 = 3 + 2 sqrt(2), which no chain of one rational number is.
TEST(LengthChain, distinguishesRootsFromRationals) {
  const Length_chain sum{1, {{1, {1, 0}, {0, 1}}, {2, {1, 0}, {0, 1}}}};
  EXPECT_TRUE(are_identical(sum, {1, {{2, {1, 0}, {0, 1}}, {1, {1, 0}, {0, 1}}}}));
  EXPECT_FALSE(are_identical(sum, {1, {{1, {1, 0}, {3, 0}}}}));
  // sqrt(8) = 2 sqrt(2), and a square root of 9 is rational
  const Length_chain same{1, {{8, {1, 0}, {0, Gmpq(1, 2)}}, {9, {1, 0}, {0, Gmpq(1, 3)}}}};
  EXPECT_TRUE(are_identical(sum, same));
}

/*
A strip of random triangles with rational sides, and the same strip where each triangle is divided
at the middle of the side that it is entered over, which leaves the length from the first corner to
the last apex as it is. A divided triangle is crossed by two halves, with half of its area each.
*/
TEST(LengthChain, isThatOfDividedTriangles) {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    std::mt19937 random(seed);
    const auto number = [&] { return Gmpq(1 + static_cast<int>(random() % 97), 64); };
    Length_chain whole{number(), {}}, divided{whole.unit, {}};
    for (const int square : primes(15)) {
      const internal::Plane_number apex{number(), number()};
      // on to a side at the apex, from 0 or from 1
      if (random() % 2 == 0) {
        whole.links.push_back({square, apex, {0, 0}});
        // the half at 0, in which the middle is 1, is twice as large
        divided.links.push_back({square, {Gmpq(1, 2), 0}, {0, 0}});
        divided.links.push_back({4 * square, {2 * apex.x, apex.y}, {0, 0}});
      } else {
        const internal::Plane_number from_end{apex.x - 1, apex.y};
        whole.links.push_back({square, from_end, {1, 0}});
        divided.links.push_back({9 * square, {Gmpq(1, 2), 0}, {Gmpq(1, 2), 0}});
        divided.links.push_back({square, {2 * from_end.x, 2 * from_end.y}, {1, 0}});
      }
    }
    const Length_chain::Link apex{number(), {1, 0}, {number(), number()}};
    for (Length_chain* c : {&whole, &divided}) c->links.push_back(apex);
    EXPECT_TRUE(are_identical(whole, divided)) << "seed " << seed;
    EXPECT_TRUE(are_identical(divided.reversed(), whole)) << "seed " << seed;
    divided.links.back().shift.y += Gmpq(1, 64);
    EXPECT_FALSE(are_identical(whole, divided)) << "seed " << seed;
  }
}

} // namespace
