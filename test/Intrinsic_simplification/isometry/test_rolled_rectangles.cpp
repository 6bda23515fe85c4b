// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_simplification/isometry/Canonical_form.h>
#include <CGAL/Intrinsic_simplification/isometry/find_isometries.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

#include "triangle_lists.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

// Surfaces with a border, rolled from rectangles: cylinders, and prisms that are not closed.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Isometry_answer;
using triangle_lists::Triangles;
using Triangulation = IT::Corresponding_triangulation;

TEST(IsometriesOfRolledRectangles, comparesSizesWhereBordersHaveNoCorner) {
  Triangles ring; // a prism without its ends: a flat cylinder
  for (const double z : {0., 1.})
    for (const auto& [x, y] : {std::pair(0., 0.), {1., 0.}, {1., 1.}, {0., 1.}})
      ring.points.push_back({x, y, z});
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::uint32_t n = (k + 1) % 4;
    ring.faces.push_back({k, n, n + 4});
    ring.faces.push_back({k, n + 4, k + 4});
  }
  const auto stretched = [&](double around, double along) {
    Triangles t = ring;
    for (auto& [x, y, z] : t.points) {
      x *= around;
      y *= around;
      z *= along;
    }
    return t.triangulation();
  };
  EXPECT_EQ(IT::find_isometries(ring.triangulation(), stretched(1, 2)).answer(),
            Isometry_answer::not_isometric);
  // the same area, but a longer border
  EXPECT_EQ(IT::find_isometries(ring.triangulation(), stretched(2, 0.5)).answer(),
            Isometry_answer::not_isometric);
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    const IT::Isometries found =
        IT::find_isometries(ring.triangulation(), ring.renumbered(seed).triangulation());
    EXPECT_EQ(found.answer(), Isometry_answer::isometric) << seed << found.note();
    EXPECT_FALSE(found.note().empty());
  }
  EXPECT_EQ(IT::canonical_form(ring.triangulation()).hash(),
            IT::canonical_form(ring.renumbered(4).triangulation()).hash());
}

// A rectangle that is glued to a cylinder, along sides that are moved against each other by whole
// numbers. Both borders have points at distances that sum to the width.
struct Cylinder {
  Triangulation surface;
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<std::array<std::complex<double>, 3>> places; // of their corners, unrolled

  std::complex<double> place(const IT::Surface_point& p) const {
    std::complex<double> sum = 0;
    std::uint32_t h = p.halfedge;
    const std::uint32_t f = surface.input().face(h);
    for (std::size_t k = 0; k < 3; ++k, h = surface.input().next(h))
      for (std::size_t c = 0; c < 3; ++c)
        if (faces[f][c] == surface.input().source(h)) sum += p.weights[k] * places[f][c];
    return sum;
  }
};

// \param height times 8
Cylinder rolled(const std::vector<int>& lower, const std::vector<int>& upper, int height, int shift,
                bool has_bottom) {
  const auto n = static_cast<std::uint32_t>(lower.size()),
             m = static_cast<std::uint32_t>(upper.size());
  std::vector<int> x(1, 0), y(1, shift);
  for (const int d : lower) x.push_back(x.back() + d);
  for (const int d : upper) y.push_back(y.back() + d);
  const auto at = [](int a, int b) { return std::complex<double>(a, b / 8.); };
  const auto squared = [](int a, int b) { return a * a + b * b / 64.; };
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<std::array<double, 3>> sides;
  std::vector<std::array<std::complex<double>, 3>> places;
  std::uint32_t i = 0, j = 0;
  while (i < n || j < m) { // the next triangle has a side on the border that is behind
    const double across = squared(x[i] - y[j], height);
    const std::uint32_t a = i % n, b = n + j % m;
    if (j == m || (i < n && x[i] - x[0] <= y[j] - y[0])) {
      faces.push_back({a, (i + 1) % n, b});
      sides.push_back({squared(lower[i], 0), squared(x[i + 1] - y[j], height), across});
      places.push_back({at(x[i], 0), at(x[i + 1], 0), at(y[j], height)});
      ++i;
    } else {
      faces.push_back({a, n + (j + 1) % m, b});
      sides.push_back({squared(x[i] - y[j + 1], height), squared(upper[j], 0), across});
      places.push_back({at(x[i], 0), at(y[j + 1], height), at(y[j], height)});
      ++j;
    }
  }
  if (has_bottom) { // a rectangle
    const double diagonal = squared(lower[0], 8 * lower[1]);
    faces.insert(faces.end(), {{0, 3, 2}, {0, 2, 1}});
    sides.push_back({squared(lower[3], 0), squared(lower[2], 0), diagonal});
    sides.push_back({diagonal, squared(lower[1], 0), squared(lower[0], 0)});
  }
  IT::Gluing_map mesh(IT::gluing_from_triangles(n + m, faces));
  std::vector<double> lengths(mesh.number_of_edges(), 0);
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (const IT::Gluing_map::Halfedge h : mesh.sides({f}))
      for (std::size_t k = 0; k < 3; ++k)
        if (mesh.source(h).index == faces[f][k] && mesh.target(h).index == faces[f][(k + 1) % 3])
          lengths[h.index / 2] = sides[f][k];
  return {Triangulation(IT::Intrinsic_input(std::move(mesh), std::move(lengths))), faces, places};
}

