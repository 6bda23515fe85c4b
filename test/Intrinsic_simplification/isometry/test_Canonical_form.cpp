// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_simplification/isometry/Canonical_form.h>
#include <CGAL/Intrinsic_simplification/isometry/find_isometries.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include "gallery.h"
#include "triangle_lists.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using triangle_lists::Triangles;
using Triangulation = IT::Corresponding_triangulation;

std::uint64_t hash_of(const Triangles& t) { return IT::canonical_form(t.triangulation()).hash(); }

// a sphere with random radii, of 8 * 3^levels faces
Triangles bumpy(std::uint32_t seed, int levels = 3) {
  Triangles t = triangle_lists::octahedron();
  for (int n = 0; n < levels; ++n)
    for (std::size_t f = 0, faces = t.faces.size(); f < faces; ++f) t.split_face(f);
  std::mt19937 random(seed);
  for (auto& p : t.points) {
    const double size = std::hypot(p[0], p[1], p[2]);
    const double radius = 1 + static_cast<double>(random() % 1000) / 4096;
    for (double& x : p) x *= radius / size;
  }
  return t;
}

TEST(CanonicalForm, ofACubeHasSixSquares) {
  const IT::Canonical_form form =
      IT::canonical_form(triangle_lists::box(1, 1, 1).divided(20, 7).triangulation());
  EXPECT_TRUE(form.is_unique());
  EXPECT_EQ(form.number_of_darts(), 24U);
  EXPECT_EQ(form.number_of_flat_vertices(), 20U);
  std::set<std::uint32_t> corners;
  for (std::uint32_t d = 0; d < form.number_of_darts(); ++d) {
    EXPECT_EQ(form.squared_length(d), 1);
    EXPECT_EQ(form.next(form.next(form.next(form.next(d)))), d);
    EXPECT_EQ(form.opposite(form.opposite(d)), d);
    EXPECT_EQ(form.source(form.next(d)), form.source(form.opposite(d)));
    corners.insert(form.source(d));
  }
  EXPECT_EQ(corners.size(), 8U);
}

TEST(CanonicalForm, hashDependsOnTheSurfaceAlone) {
  std::set<std::uint64_t> hashes;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Triangles t = seed == 0 ? triangle_lists::box(1, 2, 3) : bumpy(seed);
    const std::uint64_t hash = hash_of(t);
    EXPECT_EQ(hash_of(t.renumbered(seed)), hash);
    EXPECT_EQ(hash_of(t.mirrored()), hash);
    EXPECT_EQ(hash_of(t.turned().turned()), hash);
    EXPECT_EQ(hash_of(t.scaled(4).scaled(0.25)), hash);
    EXPECT_NE(hash_of(t.scaled(2)), hash);
    Triangulation refined = t.triangulation();
    IT::delaunay_refine(refined);
    EXPECT_EQ(IT::canonical_form(refined).hash(), hash);
    const IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>,
                                      IT::Integer_coordinates>
        rounded(IT::Intrinsic_input(IT::Gluing_map(IT::gluing_from_triangles(
                                        static_cast<std::uint32_t>(t.points.size()), t.faces)),
                                    t.points));
    EXPECT_EQ(IT::canonical_form(rounded).hash(), hash);
    hashes.insert(hash);
  }
  EXPECT_EQ(hashes.size(), 20U);
}

TEST(CanonicalForm, ofSubdividedSurfacesIsThatOfTheSurface) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    const Triangles t = triangle_lists::box(1, 1 + seed % 3, 3);
    EXPECT_EQ(hash_of(t.divided(2 * seed, seed)), hash_of(t)) << "seed " << seed;
  }
}

// Of edges between planes whose areas have different square roots.
void expect_to_stay_when_divided(const Triangles& t, std::uint32_t seed) {
  const std::uint64_t hash = hash_of(t);
  const Triangles others[] = {t.quartered(), t.divided(t.faces.size() / 2, seed),
                              t.divided(6, seed).quartered()};
  for (const Triangles& other : others) {
    const IT::Canonical_form form = IT::canonical_form(other.renumbered(seed).triangulation());
    ASSERT_TRUE(form.is_unique()) << "seed " << seed << ": " << form.note();
    EXPECT_EQ(form.hash(), hash) << "seed " << seed;
  }
}

TEST(CanonicalForm, staysWhenEdgesAreDividedWhateverTheNumbering) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const int levels = seed < 2 ? 3 : 1;
    expect_to_stay_when_divided(bumpy(seed, levels).with_bits_after_the_point(10), seed);
  }
}

