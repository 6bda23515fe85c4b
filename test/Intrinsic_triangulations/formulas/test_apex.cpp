// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/apex.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <gtest/gtest.h>

#include <random>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using Point = IT::Plane_vector<Gmpq>;

Gmpq squared_distance(const Point& p, const Point& q) { return dot(q - p, q - p); }

// Draws three points, counterclockwise.
template <class Random>
std::array<Point, 3> draw(Random& random) {
  std::uniform_int_distribution<int> coordinate(-1000, 1000);
  std::array<Point, 3> p;
  do {
    for (Point& q : p) q = {Gmpq(coordinate(random)), Gmpq(coordinate(random))};
  } while (cross(p[1] - p[0], p[2] - p[0]) <= Gmpq(0));
  return p;
}

TEST(Apex, places_the_third_corner_in_any_field) {
  std::mt19937 random(1);
  for (int n = 0; n < 200; ++n) {
    const auto [i, j, k] = draw(random);
    const Gmpq ij = squared_distance(i, j), jk = squared_distance(j, k),
               ki = squared_distance(k, i), area = Gmpq(2) * cross(j - i, k - i);
    const Point apex = IT::apex(ij, jk, ki, area);
    EXPECT_EQ(i + (j - i) * apex, k);
    EXPECT_EQ(IT::scaled_corner(ij, jk, ki, area), Gmpq(2) * in_frame(j - i, k - i));
    const auto number = [](const Gmpq& x) { return CGAL::to_double(x); };
    const auto rounded = IT::apex(number(ij), number(jk), number(ki), number(area));
    EXPECT_DOUBLE_EQ(rounded.x, number(apex.x));
    EXPECT_DOUBLE_EQ(rounded.y, number(apex.y));
    using Interval = CGAL::Interval_nt<>;
    const auto enclosed = IT::apex(Interval(number(ij)), Interval(number(jk)), Interval(number(ki)),
                                   Interval(number(area)));
    EXPECT_LE(Gmpq(enclosed.x.inf()), apex.x);
    EXPECT_GE(Gmpq(enclosed.x.sup()), apex.x);
    EXPECT_LE(Gmpq(enclosed.y.inf()), apex.y);
    EXPECT_GE(Gmpq(enclosed.y.sup()), apex.y);
  }
}

TEST(Plane_vector, is_read_by_name_and_by_number) {
  IT::Plane_vector<double> v{3, 4};
  v[1] = 5;
  EXPECT_EQ(v, (IT::Plane_vector<double>{3, 5}));
  EXPECT_EQ(v[0], v.x);
  EXPECT_EQ(2. * v - v / 1., v);
}

} // namespace
