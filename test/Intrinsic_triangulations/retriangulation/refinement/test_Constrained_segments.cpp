// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Constrained_segments.h>

#include "meshes.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>;
using View = IT::Intrinsic_view<Triangulation>;

/// A triangle with sides 3 and `second` from the first vertex, at an angle in degrees.
Triangulation corner(double degrees, double second = 2) {
  const double a = degrees * std::numbers::pi / 180;
  meshes::Mesh m;
  m.points = {{0, 0, 0}, {3, 0, 0}, {second * std::cos(a), second * std::sin(a), 0}};
  m.triangles = {{0, 1, 2}};
  IT::Intrinsic_input i = m.input();
  i.may_renumber = false;
  return Triangulation(std::move(i));
}

/// The halfedge of the only face that starts at vertex `v`.
std::uint32_t side(const View& view, std::uint32_t v) {
  std::uint32_t h = view.halfedge_of_face(0);
  while (view.source(h) != v) h = view.next(h);
  return h;
}

IT::Constrained_segments all_sides(const View& view) {
  IT::Constrained_segments s;
  for (std::uint32_t v = 0; v < 3; ++v) s.add(view, side(view, v), v == 0);
  s.find_small_angles(view);
  return s;
}

TEST(Constrained_segments, Split_at_powers_of_two_from_a_small_angle_else_in_the_middle) {
  const Triangulation wide = corner(70), sharp = corner(40, 2), narrow = corner(20, 3);
  const View w(wide), b(sharp), n(narrow);
  // no angle below 60 degrees at either end; one at both
  IT::Constrained_segments two;
  two.add(w, side(w, 0), true);
  two.add(w, side(w, 2), true);
  two.find_small_angles(w);
  EXPECT_EQ(two.split_parameter(w, side(w, 0)), 0.5);
  EXPECT_EQ(two.split_parameter(w, side(w, 2)), 0.5);
  EXPECT_EQ(all_sides(b).split_parameter(b, side(b, 0)), 0.5);
  const IT::Constrained_segments s = all_sides(n);
  for (const std::uint32_t h : {side(n, 0), side(n, 0) ^ 1U, side(n, 2), side(n, 2) ^ 1U}) {
    const double t = s.split_parameter(n, h), length = std::sqrt(n.squared_length(h / 2));
    const double from_corner = (n.source(h) == 0 ? t : 1 - t) * length;
    EXPECT_NEAR(std::log2(from_corner), std::round(std::log2(from_corner)), 1e-12);
    EXPECT_GE(t, 0.25);
    EXPECT_LE(t, 0.75);
  }
}

TEST(Constrained_segments, Know_the_parts_of_what_was_split) {
  const Triangulation t = corner(40);
  const View view(t);
  IT::Constrained_segments s = all_sides(view);
  const std::uint32_t h = side(view, 0), g = side(view, 2);
  EXPECT_TRUE(s.is_constrained(h / 2));
  EXPECT_TRUE(s.is_segment(g / 2));
  EXPECT_FALSE(s.is_constrained(g / 2));
  EXPECT_FALSE(s.is_segment(100));
  s.split(h / 2, {h / 2, 100}, {0, 1}, 3, 1.0 / 3); // at distance 1 of 3
  EXPECT_TRUE(s.is_constrained(100));
  s.split(g / 2, {101, 102}, {2, 0}, 4, 0.5); // at distance 1 of 2
  EXPECT_FALSE(s.is_segment(g / 2));
  EXPECT_TRUE(s.are_across_small_angle(3, 4, 0.5));
  s.split(h / 2, {h / 2, 103}, {3, 0}, 5, 0.5); // at distance 1/2
  EXPECT_FALSE(s.are_across_small_angle(5, 4, 0.5));
  EXPECT_FALSE(s.are_across_small_angle(5, 3, 0.5)); // on one segment
  s.split(102, {102, 104}, {0, 4}, 6, 0.5);
  EXPECT_TRUE(s.are_across_small_angle(5, 6, 0.5));
  EXPECT_FALSE(s.are_across_small_angle(0, 6, 0.5));
  // below a bound of more than 40 degrees the distances do not matter, and ends of segments count
  EXPECT_TRUE(s.are_across_small_angle(5, 4, 0.7));
  EXPECT_TRUE(s.are_across_small_angle(1, 4, 0.7));
  EXPECT_FALSE(s.are_across_small_angle(5, 3, 0.7));
  EXPECT_FALSE(s.are_across_small_angle(0, 4, 0.7));
}

TEST(Constrained_segments, Are_across_no_angle_that_is_wide) {
  const Triangulation t = corner(70);
  const View view(t);
  IT::Constrained_segments s = all_sides(view);
  s.split(side(view, 0) / 2, {side(view, 0) / 2, 100}, {0, 1}, 3, 1.0 / 3);
  s.split(side(view, 2) / 2, {101, 102}, {2, 0}, 4, 0.5);
  // 70 degrees at vertex 0; at vertex 1 the angle is below 60, but 3 and 4 are not on its sides
  EXPECT_FALSE(s.are_across_small_angle(3, 4, 0.5));
}

} // namespace
