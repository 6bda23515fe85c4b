// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_simplification/isometry/Canonical_form.h>
#include <CGAL/Intrinsic_simplification/isometry/find_isometries.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include "gallery.h"
#include "operator_test_meshes.h"
#include "triangle_lists.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
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

// n times n parallelograms of the lattice of a and b, glued to a torus
Triangulation torus(std::array<int, 2> a, std::array<int, 2> b, std::uint32_t n) {
  const auto side = [](std::array<int, 2> p) {
    return std::complex<double>(static_cast<double>(p[0]), static_cast<double>(p[1]));
  };
  return Triangulation(operator_test::torus(n, n, side(a), side(b)));
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

// A vertex was removed by a flip to a face without area, of which doubles see a little.
TEST(FindIsometries, mapsCornersToCorners) {
  gallery::Surface s = gallery::abstract("divided",
                                         gallery::glue(9, {{0, 2},
                                                           {4, 11},
                                                           {5, 16},
                                                           {6, 20},
                                                           {8, 22},
                                                           {10, 25},
                                                           {12, 18},
                                                           {13, 21},
                                                           {14, 26},
                                                           {15, 23},
                                                           {17, 24}}),
                                         {});
  s.squared_length_of_side = {25,     25,    25,    36,     14.125, 8.375, 24.75,
                              49,     12.25, 36,    20.625, 14.125, 12.25, 0.5625,
                              15.875, 9.75,  8.375, 0.5625, 12.25,  25,    24.75,
                              0.5625, 12.25, 9.75,  0.5625, 20.625, 15.875};
  const Triangulation t(gallery::input(s));
  const IT::Isometries found = IT::find_isometries(t, t);
  ASSERT_EQ(found.answer(), Isometry_answer::isometric) << found.note();
  const IT::Input& input = t.input();
  for (std::uint32_t f = 0; f < input.number_of_faces(); ++f)
    for (const IT::Gluing_map::Halfedge h : input.mesh().sides({f})) {
      const IT::Surface_point corner{h.index, {1, 0, 0}};
      const std::uint32_t image = found[0].image_of_vertex(input.source(h.index));
      if (image == IT::Canonical_form::none) continue;
      const IT::Surface_point p = found[0].images_of({&corner, 1}).front();
      double weight = 0;
      std::uint32_t x = p.halfedge;
      for (const double w : p.weights) {
        if (input.source(x) == image) weight += w;
        x = input.next(x);
      }
      EXPECT_GT(weight, 1 - 1e-9) << f;
    }
}

} // namespace
