// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_simplification/isometry/Canonical_form.h>
#include <CGAL/Intrinsic_simplification/isometry/find_isometries.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include "gallery.h"
#include "triangle_lists.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Isometry_answer;
using triangle_lists::Triangles;
using Triangulation = IT::Corresponding_triangulation;

double symmetries(const Triangulation& t) {
  const IT::Isometries found = IT::find_isometries(t, t);
  EXPECT_EQ(found.answer(), Isometry_answer::isometric) << found.note();
  return found.count();
}

double isometries(const Triangles& a, const Triangles& b) {
  const IT::Isometries found = IT::find_isometries(a.triangulation(), b.triangulation());
  return found.answer() == Isometry_answer::isometric ? found.count() : 0;
}

// the solid with a point above the middle of each face
Triangulation dodecahedron_with_pyramids() {
  // faces of the dodecahedron are vertices of the icosahedron, and vice versa
  const auto& faces = triangle_lists::icosahedron_faces();
  std::vector<std::array<std::uint32_t, 3>> all;
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::uint32_t g = 0; g < faces.size(); ++g)
        for (std::size_t l = 0; l < 3; ++l)
          if (faces[g][l] == faces[f][(k + 1) % 3] && faces[g][(l + 1) % 3] == faces[f][k])
            all.push_back({20 + faces[f][k], g, f});
  IT::Gluing_map mesh(IT::gluing_from_triangles(32, all));
  std::vector<double> lengths;
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e) {
    const IT::Gluing_map::Halfedge h{2 * e};
    lengths.push_back(mesh.source(h).index < 20 && mesh.target(h).index < 20 ? 1 : 0.75);
  }
  return Triangulation(IT::Intrinsic_input(std::move(mesh), std::move(lengths)));
}

// Two triangles, front and back, with squared lengths 1, 1 and 4 have no area.
TEST(Isometries, say_that_mollification_has_changed_lengths) {
  const auto doubled = [](double squared, IT::Mollification m = IT::Mollification::automatic) {
    const std::vector<std::array<std::uint32_t, 3>> faces{{0, 1, 2}, {0, 2, 1}};
    IT::Gluing_map mesh(IT::gluing_from_triangles(3, faces));
    std::vector<double> lengths(mesh.number_of_edges(), 1);
    for (std::uint32_t e = 0; e < 3; ++e) {
      const IT::Gluing_map::Halfedge h{2 * e};
      if (mesh.source(h).index + mesh.target(h).index == 3) lengths[e] = squared;
    }
    return Triangulation(IT::Intrinsic_input(std::move(mesh), std::move(lengths), m));
  };
  const Triangulation thin = doubled(4), thick = doubled(3);
  ASSERT_NE(thin.input().report().mollification.kind, IT::Mollification::none);
  const IT::Isometries found = IT::find_isometries(thin, thick);
  EXPECT_EQ(found.answer(), Isometry_answer::not_isometric);
  EXPECT_NE(found.note().find("mollification"), std::string::npos) << found.note();
  EXPECT_NE(IT::find_isometries(thin, thin).note().find("mollification"), std::string::npos);
  EXPECT_EQ(IT::find_isometries(thick, doubled(2)).note(), "");
  const Triangulation unchanged = doubled(2, IT::Mollification::lengths); // it was not needed
  EXPECT_EQ(IT::find_isometries(unchanged, unchanged).note(), "");
}

TEST(FindIsometries, countsTheSymmetriesOfPlatonicSolids) {
  EXPECT_EQ(symmetries(triangle_lists::tetrahedron().triangulation()), 24);
  EXPECT_EQ(symmetries(triangle_lists::box(1, 1, 1).triangulation()), 48);
  EXPECT_EQ(symmetries(triangle_lists::octahedron().triangulation()), 48);
  EXPECT_EQ(symmetries(Triangulation(
                triangle_lists::equilateral(12, triangle_lists::icosahedron_faces()))),
            120);
  EXPECT_EQ(symmetries(dodecahedron_with_pyramids()), 120);
}

TEST(FindIsometries, countsTheSymmetriesOfBoxes) {
  EXPECT_EQ(symmetries(triangle_lists::box(1, 1, 2).triangulation()), 16);
  EXPECT_EQ(symmetries(triangle_lists::box(1, 2, 3).triangulation()), 8);
}

