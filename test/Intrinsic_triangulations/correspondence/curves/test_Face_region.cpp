// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/curves/Face_region.h>

#include "curve_patterns.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <set>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using curve_patterns::for_each_pattern;
using IT::Corner_coordinates;
using IT::Face_region;
using Normals = std::array<IT::Normal_coordinate, 3>;

/// A place in a face: behind `passed` of the curves about `corner`, or if that is the corner of the
/// fan (or nobody's), left of `passed` of its curves; perhaps on the next curve.
struct Place {
  unsigned corner;
  int passed;
  bool is_on;
};

template <class Function>
void for_each_place(const Corner_coordinates& c, Function f) {
  unsigned fan = 3;
  for (unsigned k = 0; k < 3; ++k)
    if (c.emanating[k] > 0) fan = k;
  for (unsigned k = 0; k < 3; ++k)
    for (int i = 0; i < c.cutting[k]; ++i)
      for (const bool on : {false, true}) f(Place{k, i, on}, fan);
  if (fan == 3)
    f(Place{3, 0, false}, fan);
  else
    for (int i = 0; i <= c.emanating[fan]; ++i) {
      f(Place{fan, i, false}, fan);
      if (i < c.emanating[fan]) f(Place{fan, i, true}, fan);
    }
}

/// How a segment from each corner to the place is crossed: counted curve by curve.
Normals counted(const Corner_coordinates& c, const Place& p, unsigned fan) {
  Normals n{0, 0, 0};
  for (unsigned k = 0; k < 3; ++k)
    for (int i = 0; i < c.cutting[k]; ++i) {
      const bool is_here = p.corner == k && k != fan;
      if (is_here && p.is_on && i == p.passed) continue;
      const bool is_near = is_here && i >= p.passed; // the place is on the side of the corner
      for (unsigned from = 0; from < 3; ++from) n[from] += (from == k) != is_near ? 1 : 0;
    }
  if (fan == 3) return n;
  // the curves of the fan have the corner after it on their right, the other one on their left
  const unsigned right = (fan + 1) % 3, left = (fan + 2) % 3;
  for (int i = 0; i < c.emanating[fan]; ++i) {
    if (p.corner == fan && p.is_on && i == p.passed) continue;
    const bool is_left = p.corner == fan ? i < p.passed : p.corner == left;
    ++n[is_left ? right : left];
  }
  if (p.corner == fan && p.is_on) n[fan] = -1;
  return n;
}

/// On which side of a curve a place is.
CGAL::Sign side(const Corner_coordinates& c, const Place& p, unsigned fan, unsigned k, int i) {
  const auto compared = [&] {
    return i < p.passed ? CGAL::POSITIVE : i == p.passed && p.is_on ? CGAL::ZERO : CGAL::NEGATIVE;
  };
  if (fan < 3 && k == (fan + 1) % 3 && i >= c.cutting[k]) {
    i -= c.cutting[k];
    if (p.corner == fan) return compared();
    return p.corner == (fan + 2) % 3 ? CGAL::POSITIVE : CGAL::NEGATIVE;
  }
  return p.corner == k && k != fan ? compared() : CGAL::POSITIVE;
}

TEST(Face_region, Is_found_for_every_place_in_every_pattern) {
  for_each_pattern(3, [](const Corner_coordinates& c) {
    for_each_place(c, [&](const Place& p, unsigned fan) {
      const Face_region r = IT::find_region(c, {10, 20, 30}, [&](const IT::Curve_crossing& x) {
        return side(c, p, fan, x.halfedge / 10 - 1, x.position);
      });
      EXPECT_EQ(r.fan_corner, fan);
      EXPECT_EQ(r.is_on_curve, p.is_on);
      EXPECT_EQ(IT::inserted_normal_coordinates(c, r), counted(c, p, fan));
    });
  });
}

TEST(Face_region, Belongs_to_just_those_normal_coordinates_that_a_place_has) {
  for_each_pattern(2, [](const Corner_coordinates& c) {
    std::array<std::set<Normals>, 2> possible;
    for_each_place(c, [&](const Place& p, unsigned fan) {
      possible[p.is_on ? 1 : 0].insert(counted(c, p, fan));
    });
    for (int a = -1; a <= 9; ++a)
      for (int b = -1; b <= 9; ++b)
        for (int d = -1; d <= 9; ++d)
          for (const bool on : {false, true}) {
            const Normals n{a, b, d};
            ASSERT_EQ(IT::has_region(c, n, on), possible[on ? 1 : 0].contains(n))
                << a << ' ' << b << ' ' << d << ' ' << on << ": " << c.cutting[0] << ' '
                << c.cutting[1] << ' ' << c.cutting[2] << ", " << c.emanating[0] << ' '
                << c.emanating[1] << ' ' << c.emanating[2];
          }
  });
}

TEST(Count_curves_passed, Takes_logarithmically_many_decisions) {
  for (int passed = 0; passed <= 1000; passed += 7) {
    int calls = 0;
    bool is_on = false;
    EXPECT_EQ(IT::count_curves_passed(
                  1000,
                  [&](int i) {
                    ++calls;
                    return i < passed ? CGAL::POSITIVE : CGAL::NEGATIVE;
                  },
                  is_on),
              passed);
    EXPECT_FALSE(is_on);
    EXPECT_LE(calls, 10);
  }
}

} // namespace
