// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>

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

// Counts the curves that have a point on their left; those come first.
template <class Side>
IT::Normal_coordinate count_curves_passed(IT::Normal_coordinate count, Side side, bool& is_on) {
  IT::Normal_coordinate passed = 0, bound = count; // passed are passed, from bound on are not
  while (passed < bound) {
    const IT::Normal_coordinate middle = passed + (bound - passed) / 2;
    const CGAL::Sign s = side(middle);
    if (s == CGAL::POSITIVE)
      passed = middle + 1;
    else
      bound = middle;
    if (s == CGAL::ZERO) {
      is_on = true;
      return middle;
    }
  }
  return passed;
}

// Finds the region of a face that contains a point, by asking on which side of curves it lies.
template <class Side>
Face_region find_region(const Corner_coordinates& c, const std::array<std::uint32_t, 3>& sides,
                        Side side) {
  Face_region r;
  r.fan_corner = c.fan_corner();
  for (unsigned k = 0; k < 3; ++k) {
    const auto about_corner = [&](IT::Normal_coordinate i) {
      return side(IT::Curve_crossing{sides[k], i});
    };
    r.cutting[k] = count_curves_passed(c.cutting[k], about_corner, r.is_on_curve);
    if (r.is_on_curve) r.corner = k;
    if (r.cutting[k] == c.cutting[k]) continue;
    for (unsigned l = k + 1; l < 3; ++l) r.cutting[l] = c.cutting[l];
    // whoever is cut off with another corner sees all curves of the fan on one side
    if (r.fan_corner < 3)
      r.right_of_fan = k == (r.fan_corner + 1) % 3 ? 0 : c.emanating[r.fan_corner];
    return r;
  }
  if (r.fan_corner == 3) return r;
  const unsigned k = r.fan_corner, next = (k + 1) % 3;
  const auto in_fan = [&](IT::Normal_coordinate i) {
    return side(IT::Curve_crossing{sides[next], c.cutting[next] + i});
  };
  r.right_of_fan = count_curves_passed(c.emanating[k], in_fan, r.is_on_curve);
  if (r.is_on_curve) r.corner = k;
  return r;
}

TEST(Face_region, Is_found_for_every_place_in_every_pattern) {
  for_each_pattern(3, [](const Corner_coordinates& c) {
    for_each_place(c, [&](const Place& p, unsigned fan) {
      const Face_region r = find_region(c, {10, 20, 30}, [&](const IT::Curve_crossing& x) {
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

} // namespace