TEST(FindIsometries, ignoresFlatVerticesNumbersAndPositions) {
  const Triangles solids[] = {triangle_lists::box(1, 1, 1), triangle_lists::box(1, 2, 3),
                              triangle_lists::octahedron(), triangle_lists::tetrahedron()};
  const double expected[] = {48, 8, 48, 24};
  for (std::size_t k = 0; k < 4; ++k)
    for (std::uint32_t seed = 0; seed < 5; ++seed) {
      const Triangles other = solids[k].divided(3 + 4 * seed, seed).renumbered(seed).turned();
      EXPECT_EQ(isometries(solids[k], other), expected[k]) << k << " with seed " << seed;
      EXPECT_EQ(isometries(solids[k], other.mirrored()), expected[k]) << k << ", seed " << seed;
    }
}

TEST(FindIsometries, findsAMirrorImageToBeOne) {
  // a tetrahedron with six different sides
  const Triangles t{{{0, 0, 0}, {4, 0, 0}, {1, 5, 0}, {1, 2, 7}},
                    triangle_lists::tetrahedron().faces};
  const IT::Isometries found =
      IT::find_isometries(t.triangulation(), t.mirrored().renumbered(1).triangulation());
  ASSERT_EQ(found.answer(), Isometry_answer::isometric);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].reverses_orientation());
  EXPECT_EQ(symmetries(t.triangulation()), 1);
}

TEST(FindIsometries, tellsScaledSurfacesApart) {
  const Triangles t = triangle_lists::box(1, 2, 3);
  const auto answer = [&](const Triangles& u) {
    return IT::find_isometries(t.triangulation(), u.triangulation()).answer();
  };
  EXPECT_EQ(answer(t.scaled(2)), Isometry_answer::not_isometric);
  EXPECT_EQ(answer(t.scaled(0x1p400)), Isometry_answer::not_isometric);
  const Triangles tiny = t.scaled(0x1p-500);
  EXPECT_EQ(IT::find_isometries(tiny.triangulation(), t.scaled(0x1p500).triangulation()).answer(),
            Isometry_answer::not_isometric);
  EXPECT_EQ(isometries(t.scaled(0x1p400), t.scaled(0x1p400).divided(9, 1)), 8);
}

TEST(FindIsometries, findsTheLastDigitToDiffer) {
  const Triangles t = triangle_lists::octahedron();
  Triangles u = t;
  u.points[4][2] = std::nextafter(1, 2);
  const IT::Isometries found = IT::find_isometries(t.triangulation(), u.triangulation());
  EXPECT_EQ(found.answer(), Isometry_answer::isometric_within);
  EXPECT_GT(found.largest_difference(), 0x1p-54);
  EXPECT_LT(found.largest_difference(), 0x1p-48);
  u.points[4][2] = 1.01;
  EXPECT_EQ(IT::find_isometries(t.triangulation(), u.triangulation()).answer(),
            Isometry_answer::not_isometric);
}

TEST(FindIsometries, recognisesASurfaceThatWasTurnedAndRounded) {
  const Triangles t = triangle_lists::box(1, 1, 1).divided(12, 3);
  Triangles u = t;
  for (auto& p : u.points)
    p = {0.6 * p[0] - 0.8 * p[1], 0.8 * p[0] + 0.6 * p[1], p[2] / 3 + 2 * p[2] / 3};
  const IT::Isometries found = IT::find_isometries(t.triangulation(), u.triangulation());
  EXPECT_EQ(found.answer(), Isometry_answer::isometric_within) << found.note();
  EXPECT_LT(found.largest_difference(), 1e-14);
}

TEST(FindIsometries, doesNotConfuseSurfacesWithTheSameLengths) {
  // two tetrahedra with the same six squared lengths at other places
  const auto tetrahedron = [](std::array<double, 6> l) {
    IT::Gluing_map mesh(IT::gluing_from_triangles(4, triangle_lists::tetrahedron().faces));
    return Triangulation(
        IT::Intrinsic_input(std::move(mesh), std::vector<double>(l.begin(), l.end())));
  };
  const Triangulation a = tetrahedron({16, 17, 18, 19, 20, 21}),
                      b = tetrahedron({17, 16, 18, 19, 20, 21});
  EXPECT_EQ(IT::find_isometries(a, a).count(), 1);
  EXPECT_EQ(IT::find_isometries(a, b).answer(), Isometry_answer::not_isometric);
}

// ---- flat surfaces ------------------------------------------------------------------------------