// A new vertex changes the triangles that lengths are computed from, but not the lengths.
void expect_to_stay_when_divided_once(const Triangles& t, std::uint32_t seed) {
  const IT::Canonical_form form = IT::canonical_form(t.triangulation());
  Triangles face = t, edge = t;
  face.split_face(seed % t.faces.size());
  edge.split_edge(seed % t.faces.size());
  for (const Triangles& other : {face, edge, t.divided(3, seed)}) {
    const IT::Canonical_form same = IT::canonical_form(other.renumbered(seed).triangulation());
    const IT::Isometries found = IT::find_isometries(form, same);
    EXPECT_EQ(found.answer(), IT::Isometry_answer::isometric) << seed << ": " << found.note();
    EXPECT_EQ(form.hash(), same.hash()) << seed;
  }
}

TEST(CanonicalForm, staysWhenAFaceOrAnEdgeIsDivided) {
  for (std::uint32_t seed = 0; seed < 20; ++seed)
    expect_to_stay_when_divided_once(bumpy(seed, 1).with_bits_after_the_point(20), 31 * seed);
}

// Random vertices of a bumpy sphere have irrational neighbours: lengths lie in a field of square
// roots.
TEST(CanonicalForm, provesLengthsInFieldsOfSquareRoots) {
  const Triangles t = bumpy(3);
  const Triangles u = t.renumbered(1).turned();
  const IT::Isometries found = IT::find_isometries(t.triangulation(), u.triangulation());
  EXPECT_EQ(found.answer(), IT::Isometry_answer::isometric) << found.note();
  EXPECT_EQ(found.count(), 1);
}

// A zigzag strip, whose edges cross triangle after triangle, each with a root of its own.
TEST(CanonicalForm, provesLengthsAcrossManyTriangles) {
  Triangles t;
  std::mt19937 random(3);
  const auto part = [&] { return static_cast<double>(random() % 4096) / 16384; };
  for (std::uint32_t i = 0; i < 400; ++i) {
    const double x = i * 0.5 + part(), y = i % 2 * 100000. + part();
    t.points.push_back({x, y, part()});
  }
  for (std::uint32_t i = 0; i + 2 < 400; ++i)
    t.faces.push_back({i, i + (i % 2 == 0 ? 2 : 1), i + (i % 2 == 0 ? 1 : 2)});
  const IT::Isometries found =
      IT::find_isometries(t.triangulation(), t.quartered().triangulation());
  EXPECT_EQ(found.answer(), IT::Isometry_answer::isometric) << found.note();
  EXPECT_EQ(found.count(), 1);
}

#ifdef INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR

TEST(CanonicalForm, isThatOfCopiesOfTheDataSet) {
  std::set<std::uint64_t> hashes;
  const char* const names[] = {"P",   "corner_with_hole", "cross", "corner", "elephant",
                               "mpi", "sphere966",        "star",  "tripod", "u"};
  for (const std::string name : names) {
    const IT::Triangle_soup soup =
        IT::read_triangle_soup(INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR "/" + name + ".off");
    const Triangles t{soup.points, soup.triangles};
    const IT::Canonical_form a = IT::canonical_form(t.triangulation()),
                             b = IT::canonical_form(t.renumbered(1).turned().triangulation());
    const IT::Isometries found = IT::find_isometries(a, b);
    EXPECT_EQ(found.answer(), IT::Isometry_answer::isometric) << name << ": " << found.note();
    EXPECT_EQ(a.hash(), b.hash()) << name;
    hashes.insert(a.hash());
  }
  EXPECT_EQ(hashes.size(), std::size(names));
}

// Its faces are long.
TEST(CanonicalForm, ofLongFacesStaysWhenEdgesAreDivided) {
  const IT::Triangle_soup soup =
      IT::read_triangle_soup(INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR "/u.off");
  const Triangles t{soup.points, soup.triangles};
  for (std::uint32_t seed = 0; seed < 3; ++seed)
    expect_to_stay_when_divided(t.with_bits_after_the_point(9), seed);
}

TEST(CanonicalForm, ofCopiesOfTheDataSetStaysWhenAFaceOrAnEdgeIsDivided) {
  for (const std::string name : {"u", "rotor"}) {
    const IT::Triangle_soup soup =
        IT::read_triangle_soup(INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR "/" + name + ".off");
    const Triangles t = Triangles{soup.points, soup.triangles}.with_bits_after_the_point(13);
    expect_to_stay_when_divided_once(t, 100);
  }
}

#endif

