// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>

#include "curve_patterns.h"

#include <gtest/gtest.h>

#include <array>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using curve_patterns::for_each_pattern;
using IT::Corner_coordinates;
using Normals = std::array<IT::Normal_coordinate, 3>;

/// Each side is crossed by the curves about its ends and those from the corner opposite.
Normals normals(const Corner_coordinates& p) {
  Normals n;
  for (unsigned k = 0; k < 3; ++k)
    n[k] = p.cutting[k] + p.cutting[(k + 1) % 3] + p.emanating[(k + 2) % 3];
  return n;
}

TEST(Corner_coordinates, Are_found_from_the_crossings_of_the_sides_for_every_pattern_of_curves) {
  for_each_pattern(4, [](const Corner_coordinates& p) {
    const Corner_coordinates c = IT::corner_coordinates(normals(p));
    EXPECT_EQ(c.cutting, p.cutting);
    EXPECT_EQ(c.emanating, p.emanating);
  });
}

TEST(Corner_coordinates, Do_not_count_curves_along_sides) {
  for_each_pattern(3, [](const Corner_coordinates& p) {
    Normals n = normals(p);
    for (IT::Normal_coordinate& x : n)
      if (x == 0) x = -1;
    EXPECT_EQ(IT::corner_coordinates(n).cutting, p.cutting);
    EXPECT_EQ(IT::corner_coordinates(n).emanating, p.emanating);
  });
}

TEST(Corner_coordinates, Do_not_overflow_at_the_greatest_normal_coordinate) {
  constexpr IT::Normal_coordinate n = IT::maximal_normal_coordinate;
  EXPECT_EQ(IT::corner_coordinates({n, n, n}).cutting, (Normals{n / 2, n / 2, n / 2}));
  EXPECT_EQ(IT::corner_coordinates({n, -1, 0}).emanating, (Normals{0, 0, n}));
  const Corner_coordinates c = IT::corner_coordinates({n, n, n});
  EXPECT_EQ(IT::flipped_normal_coordinate(n, c, c), n);
}

TEST(Flipped_normal_coordinate, Is_one_where_the_edge_is_a_curve_and_back) {
  const Corner_coordinates none{{0, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(IT::flipped_normal_coordinate(-1, none, none), 1);
  EXPECT_EQ(IT::flipped_normal_coordinate(0, none, none), 0);
  // a curve from apex to apex runs along the new edge
  const Corner_coordinates from_apex{{0, 0, 0}, {0, 0, 1}};
  EXPECT_EQ(IT::flipped_normal_coordinate(1, from_apex, from_apex), -1);
}

/// In a diamond every curve that crosses ij is an arc about i or j, or from an apex, on each side;
/// matched in order from i to j. Those that join the sides of k to those of m do not cross km only if
/// both arcs are about the same end.
TEST(Flipped_normal_coordinate, Counts_the_curves_that_separate_the_apices) {
  for_each_pattern(3, [](const Corner_coordinates& f) {
    const IT::Normal_coordinate ij = normals(f)[0];
    for_each_pattern(3, [&](const Corner_coordinates& g) { // corners j, i, m
      if (normals(g)[0] != ij) return;
      // along ij from i: f's about i, f's from k, f's about j; g's about i, from m, about j
      enum Kind { about_i, from_apex, about_j };
      const auto kind = [](int p, int i, int apex) {
        return p < i ? about_i : p < i + apex ? from_apex : about_j;
      };
      IT::Normal_coordinate n = f.cutting[2] + g.cutting[2] + f.emanating[0] + f.emanating[1] +
                                g.emanating[0] + g.emanating[1];
      int joining = 0;
      for (int p = 0; p < ij; ++p) {
        const Kind a = kind(p, f.cutting[0], f.emanating[2]),
                   b = kind(p, g.cutting[1], g.emanating[2]);
        if (a == from_apex && b == from_apex)
          n = -1, ++joining; // the curve joins the apices, and nothing crosses it
        else if (a != from_apex && b != from_apex && a != b)
          ++n;
      }
      if (joining > 1) return; // not straight: two would bound a digon
      EXPECT_EQ(IT::flipped_normal_coordinate(ij, f, g), n);
    });
  });
}

} // namespace