// n times m parallelograms of the lattice of a and b, glued to a torus
Triangulation torus(std::array<int, 2> a, std::array<int, 2> b, std::uint32_t n) {
  IT::Gluing g;
  g.number_of_vertices = n * n;
  std::vector<double> sides;
  const auto squared = [](int x, int y) { return static_cast<double>(x * x + y * y); };
  const double l[3] = {squared(a[0], a[1]), squared(b[0], b[1]), squared(a[0] + b[0], a[1] + b[1])};
  const auto face = [n](std::uint32_t i, std::uint32_t j) { return 2 * (j % n * n + i % n); };
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const auto v = [&](std::uint32_t x, std::uint32_t y) {
        return (j + y) % n * n + (i + x) % n;
      };
      for (const std::uint32_t w : {v(0, 0), v(1, 0), v(1, 1), v(0, 0), v(1, 1), v(0, 1)})
        g.origin.push_back(w);
      for (const double x : {l[0], l[1], l[2], l[2], l[0], l[1]}) sides.push_back(x);
      for (const std::uint32_t x :
           {3 * (face(i, j + n - 1) + 1) + 1, 3 * (face(i + 1, j) + 1) + 2, 3 * (face(i, j) + 1),
            3 * face(i, j) + 2, 3 * face(i, j + 1), 3 * face(i + n - 1, j) + 1})
        g.glue.push_back(x);
    }
  gallery::Surface s{"torus", g, {}, sides};
  return Triangulation(gallery::input(s));
}

TEST(FindIsometries, comparesFlatToriByTheirLattices) {
  // isometries that keep a point: those of the lattice
  EXPECT_EQ(symmetries(torus({1, 0}, {0, 1}, 1)), 8);
  EXPECT_EQ(symmetries(torus({1, 0}, {0, 1}, 3)), 8);
  EXPECT_EQ(symmetries(torus({1, 0}, {0, 2}, 2)), 4);
  EXPECT_EQ(symmetries(torus({2, 1}, {2, -1}, 2)), 4); // rhombs
  EXPECT_EQ(symmetries(torus({5, 0}, {1, 7}, 2)), 2);
  EXPECT_EQ(symmetries(torus({5, 0}, {1, 7}, 40)), 2); // 1,599 vertices are removed
  const IT::Isometries square =
      IT::find_isometries(torus({1, 0}, {0, 1}, 2), torus({1, 1}, {1, 2}, 2));
  EXPECT_EQ(square.answer(), Isometry_answer::isometric);
  EXPECT_EQ(square.count(), 8);
  EXPECT_EQ(square.note(), "translations of a flat torus");
  EXPECT_EQ(IT::find_isometries(torus({1, 0}, {0, 4}, 1), torus({2, 0}, {0, 2}, 1)).answer(),
            Isometry_answer::not_isometric);
}

// Lagrange and Gauss reduce a basis: the sides of the Delaunay tessellation of a torus are its two
// vectors, and their shorter sum unless they are orthogonal.
TEST(FindIsometries, reducesLatticesAsGaussDoes) {
  using Vector = std::array<int, 2>;
  const auto dot = [](const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1]; };
  std::mt19937 random(11);
  const auto number = [&] { return static_cast<int>(random() % 19) - 9; };
  for (std::uint32_t n = 3; n < 15; ++n) {
    Vector a{}, b{};
    while (a[0] * b[1] - a[1] * b[0] == 0) {
      a = {number(), number()};
      b = {number(), number()};
    }
    std::multiset<double> expected;
    Vector u = a, v = b;
    for (;;) {
      if (dot(u, u) > dot(v, v)) std::swap(u, v);
      if (2 * std::abs(dot(u, v)) <= dot(u, u)) break;
      const int k = dot(u, v) > 0 ? 1 : -1;
      v = {v[0] - k * u[0], v[1] - k * u[1]};
    }
    const int sign = dot(u, v) > 0 ? -1 : 1, squared = static_cast<int>(n * n);
    std::vector<Vector> sides{u, v};
    if (dot(u, v) != 0) sides.push_back({u[0] + sign * v[0], u[1] + sign * v[1]});
    for (const Vector& s : sides)
      for (int k = 0; k < 2; ++k) expected.insert(squared * dot(s, s));
    const IT::Canonical_form form = IT::canonical_form(torus(a, b, n));
    std::multiset<double> found;
    for (std::uint32_t d = 0; d < form.number_of_darts(); ++d) found.insert(form.squared_length(d));
    EXPECT_EQ(found, expected) << n << form.note();
  }
}