// The sides of a cube as grids: positions stay exact over thousands of moves.
TEST(CanonicalForm, ofAFineGridIsFound) {
  Triangles t = triangle_lists::box(32, 32, 32);
  for (int n = 0; n < 4; ++n) t = t.quartered();
  const IT::Canonical_form form = IT::canonical_form(t.renumbered(1).triangulation());
  EXPECT_EQ(form.number_of_flat_vertices(), t.points.size() - 8);
  EXPECT_EQ(form.number_of_darts(), 24U);
  for (std::uint32_t d = 0; d < form.number_of_darts(); ++d)
    EXPECT_EQ(form.squared_length(d), 32 * 32);
  EXPECT_EQ(form.hash(), hash_of(triangle_lists::box(32, 32, 32)));
}

// A cone, rolled from a triangle, with the middles of its folded side and of its border. Whatever is
// flipped first, one of them ends on a line between its neighbours, with an edge to itself.
TEST(CanonicalForm, ofAConeLosesFlatVertices) {
  gallery::Surface cone = gallery::abstract("cone", gallery::glue(1, {{0, 1}}), {}, {36, 36, 25});
  const std::uint64_t hash = IT::canonical_form(Triangulation(gallery::input(cone))).hash();
  gallery::Surface divided = gallery::abstract(
      "divided cone", gallery::glue(4, {{0, 10}, {1, 9}, {2, 8}, {4, 6}, {5, 11}}), {});
  divided.squared_length_of_side = {29.75, 9, 9, 6.25, 9, 9, 9, 6.25, 9, 9, 29.75, 9};
  const IT::Canonical_form form = IT::canonical_form(Triangulation(gallery::input(divided)));
  ASSERT_TRUE(form.is_unique()) << form.note();
  EXPECT_EQ(form.number_of_darts(), 3U);
  EXPECT_EQ(form.hash(), hash);
}

// Two cubes that touch in a corner.
TEST(CanonicalForm, keepsVerticesWhereFansMeet) {
  Triangles t = triangle_lists::box(1, 1, 1);
  for (const std::array<std::uint32_t, 3>& f : triangle_lists::box(1, 1, 1).faces) {
    const auto at = [](std::uint32_t v) { return v == 0 ? 0 : v + 7; };
    t.faces.push_back({at(f[0]), at(f[1]), at(f[2])});
  }
  for (std::size_t v = 1; v < 8; ++v)
    t.points.push_back({-t.points[v][0], -t.points[v][1], -t.points[v][2]});
  const IT::Isometries found =
      IT::find_isometries(t.triangulation(), t.renumbered(2).triangulation());
  EXPECT_EQ(found.answer(), IT::Isometry_answer::isometric) << found.note();
  EXPECT_EQ(found.count(), 6 * 6 * 2);
}