Cylinder unrolled_cylinder(const std::vector<int>& lower, const std::vector<int>& upper, int height,
                           int shift) {
  return rolled(lower, upper, 8 * height, shift, false);
}

Triangulation cylinder(const std::vector<int>& lower, const std::vector<int>& upper, int height,
                       int shift) {
  return unrolled_cylinder(lower, upper, height, shift).surface;
}

TEST(IsometriesOfRolledRectangles, decidesFlatCylindersByWidthAndHeight) {
  const std::vector<std::vector<int>> borders{
      {10, 10, 10}, {4, 9, 17}, {1, 2, 3, 4, 5, 15}, {7, 7, 7, 9}};
  const IT::Canonical_form form = IT::canonical_form(cylinder(borders[0], borders[0], 12, 0));
  EXPECT_FALSE(form.is_unique());
  for (std::size_t k = 0; k < borders.size(); ++k)
    for (const int shift : {0, 1, 4, 11, 15}) {
      const IT::Canonical_form other =
          IT::canonical_form(cylinder(borders[k], borders[(k + 1) % borders.size()], 12, shift));
      const IT::Isometries found = IT::find_isometries(form, other);
      EXPECT_EQ(found.answer(), Isometry_answer::isometric) << k << ", " << shift << found.note();
      EXPECT_EQ(found.count(), 4); // reflections across and along
      EXPECT_EQ(found.note(), "rotations of a flat cylinder");
      EXPECT_EQ(other.hash(), form.hash());
    }
  // the same area, and the same boundary
  for (const auto& [lower, height] : {std::pair<std::vector<int>, int>{{10, 10, 16}, 10},
                                      {{10, 10, 10}, 13},
                                      {{10, 10, 4}, 12},
                                      {{10, 7, 7}, 15}}) {
    const IT::Canonical_form other = IT::canonical_form(cylinder(lower, lower, height, 3));
    EXPECT_EQ(IT::find_isometries(form, other).answer(), Isometry_answer::not_isometric);
    EXPECT_NE(other.hash(), form.hash());
  }
}

// In the plane, each isometry is a translation along the borders after a reflection, or none, along
// either axis.
TEST(IsometriesOfRolledRectangles, mapsPointsOfFlatCylinders) {
  constexpr double width = 30, height = 12;
  const Cylinder s = unrolled_cylinder({10, 10, 10}, {4, 9, 17}, 12, 3),
                 t = unrolled_cylinder({7, 7, 7, 9}, {1, 2, 3, 4, 5, 15}, 12, 11);
  const IT::Isometries found = IT::find_isometries(s.surface, t.surface);
  ASSERT_EQ(found.size(), 4U);
  std::vector<IT::Surface_point> points;
  for (std::uint32_t f = 0; f < s.faces.size(); ++f)
    for (const double w : {0.2, 0.5})
      points.push_back({s.surface.input().halfedge_of_face(f), {w, 0.3, 0.7 - w}});
  const auto turn = [](double x) { return std::polar(1., 2 * std::numbers::pi * x / width); };
  std::set<std::pair<int, int>> kinds;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::vector<IT::Surface_point> images = found[i].images_of(points);
    for (const int x : {-1, 1})
      for (const int y : {-1, 1}) {
        double error = 0;
        const std::complex<double> p = s.place(points[0]), q = t.place(images[0]);
        const std::complex<double> shift = turn(q.real()) / turn(x * p.real());
        for (std::size_t n = 0; n < points.size(); ++n) {
          const std::complex<double> from = s.place(points[n]), to = t.place(images[n]);
          const double z = y > 0 ? from.imag() : height - from.imag();
          error = std::max(error, std::abs(to.imag() - z));
          error = std::max(error, std::abs(turn(to.real()) - shift * turn(x * from.real())));
        }
        if (error < 1e-9) kinds.insert({x, y});
      }
  }
  EXPECT_EQ(kinds.size(), 4U);
}

