// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/input/metric_scaling/triangle_inequality.h>

#include <CGAL/Gmpq.h>

#include "gallery.h"
#include "slivers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;

namespace {

bool satisfied_by_rationals(double a, double b, double c) {
  const Gmpq p = Gmpq(a) + Gmpq(c) - Gmpq(b);
  return Gmpq(4) * Gmpq(a) * Gmpq(c) >= p * p;
}

// in every order of the sides
void expect_as_rationals(double a, double b, double c) {
  const bool expected = satisfied_by_rationals(a, b, c);
  for (const auto& [x, y, z] : {slivers::Sides{a, b, c}, {b, c, a}, {c, a, b}, {a, c, b}})
    EXPECT_EQ(IT::squares_satisfy_triangle_inequality(x, y, z), expected)
        << a << ' ' << b << ' ' << c;
}

TEST(Triangle_inequality, of_squares_is_decided_to_the_last_bit) {
  EXPECT_TRUE(IT::squares_satisfy_triangle_inequality(1, 4, 9)); // 1 + 2 = 3
  EXPECT_FALSE(IT::squares_satisfy_triangle_inequality(1, 4, std::nextafter(9, 10)));
  EXPECT_FALSE(IT::squares_satisfy_triangle_inequality(1, std::nextafter(4, 3), 9));
  EXPECT_TRUE(IT::squares_satisfy_triangle_inequality(1, 4, std::nextafter(9, 8)));
  EXPECT_TRUE(IT::squares_satisfy_triangle_inequality(0, 5, 5));
  EXPECT_FALSE(IT::squares_satisfy_triangle_inequality(0, 5, std::nextafter(5, 6)));
  EXPECT_TRUE(IT::squares_satisfy_triangle_inequality(0, 0, 0));
  EXPECT_FALSE(IT::squares_satisfy_triangle_inequality(0, 0, 0x1p-1074));
}

TEST(Triangle_inequality, of_squares_is_that_of_rationals_on_random_and_nearly_flat_triangles) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  int satisfied = 0;
  for (int i = 0; i < 3000; ++i) {
    const double b = unit(random), c = unit(random) * std::pow(10, -20 * unit(random));
    double a = (b + c) * (b + c);
    if (i % 3 == 0) a = 4 * unit(random);
    if (i % 3 == 1) a = std::nextafter(a, random() % 2 != 0 ? 9 : 0);
    expect_as_rationals(a, b * b, c * c);
    satisfied += satisfied_by_rationals(a, b * b, c * c) ? 1 : 0;
  }
  EXPECT_GT(satisfied, 500);
  EXPECT_LT(satisfied, 2500);
}

TEST(Triangle_inequality, of_squares_holds_at_the_ends_of_the_range_of_doubles) {
  for (const double unit : {0x1p-1074, 0x1p-1022, 0x1p-540, 0x1p500, 0x1p1000}) {
    expect_as_rationals(unit, 4 * unit, 9 * unit);
    expect_as_rationals(unit, 4 * unit, 10 * unit);
    expect_as_rationals(unit, 4 * unit, 8 * unit);
  }
  expect_as_rationals(0x1p-1074, 0x1p1000, 0x1p1000);
  expect_as_rationals(0x1p-1074, 0x1p1000, std::nextafter(0x1p1000, 0));
}

TEST(Triangle_inequality, lists_the_faces_that_violate_it) {
  const gallery::Surface s = gallery::disc_fan(6);
  const IT::Gluing_map map(s.gluing);
  std::vector<double> l = gallery::squared_lengths(s);
  EXPECT_TRUE(IT::faces_violating_triangle_inequality(map, l).empty());
  const std::uint32_t spoke = map.sides({2})[0].index / 2; // between faces 1 and 2
  l[spoke] = 9;
  EXPECT_EQ(IT::faces_violating_triangle_inequality(map, l), (std::vector<std::uint32_t>{1, 2}));
}

} // namespace
