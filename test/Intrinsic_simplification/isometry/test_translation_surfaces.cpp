// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_simplification/isometry/Canonical_form.h>
#include <CGAL/Intrinsic_simplification/isometry/find_isometries.h>

#include "gallery.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

// Rectangles glued along parallel sides, and their images under linear maps.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Isometry_answer;
using Triangulation = IT::Corresponding_triangulation;

using Matrix = std::array<std::array<double, 2>, 2>;

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j];
  return c;
}

constexpr double cubic = 1.8019377358048383; // a = 2 cos(pi / 7), a^3 - a^2 - 2 a + 1 = 0

// Rectangles, glued along their sides (bottom, right, top, left: 0 to 3), under a linear map.
struct Rectangles {
  std::vector<std::array<double, 2>> sizes;
  // rectangle, side, rectangle, side
  std::vector<std::array<std::uint32_t, 4>> glued;

  // \param falls which diagonals run from the upper left to the lower right corner, as bits
  Triangulation surface(const Matrix& m, std::uint32_t falls = 0) const {
    const auto number = [&](std::uint32_t r, std::uint32_t s) {
      return 6 * r + std::array{0U, 1U, 4U, 5U, 0U, 3U, 4U, 2U}[s + 4 * ((falls >> r) & 1U)];
    };
    std::vector<gallery::Glued> pairs;
    for (std::uint32_t r = 0; r < sizes.size(); ++r) {
      const std::uint32_t diagonal = (falls >> r) & 1U;
      pairs.push_back({6 * r + 2 - diagonal, 6 * r + 3 + 2 * diagonal});
    }
    for (const auto& [r, s, q, t] : glued) pairs.push_back({number(r, s), number(q, t)});
    const auto faces = static_cast<std::uint32_t>(2 * sizes.size());
    gallery::Surface result = gallery::abstract("rectangles", gallery::glue(faces, pairs), {});
    result.squared_length_of_side.clear();
    for (std::uint32_t r = 0; r < sizes.size(); ++r) {
      const auto squared = [&m](double x, double y) {
        const double u = m[0][0] * x + m[0][1] * y, v = m[1][0] * x + m[1][1] * y;
        return u * u + v * v;
      };
      const auto [width, height] = sizes[r];
      const double right = squared(width, 0), up = squared(0, height),
                   rises = squared(width, height), falling = squared(width, -height);
      const std::array<double, 6> rising{right, up, rises, rises, right, up},
          other{right, falling, up, up, right, falling};
      const auto& all = ((falls >> r) & 1U) != 0 ? other : rising;
      result.squared_length_of_side.insert(result.squared_length_of_side.end(), all.begin(),
                                           all.end());
    }
    return Triangulation(gallery::input(result));
  }
};

// The surface of issue 325 of sage-flatsurf, with sides in Q(a).
Triangulation five_rectangles(const Matrix& m) {
  constexpr double a = cubic;
  const Rectangles r{
      {{1, 1}, {1, a - 1}, {a - 1, 1}, {a * a - a - 1, a - 1}, {a - 1, a * a - a - 1}},
      {{0, 0, 1, 2},
       {0, 1, 2, 3},
       {0, 2, 1, 0},
       {0, 3, 2, 1},
       {1, 1, 3, 3},
       {1, 3, 3, 1},
       {2, 0, 4, 2},
       {2, 2, 4, 0},
       {3, 0, 3, 2},
       {4, 1, 4, 3}}};
  return r.surface(m);
}

// The matrix belongs to the Veech group of the surface: cut and glued again, the image is the
// surface. Its sides get longer and longer.
TEST(IsometriesOfTranslationSurfaces, findsVeechGroups) {
  constexpr double a = cubic;
  const Matrix shears{{{1, a}, {a, a * a + 1}}};
  const IT::Canonical_form form = IT::canonical_form(five_rectangles({{{1, 0}, {0, 1}}}));
  Matrix m{{{1, 0}, {0, 1}}};
  for (int power = 1; power <= 4; ++power) {
    m = product(shears, m);
    const IT::Isometries found = IT::find_isometries(form, IT::canonical_form(five_rectangles(m)));
    EXPECT_EQ(found.answer(), Isometry_answer::isometric_within) << power << found.note();
    // sides have squares of this size, which are rounded, and heights have its inverse
    const double size = m[1][1] * m[1][1];
    EXPECT_LT(found.largest_difference(), 0x1p-52 * size * size) << power;
  }
  // another matrix of the same field, with determinant 1
  const Matrix other{{{1, 1}, {0, 1}}};
  EXPECT_EQ(IT::find_isometries(form, IT::canonical_form(five_rectangles(other))).answer(),
            Isometry_answer::not_isometric);
}

// Surfaces of the shapes of L and Z with random sides in Q(a), cut along any diagonals: all corners
// of a rectangle are cocircular, but for the rounding of lengths.
TEST(IsometriesOfTranslationSurfaces, decidesSurfacesOfCubicRectanglesUpToRounding) {
  constexpr double a = cubic;
  std::mt19937 random(13);
  const auto side = [&] {
    const auto digit = [&] { return static_cast<double>(random() % 5) - 1; };
    for (;;)
      if (const double x = digit() + digit() * a + digit() * a * a; x > 0.3) return x;
  };
  const Matrix maps[] = {{{{1, 0}, {0, 1}}}, {{{1, a}, {a, a * a + 1}}}};
  for (std::uint32_t n = 0; n < 12; ++n) {
    const double w = side(), x = side(), y = side(), h = side(), k = side();
    Rectangles s;
    if (n % 2 == 0) // L: the lower row has two rectangles
      s = {{{w, h}, {x, h}, {w, k}},
           {{0, 1, 1, 3}, {1, 1, 0, 3}, {0, 2, 2, 0}, {2, 2, 0, 0}, {1, 2, 1, 0}, {2, 1, 2, 3}}};
    else // Z: two rows of two, which share the middle
      s = {{{w, h}, {x, h}, {x, k}, {y, k}},
           {{0, 1, 1, 3},
            {1, 1, 0, 3},
            {1, 2, 2, 0},
            {2, 2, 1, 0},
            {2, 1, 3, 3},
            {3, 1, 2, 3},
            {0, 2, 0, 0},
            {3, 2, 3, 0}}};
    Rectangles other = s;
    other.sizes[0] = {w, h * 1.01};
    other.sizes[1] = {x, h * 1.01};
    for (const Matrix& m : maps) {
      const IT::Canonical_form form = IT::canonical_form(s.surface(m));
      const IT::Isometries found =
          IT::find_isometries(form, IT::canonical_form(s.surface(m, random() % 16)));
      EXPECT_TRUE(found.answer() == Isometry_answer::isometric ||
                  found.answer() == Isometry_answer::isometric_within)
          << n << IT::name_of(found.answer()) << found.note();
      EXPECT_LT(found.largest_difference(), 1e-10) << n;
      EXPECT_EQ(IT::find_isometries(form, IT::canonical_form(other.surface(m))).answer(),
                Isometry_answer::not_isometric)
          << n;
    }
  }
}

} // namespace