TEST(FindIsometries, comparesSizesWhereBordersHaveNoCorner) {
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

Cylinder unrolled_cylinder(const std::vector<int>& lower, const std::vector<int>& upper, int height,
                           int shift) {
  const auto n = static_cast<std::uint32_t>(lower.size()),
             m = static_cast<std::uint32_t>(upper.size());
  std::vector<int> x(1, 0), y(1, shift);
  for (const int d : lower) x.push_back(x.back() + d);
  for (const int d : upper) y.push_back(y.back() + d);
  const auto at = [](int a, int b) { return std::complex<double>(a, b); };
  const auto squared = [](int a, int b) { return static_cast<double>(a * a + b * b); };
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
  IT::Gluing_map mesh(IT::gluing_from_triangles(n + m, faces));
  std::vector<double> lengths(mesh.number_of_edges(), 0);
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (const IT::Gluing_map::Halfedge h : mesh.sides({f}))
      for (std::size_t k = 0; k < 3; ++k)
        if (mesh.source(h).index == faces[f][k] && mesh.target(h).index == faces[f][(k + 1) % 3])
          lengths[h.index / 2] = sides[f][k];
  return {Triangulation(IT::Intrinsic_input(std::move(mesh), std::move(lengths))), faces, places};
}

Triangulation cylinder(const std::vector<int>& lower, const std::vector<int>& upper, int height,
                       int shift) {
  return unrolled_cylinder(lower, upper, height, shift).surface;
}

TEST(FindIsometries, decidesFlatCylindersByWidthAndHeight) {
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

// In the plane, each isometry is a reflection or none along either axis, and a translation along the
// borders.
TEST(FindIsometries, mapsPointsOfFlatCylinders) {
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

// A rectangle that is rolled to a prism of many sides, whose widths are roots that do not depend on
// each other; all vertices but four are flat.
Triangles rolled(double height, std::uint32_t sides, std::uint32_t rows) {
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

TEST(FindIsometries, unrollsPrisms) {
  const auto form_of = [](double height, std::uint32_t seed) {
    return IT::canonical_form(rolled(height, 12, 4).renumbered(seed).triangulation());
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
TEST(FindIsometries, unrollsPrismsOfAHundredSides) {
  const Triangles t = rolled(0.25, 100, 2);
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

TEST(FindIsometries, decidesPolygonsWithABorder) {
  const Triangles square{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  EXPECT_EQ(isometries(square, square.divided(15, 1).renumbered(2)), 8);
  const Triangles bent{{{0, 0, 0}, {2, 0, 0}, {2, 0, 2}, {0, 0, 2}}, {{0, 1, 2}, {0, 2, 3}}};
  EXPECT_EQ(isometries(square, bent), 8);
}

// A rhombus with the middle of a diagonal as a corner of a face without area.
TEST(FindIsometries, removesFacesWithoutArea) {
  const std::array<double, 2> points[] = {{0, 0}, {2, 0}, {1, 0}, {1, 2}, {1, -2}};
  const std::vector<std::array<std::uint32_t, 3>> faces{{0, 1, 2}, {0, 2, 3}, {2, 1, 3}, {0, 4, 1}};
  IT::Gluing_map mesh(IT::gluing_from_triangles(5, faces));
  std::vector<double> lengths;
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e) {
    const IT::Gluing_map::Halfedge h{2 * e};
    const auto &p = points[mesh.source(h).index], &q = points[mesh.target(h).index];
    lengths.push_back((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]));
  }
  const Triangulation t(
      IT::Intrinsic_input(std::move(mesh), std::move(lengths), IT::Mollification::none));
  EXPECT_EQ(IT::canonical_form(t).number_of_flat_vertices(), 1U);
  EXPECT_EQ(symmetries(t), 4);
}

// ---- translation surfaces -----------------------------------------------------------------------

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
TEST(FindIsometries, findsVeechGroups) {
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
TEST(FindIsometries, decidesSurfacesOfCubicRectanglesUpToRounding) {
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

// ---- several components, many candidates --------------------------------------------------------

Triangles together(const std::vector<Triangles>& parts) {
  Triangles all;
  for (const Triangles& t : parts) {
    const auto shift = static_cast<std::uint32_t>(all.points.size());
    all.points.insert(all.points.end(), t.points.begin(), t.points.end());
    for (const auto& [i, j, k] : t.faces) all.faces.push_back({i + shift, j + shift, k + shift});
  }
  return all;
}

TEST(FindIsometries, permutesComponents) {
  const Triangles box = triangle_lists::box(1, 2, 3), other = triangle_lists::tetrahedron();
  const Triangles a = together({box, other, box.turned()}),
                  b = together({box.divided(5, 1), box.mirrored(), other}).renumbered(5);
  const IT::Isometries found = IT::find_isometries(a.triangulation(), b.triangulation());
  ASSERT_EQ(found.answer(), Isometry_answer::isometric);
  ASSERT_EQ(found.size(), 2U * 8 * 8 * 24);
  std::set<std::vector<std::uint32_t>> maps;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const IT::Isometry map = found[i];
    std::vector<std::uint32_t> images;
    for (std::uint32_t v = 0; v < a.points.size(); ++v) images.push_back(map.image_of_vertex(v));
    maps.insert(images);
  }
  EXPECT_EQ(maps.size(), found.size());
  EXPECT_EQ(isometries(a, together({box, other, other})), 0);
}

TEST(FindIsometries, walksRarelyWhereAllDartsLookAlike) {
  // equilateral triangles, glued at random
  std::mt19937 random(5);
  const std::uint32_t faces = 2000;
  std::vector<std::uint32_t> sides(3 * faces);
  for (std::uint32_t h = 0; h < sides.size(); ++h) sides[h] = h;
  std::shuffle(sides.begin(), sides.end(), random);
  std::vector<gallery::Glued> pairs;
  for (std::size_t k = 0; k < sides.size(); k += 2) pairs.push_back({sides[k], sides[k + 1]});
  const gallery::Surface s = gallery::abstract("random", gallery::glue(faces, pairs), {});
  const Triangulation t(gallery::input(s));
  const IT::Isometries found = IT::find_isometries(t, t);
  EXPECT_EQ(found.answer(), Isometry_answer::isometric);
  EXPECT_EQ(found.count(), 1);
  EXPECT_LT(found.number_of_walks(), 12U * faces);
}

// ---- what ends the search -----------------------------------------------------------------------

TEST(FindIsometries, asksInEveryStageWhetherToGoOn) {
  const Triangulation t = triangle_lists::box(1, 2, 3).divided(9, 1).triangulation();
  std::vector<IT::Isometry_stage> stages;
  std::size_t last = 1000;
  IT::Isometry_options options;
  options.progress = [&](const IT::Isometry_progress& p) {
    stages.push_back(p.stage);
    return stages.size() <= last;
  };
  const auto run = [&] {
    stages.clear();
    const IT::Canonical_form form = IT::canonical_form(t, options);
    return std::pair(form.status(), IT::find_isometries(form, form, options));
  };
  EXPECT_EQ(run().second.count(), 8);
  const std::vector<IT::Isometry_stage> all = stages;
  EXPECT_EQ(std::set(all.begin(), all.end()).size(), 5U);
  for (last = 0; last < all.size(); ++last) {
    const auto [status, found] = run();
    EXPECT_EQ(status == IT::Status::cancelled, all[last] < IT::Isometry_stage::lengths);
    EXPECT_EQ(found.answer(), Isometry_answer::undecided);
    EXPECT_NE(found.note().find("ended"), std::string::npos);
  }
  last = 0;
  stages.clear();
  EXPECT_THROW(IT::canonical_form(t).hash(options), IT::Invalid_input);
}

// ---- maps of points -----------------------------------------------------------------------------

TEST(FindIsometries, mapsPointsAsItMapsVertices) {
  const Triangles a = triangle_lists::box(1, 2, 3).divided(9, 1),
                  b = triangle_lists::box(1, 2, 3).divided(14, 2).renumbered(3);
  const Triangulation s = a.triangulation(), t = b.triangulation();
  const IT::Isometries found = IT::find_isometries(s, t);
  ASSERT_EQ(found.size(), 8U);
  // in space, each map of a box is a composition of reflections: coordinate k or size - k
  const auto position = [](const IT::Input& input, const IT::Surface_point& p) {
    std::array<double, 3> sum{};
    std::uint32_t h = p.halfedge;
    for (std::size_t k = 0; k < 3; ++k, h = input.next(h)) {
      const auto& q = input.metric().points()[input.source(h)];
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += std::ldexp(p.weights[k] * q[c], -input.scale_exponent());
    }
    return sum;
  };
  std::vector<IT::Surface_point> points;
  for (std::uint32_t f = 0; f < s.input().number_of_faces(); ++f)
    points.push_back({s.input().halfedge_of_face(f), {0.25, 0.5, 0.25}});
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto images = found[i].images_of(points);
    for (std::size_t c = 0; c < 3; ++c) {
      const double size = static_cast<double>(c + 1);
      double kept = 0, reflected = 0; // largest differences
      for (std::size_t n = 0; n < points.size(); ++n) {
        const double p = position(s.input(), points[n])[c], q = position(t.input(), images[n])[c];
        kept = std::max(kept, std::abs(q - p));
        reflected = std::max(reflected, std::abs(q - (size - p)));
      }
      EXPECT_LT(std::min(kept, reflected), 1e-9) << i << " " << c;
    }
  }
}

} // namespace
