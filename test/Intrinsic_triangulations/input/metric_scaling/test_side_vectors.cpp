// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/input/metric_scaling/scale_metric.h>

#include "slivers.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Vector = std::array<double, 3>;

Vector difference(const Vector& p, const Vector& q) {
  return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
}

double length(const IT::Plane_vector<double>& v) { return std::hypot(v.x, v.y); }
double length(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

TEST(Side_vectors, of_a_right_triangle_are_known) {
  // i = (0, 0), j = (3, 0), k = (3, 4)
  const IT::Plane_sides expected{{{3, 0}, {0, 4}, {-3, -4}}};
  EXPECT_EQ(IT::internal::planar_sides(9, 16, 25), expected);
  const IT::internal::Space_sides sides{{{0, 3, 0}, {0, 0, 4}, {0, -3, -4}}};
  EXPECT_EQ(IT::internal::planar_sides(sides), expected);
}

TEST(Side_vectors, agree_with_the_layout_of_the_triangle) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 300; ++i) {
    const slivers::Sides s = slivers::draw_squares(slivers::Shape::random, 1, random);
    const double l = std::sqrt(s[0]),
                 area = std::sqrt(IT::squared_quadruple_area(s[0], s[1], s[2]));
    const IT::Plane_vector<double> k = l * IT::apex(s[0], s[1], s[2], area);
    const IT::Plane_sides expected{{{l, 0}, {k.x - l, k.y}, {-k.x, -k.y}}};
    const IT::Plane_sides v = IT::internal::planar_sides(s[0], s[1], s[2]);
    for (std::size_t side = 0; side < 3; ++side)
      for (std::size_t c = 0; c < 2; ++c)
        EXPECT_NEAR(v[side][c], expected[side][c], 1e-14); // lengths below 3
    EXPECT_GE(v[1][1], 0);
  }
}

TEST(Side_vectors, are_as_long_as_the_sides_on_needles_and_caps) {
  std::mt19937_64 random(2);
  slivers::for_each_shape([&](slivers::Shape shape, double width) {
    const slivers::Sides s = slivers::draw_squares(shape, width, random);
    const IT::Plane_sides v = IT::internal::planar_sides(s[0], s[1], s[2]);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(length(v[k]), std::sqrt(s[k]), 4e-15 * std::sqrt(s[k])) << width;
  });
}

TEST(Side_vectors, of_a_triangle_in_space_keep_lengths_and_angles_on_needles) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const auto draw = [&] { return Vector{normal(random), normal(random), normal(random)}; };
  for (int i = 0; i < 300; ++i) {
    const Vector p = draw(), r = draw(), d = draw();
    const double width = std::pow(2.0, -(i % 30));
    const Vector q{p[0] + width * d[0], p[1] + width * d[1], p[2] + width * d[2]};
    const IT::internal::Space_sides sides[3] = {{difference(p, q), difference(q, r), difference(r, p)},
                                      {difference(q, r), difference(r, p), difference(p, q)},
                                      {difference(r, p), difference(p, q), difference(q, r)}};
    for (const IT::internal::Space_sides& s : sides) {
      const IT::Plane_sides v = IT::internal::planar_sides(s);
      EXPECT_EQ(v[0][1], 0);
      EXPECT_GE(v[1][1], 0);
      EXPECT_LE(v[2][1], 0);
      for (std::size_t a = 0; a < 3; ++a) {
        EXPECT_NEAR(length(v[a]), length(s[a]), 2e-15 * length(s[a]));
        const std::size_t b = (a + 1) % 3;
        const double dot = s[a][0] * s[b][0] + s[a][1] * s[b][1] + s[a][2] * s[b][2];
        EXPECT_NEAR(v[a][0] * v[b][0] + v[a][1] * v[b][1], dot,
                    4e-15 * length(s[a]) * length(s[b]));
      }
    }
  }
}

TEST(Side_vectors, of_a_face_whose_first_side_has_no_length_lie_on_the_x_axis) {
  EXPECT_EQ(IT::internal::planar_sides(0, 4, 4), (IT::Plane_sides{{{0, 0}, {2, 0}, {-2, 0}}}));
  EXPECT_EQ(IT::internal::planar_sides({{{0, 0, 0}, {0, 2, 0}, {0, -2, 0}}}),
            (IT::Plane_sides{{{0, 0}, {2, 0}, {-2, 0}}}));
}

TEST(Side_vectors, of_lengths_that_violate_the_triangle_inequality_have_no_height) {
  for (const IT::Plane_sides& v : {IT::internal::planar_sides(1, 1, 9), IT::internal::planar_sides(9, 1, 1)})
    for (const auto& side : v) EXPECT_EQ(side[1], 0);
}

} // namespace