// Two tetrahedra that share two vertices, in one of two ways.
TEST(CanonicalForm, seesWhichVerticesFansShare) {
  std::array<double, 6> squared{16, 17, 18, 19, 20, 21}; // of 01, 02, 03, 12, 13, 23: no symmetry
  const auto two = [&](std::uint32_t of_first, std::uint32_t of_second) {
    const std::array<std::uint32_t, 8> number{0, 1, 2, 3, of_first, of_second, 4, 5};
    IT::Gluing g;
    g.number_of_vertices = 6;
    std::vector<double> sides;
    const std::array<std::uint32_t, 12> corners{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    for (std::uint32_t h = 0; h < 24; ++h) {
      const std::uint32_t own = h % 12, i = corners[own], j = corners[IT::Gluing::next(own)];
      g.origin.push_back(number[h - own == 0 ? i : 4 + i]);
      sides.push_back(squared[std::min(i, j) == 0 ? std::max(i, j) - 1 : i + j]);
      for (std::uint32_t o = 0; o < 12; ++o)
        if (corners[o] == j && corners[IT::Gluing::next(o)] == i) g.glue.push_back(h - own + o);
    }
    gallery::Surface s{"two tetrahedra", g, {}, sides};
    return Triangulation(gallery::input(s));
  };
  const Triangulation a = two(0, 1), b = two(1, 0);
  EXPECT_EQ(IT::find_isometries(a, b).answer(), IT::Isometry_answer::not_isometric);
  const IT::Isometries same = IT::find_isometries(a, two(0, 1));
  EXPECT_EQ(same.answer(), IT::Isometry_answer::isometric);
  EXPECT_EQ(same.count(), 2);
  // of the regular one, 4 symmetries keep two vertices together, 2 of them both vertices
  squared.fill(16);
  const Triangulation c = two(0, 1);
  const IT::Isometries regular = IT::find_isometries(c, c);
  EXPECT_EQ(regular.count(), 2 * (2 * 2 + 2 * 2));
  std::set<std::vector<std::uint32_t>> maps;
  for (std::size_t i = 0; i < regular.size(); ++i) {
    const IT::Isometry map = regular[i];
    std::vector<std::uint32_t> images;
    for (std::uint32_t v = 0; v < 6; ++v) images.push_back(map.image_of_vertex(v));
    maps.insert(images);
  }
  EXPECT_EQ(maps.size(), regular.size());
}

// ---- all gluings of few triangles ---------------------------------------------------------------

// The symmetries of equilateral triangles that are glued, by trying all maps of halfedges.
int symmetries_of(const IT::Gluing_map& mesh) {
  using Halfedge = IT::Gluing_map::Halfedge;
  const std::uint32_t n = mesh.number_of_halfedges();
  int count = 0;
  for (const bool is_mirrored : {false, true})
    for (std::uint32_t to = 0; to < n; ++to) {
      std::vector<std::uint32_t> image(n, n), stack{0};
      image[0] = to;
      bool fits = true;
      while (fits && !stack.empty()) {
        const std::uint32_t h = stack.back(), e = image[h];
        stack.pop_back();
        const std::uint32_t after = mesh.next(Halfedge{e}).index,
                            before = mesh.previous(Halfedge{e}).index;
        const std::pair<std::uint32_t, std::uint32_t> steps[] = {
            {h ^ 1U, e ^ 1U}, {mesh.next(Halfedge{h}).index, is_mirrored ? before : after}};
        for (const auto& [x, y] : steps) {
          if (image[x] == n) {
            image[x] = y;
            stack.push_back(x);
          }
          fits = fits && image[x] == y;
        }
      }
      count += fits ? 1 : 0;
    }
  return count;
}

std::vector<std::size_t> sorted_degrees(const IT::Gluing_map& mesh) {
  std::vector<std::size_t> degree(mesh.number_of_vertices(), 0);
  for (std::uint32_t h = 0; h < mesh.number_of_halfedges(); ++h)
    ++degree[mesh.target(IT::Gluing_map::Halfedge{h}).index];
  std::sort(degree.begin(), degree.end());
  return degree;
}

bool is_connected_without_flat_vertex(const IT::Gluing_map& mesh) {
  const std::vector<std::size_t> degree = sorted_degrees(mesh);
  if (std::count(degree.begin(), degree.end(), 6) > 0) return false;
  std::set<std::uint32_t> reached{0};
  for (std::uint32_t k = 0; k < mesh.number_of_faces(); ++k)
    for (std::uint32_t h = 0; h < mesh.number_of_halfedges(); ++h)
      if (reached.count(mesh.face(IT::Gluing_map::Halfedge{h}).index) != 0)
        reached.insert(mesh.face(IT::Gluing_map::Halfedge{h ^ 1U}).index);
  return reached.size() == mesh.number_of_faces();
}

// Calls a function with each way to glue all sides in pairs.
template <class Visit>
void for_each_gluing(std::vector<std::uint32_t> sides, std::vector<gallery::Glued>& pairs,
                     const Visit& visit) {
  if (sides.empty()) return visit(pairs);
  const std::uint32_t first = sides.back();
  sides.pop_back();
  for (std::size_t k = 0; k < sides.size(); ++k) {
    std::vector<std::uint32_t> rest = sides;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(k));
    pairs.push_back({first, sides[k]});
    for_each_gluing(rest, pairs, visit);
    pairs.pop_back();
  }
}

TEST(CanonicalForm, findsTheSymmetriesOfAllSmallGluings) {
  std::size_t compared = 0, number = 0;
  std::set<std::vector<std::size_t>> degrees;
  std::set<std::uint64_t> hashes;
  for (const std::uint32_t faces : {2U, 4U}) {
    std::vector<std::uint32_t> sides(3 * faces);
    std::iota(sides.begin(), sides.end(), 0U);
    std::vector<gallery::Glued> pairs;
    for_each_gluing(sides, pairs, [&](const std::vector<gallery::Glued>& all) {
      if (faces == 4 && number++ % 5 != 0) return;
      const gallery::Surface s = gallery::abstract("gluing", gallery::glue(faces, all), {});
      const IT::Gluing_map mesh(s.gluing);
      if (!is_connected_without_flat_vertex(mesh)) return;
      const IT::Canonical_form form = IT::canonical_form(Triangulation(gallery::input(s)));
      const IT::Isometries found = IT::find_isometries(form, form);
      ASSERT_EQ(found.answer(), IT::Isometry_answer::isometric) << found.note();
      ASSERT_EQ(found.count(), symmetries_of(mesh));
      ++compared;
      degrees.insert(sorted_degrees(mesh));
      hashes.insert(form.hash());
    });
  }
  EXPECT_GT(compared, 500U);
  EXPECT_GE(hashes.size(), degrees.size());
}

} // namespace