// A box without a lid. Its border is a loop without a corner: the vertices on it may be anywhere.
TEST(IsometriesOfRolledRectangles, decidesOpenBoxesWhateverVerticesAreOnTheRim) {
  const Cylinder s = rolled({2, 2, 2, 2}, {2, 2, 2, 2}, 7, 0, true);
  const IT::Canonical_form form = IT::canonical_form(s.surface);
  EXPECT_TRUE(form.is_unique()) << form.note();
  EXPECT_EQ(form.number_of_flat_vertices(), 4U);
  std::vector<IT::Surface_point> points;
  for (std::uint32_t f = 0; f < s.places.size(); ++f)
    points.push_back({s.surface.input().halfedge_of_face(f), {0.2, 0.3, 0.5}});
  const std::vector<std::vector<int>> rims{{3, 3, 2}, {1, 3, 4}, {1, 1, 1, 1, 1, 1, 1, 1}};
  const auto turn = [](double x) { return std::polar(1., 2 * std::numbers::pi * x / 8); };
  for (const std::vector<int>& rim : rims)
    for (const int shift : {0, 1, 3}) {
      const Cylinder t = rolled({2, 2, 2, 2}, rim, 7, shift, true);
      const IT::Canonical_form other = IT::canonical_form(t.surface);
      EXPECT_EQ(other.hash(), form.hash());
      const IT::Isometries found = IT::find_isometries(form, other);
      ASSERT_EQ(found.answer(), Isometry_answer::isometric) << rim.size() << found.note();
      EXPECT_EQ(found.note(), "");
      ASSERT_EQ(found.size(), 8U);
      std::set<std::pair<int, int>> kinds; // reflected or not, and a turn by some sides
      for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NE(found[i].image_of_vertex(0), IT::Canonical_form::none);
        const std::vector<IT::Surface_point> images = found[i].images_of(points);
        for (const int sign : {-1, 1})
          for (int sides = 0; sides < 4; ++sides) {
            double error = 0;
            for (std::size_t n = 0; n < points.size(); ++n) {
              const std::complex<double> p = s.place(points[n]), q = t.place(images[n]);
              error = std::max(error, std::abs(p.imag() - q.imag()));
              error = std::max(error, std::abs(turn(q.real()) - turn(sign * p.real() + 2 * sides)));
            }
            if (error < 1e-9) kinds.insert({sign, sides});
          }
      }
      EXPECT_EQ(kinds.size(), 8U) << rim.size();
    }
  // the same area, and the same border
  const IT::Canonical_form oblong =
      IT::canonical_form(rolled({1, 3, 1, 3}, {4, 1, 3}, 8, 0, true).surface);
  EXPECT_EQ(IT::find_isometries(form, oblong).answer(), Isometry_answer::not_isometric);
  EXPECT_EQ(IT::find_isometries(oblong, oblong).count(), 4);
  EXPECT_NE(oblong.hash(), form.hash());
  // in space
  Triangles box = triangle_lists::box(2, 2, 0.875);
  box.faces.erase(box.faces.begin() + 2, box.faces.begin() + 4);
  const IT::Isometries in_space = IT::find_isometries(
      form, IT::canonical_form(box.divided(12, 3).renumbered(2).triangulation()));
  EXPECT_EQ(in_space.answer(), Isometry_answer::isometric) << in_space.note();
  EXPECT_EQ(in_space.count(), 8);
}

// A rectangle that is rolled to a prism of many sides, whose widths are roots that do not depend on
// each other; all vertices but four are flat.
Triangles rolled_prism(double height, std::uint32_t sides, std::uint32_t rows) {
  Triangles t;
  for (std::uint32_t i = 0; i <= sides; ++i)
    for (std::uint32_t j = 0; j <= rows; ++j) {
      const double a = 3.6 * i / sides;
      t.points.push_back({std::round(std::cos(a) * 4096) / 4096,
                          std::round(std::sin(a) * 4096) / 4096, height * j});
    }
  for (std::uint32_t i = 0; i < sides; ++i)
    for (std::uint32_t j = 0; j < rows; ++j) {
      const std::uint32_t v = i * (rows + 1) + j, w = v + rows + 1;
      t.faces.push_back({v, w, w + 1});
      t.faces.push_back({v, w + 1, v + 1});
    }
  return t;
}

TEST(IsometriesOfRolledRectangles, unrollsPrisms) {
  const auto form_of = [](double height, std::uint32_t seed) {
    return IT::canonical_form(rolled_prism(height, 12, 4).renumbered(seed).triangulation());
  };
  const IT::Canonical_form form = form_of(0.25, 1);
  EXPECT_EQ(form.number_of_flat_vertices(), 61U);
  EXPECT_EQ(form.number_of_darts(), 4U);
  const IT::Isometries found = IT::find_isometries(form, form_of(0.25, 2));
  EXPECT_EQ(found.answer(), Isometry_answer::isometric) << found.note();
  EXPECT_EQ(found.count(), 4);
  EXPECT_EQ(IT::find_isometries(form, form_of(0.5, 3)).answer(), Isometry_answer::not_isometric);
}

// Lengths are sums of more than 64 roots.
TEST(IsometriesOfRolledRectangles, unrollsPrismsOfAHundredSides) {
  const Triangles t = rolled_prism(0.25, 100, 2);
  const IT::Canonical_form form = IT::canonical_form(t.renumbered(1).triangulation());
  EXPECT_EQ(form.number_of_darts(), 4U) << form.note();
  for (const Triangles& other : {t.renumbered(2), t.divided(3, 7).renumbered(3)}) {
    const IT::Isometries found =
        IT::find_isometries(form, IT::canonical_form(other.triangulation()));
    EXPECT_EQ(found.answer(), Isometry_answer::isometric) << found.note();
    EXPECT_EQ(found.count(), 4);
  }
  Triangles longer = t; // one of its four corners, along the side, by the last digit
  longer.points.back()[2] = std::nextafter(longer.points.back()[2], 1);
  EXPECT_EQ(IT::find_isometries(form, IT::canonical_form(longer.triangulation())).answer(),
            Isometry_answer::isometric_within);
}

} // namespace
