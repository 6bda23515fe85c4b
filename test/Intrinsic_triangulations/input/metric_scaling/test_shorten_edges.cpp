// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/input/metric_scaling/triangle_inequality.h>

#include "gallery.h"
#include "meshes.h"

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;

namespace {

double bound(double b, double c, double margin) {
  return std::max(b, c) + (1 - margin) * std::min(b, c);
}

std::vector<double> roots(std::vector<double> l) {
  for (double& x : l) x = std::sqrt(x);
  return l;
}

std::array<std::uint32_t, 3> edges_of_face(const IT::Gluing_map& map, std::uint32_t f) {
  const auto [h, n, l] = map.sides({f});
  return {h.index / 2, n.index / 2, l.index / 2};
}

// The greatest lengths below the given ones by iteration from above, which converges to them.
std::vector<double> relaxed(const IT::Gluing_map& map, std::vector<double> l, double margin) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t f = 0; f < map.number_of_faces(); ++f) {
      const auto e = edges_of_face(map, f);
      for (std::size_t k = 0; k < 3; ++k) {
        const double b = bound(l[e[(k + 1) % 3]], l[e[(k + 2) % 3]], margin);
        if (l[e[k]] <= b * (1 + 1e-13)) continue;
        l[e[k]] = b;
        changed = true;
      }
    }
  }
  return l;
}

bool all_have_area(const IT::Gluing_map& map, const std::vector<double>& l) {
  for (std::uint32_t f = 0; f < map.number_of_faces(); ++f) {
    const auto [a, b, c] = edges_of_face(map, f);
    const Gmpq p = Gmpq(l[a]) + Gmpq(l[c]) - Gmpq(l[b]);
    if (Gmpq(4) * Gmpq(l[a]) * Gmpq(l[c]) <= p * p) return false;
  }
  return true;
}

std::vector<double> random_squares(const IT::Gluing_map& map, double decades, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<double> l(map.number_of_edges());
  for (double& x : l) x = std::pow(10, decades * static_cast<double>(random()) / 0x1p32);
  return l;
}

TEST(Shorten_edges, sets_a_side_that_is_too_long_to_what_the_others_allow) {
  const IT::Gluing_map map(gallery::triangle().gluing);
  for (const double margin : {1e-9, 1e-5, 0.25, 1.0}) {
    std::vector<double> l{1, 4, 100};
    const IT::Shortening_report r = IT::shorten_edges(map, l, margin);
    EXPECT_EQ(r.changed_edges, 1U);
    EXPECT_EQ(l[0], 1);
    EXPECT_EQ(l[1], 4);
    EXPECT_NEAR(std::sqrt(l[2]), 3 - margin, 1e-14);
    EXPECT_NEAR(r.largest_relative_change, 1 - (3 - margin) / 10, 1e-14);
  }
}

TEST(Shorten_edges, leaves_needles_and_proper_faces_alone) {
  const IT::Gluing_map map(gallery::triangle().gluing);
  for (const double width : {1e-3, 1e-10, 1e-30, 1e-150}) {
    std::vector<double> l{1, 1, width * width};
    const std::vector<double> before = l;
    const IT::Shortening_report r = IT::shorten_edges(map, l, 0.5);
    EXPECT_EQ(l, before);
    EXPECT_EQ(r.changed_edges, 0U);
    EXPECT_EQ(r.largest_relative_change, 0);
  }
}

TEST(Shorten_edges, gives_the_greatest_lengths_below_the_given_ones) {
  for (const meshes::Mesh& m : {meshes::grid(12, 12), meshes::potato(2, 3), meshes::sphere(2)}) {
    const IT::Gluing_map map = m.map();
    for (const double decades : {1.0, 3.0, 12.0})
      for (const double margin : {1e-5, 0.1}) {
        std::vector<double> l = random_squares(map, decades, 5);
        const std::vector<double> before = roots(l), expected = relaxed(map, before, margin);
        const IT::Shortening_report r = IT::shorten_edges(map, l, margin);
        std::size_t changed = 0;
        for (std::size_t e = 0; e < l.size(); ++e) {
          // a chain of constraints adds up rounding errors of at most E operations
          EXPECT_NEAR(std::sqrt(l[e]), expected[e], 1e-11 * expected[e]);
          EXPECT_LE(std::sqrt(l[e]), before[e]);
          changed += std::sqrt(l[e]) < before[e] ? 1 : 0;
        }
        EXPECT_EQ(r.changed_edges, changed);
        EXPECT_GT(changed, 0U);
      }
  }
}

TEST(Shorten_edges, makes_every_face_strict_exactly_and_never_touches_the_shortest_edge) {
  for (const gallery::Surface& s : gallery::all()) {
    const IT::Gluing_map map(s.gluing);
    for (unsigned seed = 1; seed <= 20; ++seed)
      for (const double decades : {1.0, 100.0})
        for (const double margin : {std::numeric_limits<double>::min(), 1e-5, 1.0}) {
          std::vector<double> l = random_squares(map, decades, seed);
          const double shortest = *std::min_element(l.begin(), l.end());
          IT::shorten_edges(map, l, margin);
          EXPECT_TRUE(all_have_area(map, l)) << s << " seed " << seed;
          EXPECT_EQ(*std::min_element(l.begin(), l.end()), shortest) << s << " seed " << seed;
          const std::vector<double> once = l;
          EXPECT_EQ(IT::shorten_edges(map, l, margin).changed_edges, 0U) << s << " seed " << seed;
          EXPECT_EQ(l, once) << s << " seed " << seed;
        }
  }
}

TEST(Shorten_edges, passes_constraints_on_from_face_to_face) {
  // a strip of squares with diagonals; all edges are long but one at its end
  const meshes::Mesh m = meshes::grid(30, 1);
  const IT::Gluing_map map = m.map();
  std::vector<double> l(map.number_of_edges(), 1e12);
  const auto end = edges_of_face(map, 1);
  for (const std::uint32_t e : {end[0], end[1], end[2]}) l[e] = 1;
  IT::shorten_edges(map, l, 1e-5);
  const std::vector<double> expected = relaxed(
      map,
      [&] {
        std::vector<double> x(map.number_of_edges(), 1e6);
        for (const std::uint32_t e : end) x[e] = 1;
        return x;
      }(),
      1e-5);
  for (std::size_t e = 0; e < l.size(); ++e)
    EXPECT_NEAR(std::sqrt(l[e]), expected[e], 1e-12 * expected[e]);
}

TEST(Shorten_edges, of_length_zero_make_the_other_sides_equal_and_nothing_collapses) {
  const IT::Gluing_map map(gallery::triangle().gluing);
  std::vector<double> l{0, 4, 9};
  IT::shorten_edges(map, l, 0.1);
  EXPECT_EQ(l, (std::vector<double>{0, 4, 4}));
}

TEST(Shorten_edges, works_from_end_to_end_of_the_range_of_doubles) {
  const IT::Gluing_map map(gallery::triangle().gluing);
  for (const double unit : {0x1p-1074, 0x1p-1000, 0x1p1000, 0x1p1020}) {
    std::vector<double> l{unit, unit, 7 * unit};
    IT::shorten_edges(map, l, 0.5);
    EXPECT_TRUE(all_have_area(map, l)) << unit;
    EXPECT_GE(l[2], unit);
  }
}

TEST(Shorten_edges, refuses_a_margin_without_sense) {
  const IT::Gluing_map map(gallery::triangle().gluing);
  std::vector<double> l{1, 1, 1};
  for (const double margin : {0.0, -1.0, 1.5, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(IT::shorten_edges(map, l, margin), std::invalid_argument);
}

} // namespace
