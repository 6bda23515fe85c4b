// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_GALLERY_IMPL_H
#define TEST_INTRINSIC_TRIANGULATIONS_GALLERY_IMPL_H

#include "gallery.h"
#include "shared_meshes.h"

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace gallery {

TEST_MESHES_INLINE Gluing glue(std::uint32_t faces, const std::vector<Glued>& pairs) {
  Gluing g;
  g.origin.resize(3 * static_cast<std::size_t>(faces));
  g.glue.assign(g.origin.size(), Gluing::none);
  std::vector<std::uint32_t> parent(g.origin.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&parent](std::uint32_t c) {
    while (parent[c] != c) c = parent[c];
    return c;
  };
  const auto identify = [&](std::uint32_t a, std::uint32_t b) { parent[root(a)] = root(b); };
  for (const auto& [a, b, reversed] : pairs) {
    g.glue[a] = reversed ? Gluing::reversed(b) : b;
    g.glue[b] = reversed ? Gluing::reversed(a) : a;
    identify(a, reversed ? b : Gluing::next(b));
    identify(Gluing::next(a), reversed ? Gluing::next(b) : b);
  }
  std::vector<std::uint32_t> number(g.origin.size(), Gluing::none);
  for (std::uint32_t c = 0; c < g.origin.size(); ++c) {
    std::uint32_t& n = number[root(c)];
    if (n == Gluing::none) n = g.number_of_vertices++;
    g.origin[c] = n;
  }
  return g;
}

TEST_MESHES_INLINE Surface embedded(const std::string& name, std::vector<Point> points,
                                    const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                    const Counts& expected) {
  Surface s{name,
            CGAL::Intrinsic_triangulations::gluing_from_triangles(
                static_cast<std::uint32_t>(points.size()), triangles),
            expected,
            {},
            std::move(points)};
  for (std::uint32_t h = 0; h < s.gluing.origin.size(); ++h) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double d =
          s.points[s.gluing.origin[h]][k] - s.points[s.gluing.origin[Gluing::next(h)]][k];
      sum += d * d;
    }
    s.squared_length_of_side.push_back(sum);
  }
  return s;
}

TEST_MESHES_INLINE Surface abstract(const std::string& name, Gluing g, const Counts& expected,
                                    const std::array<double, 3>& sides) {
  Surface s{name, std::move(g), expected, {}, {}};
  for (std::size_t h = 0; h < s.gluing.origin.size(); ++h)
    s.squared_length_of_side.push_back(sides[h % 3]);
  return s;
}

TEST_MESHES_INLINE std::vector<double> squared_lengths(const Surface& s) {
  const Gluing_map map(s.gluing);
  std::vector<double> lengths(map.number_of_edges());
  for (std::uint32_t f = 0; f < map.number_of_faces(); ++f) {
    Gluing_map::Halfedge h = map.halfedge(Gluing_map::Face{f});
    for (std::uint32_t k = 0; k < 3; ++k, h = map.next(h))
      lengths[h.index / 2] = s.squared_length_of_side[3 * f + k];
  }
  return lengths;
}

TEST_MESHES_INLINE Surface one_vertex_torus() {
  return abstract("one-vertex torus", glue(2, {{0, 3}, {1, 4}, {2, 5}}), {1, 3, 2, 0, 1, 1},
                  {1, 1, 2});
}

TEST_MESHES_INLINE Surface flat_torus(std::uint32_t n, std::uint32_t m) {
  std::vector<Glued> pairs;
  const auto cell = [&](std::uint32_t i, std::uint32_t j) { return 6 * (i % n + n * (j % m)); };
  for (std::uint32_t j = 0; j < m; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      pairs.push_back({cell(i, j + 1), cell(i, j) + 3});
      pairs.push_back({cell(i, j) + 1, cell(i + 1, j) + 4});
      pairs.push_back({cell(i, j) + 2, cell(i, j) + 5});
    }
  return abstract("flat torus", glue(2 * n * m, pairs), {n * m, 3 * n * m, 2 * n * m, 0, 1, 1},
                  {1, 1, 2});
}

TEST_MESHES_INLINE Surface triangle_pillow() {
  return abstract("two triangles sharing three edges", glue(2, {{0, 3}, {1, 5}, {2, 4}}),
                  {3, 3, 2, 0});
}

TEST_MESHES_INLINE Surface tetrahedron() {
  return embedded("tetrahedron", {{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}},
                  {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, {4, 6, 4, 0});
}

TEST_MESHES_INLINE Surface tetrahedron_that_embeds_nowhere() {
  Surface s = tetrahedron();
  s.name = "tetrahedron that embeds nowhere";
  s.points.clear();
  for (std::uint32_t h = 0; h < s.gluing.origin.size(); ++h)
    s.squared_length_of_side[h] =
        s.gluing.origin[h] == 3 || s.gluing.origin[Gluing::next(h)] == 3 ? 0.3125 : 1;
  return s;
}

TEST_MESHES_INLINE Surface doubled_self_folded_cone() {
  return abstract("doubled self-folded cone", glue(2, {{1, 2}, {4, 5}, {0, 3}}), {3, 3, 2, 0});
}

TEST_MESHES_INLINE Surface octagon_of_genus_2() {
  Surface s = abstract(
      "genus 2 from an octagon",
      glue(6, {{2, 3}, {5, 6}, {8, 9}, {11, 12}, {14, 15}, {0, 4}, {1, 7}, {10, 16}, {13, 17}}),
      {1, 9, 6, 0, 1, 2});
  const auto chord = [](std::uint32_t k) { // over k eighths of the circle
    const double x = 2 * std::sin(std::min(k, 8 - k) * 3.14159265358979323846 / 8);
    return x * x;
  };
  for (std::uint32_t f = 0; f < 6; ++f) { // corners 0, f + 1, f + 2 of the octagon
    s.squared_length_of_side[3 * f] = chord(f + 1);
    s.squared_length_of_side[3 * f + 1] = chord(1);
    s.squared_length_of_side[3 * f + 2] = chord(f + 2);
  }
  return s;
}

TEST_MESHES_INLINE Surface triangle() {
  return embedded("triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {3, 3, 1, 1});
}

TEST_MESHES_INLINE Surface self_folded_cone() {
  return abstract("self-folded cone", glue(1, {{1, 2}}), {2, 2, 1, 1});
}

TEST_MESHES_INLINE Surface self_folded_in_a_digon() {
  return abstract("self-folded triangle in a digon", glue(2, {{1, 2}, {0, 3}}), {3, 4, 2, 1});
}

TEST_MESHES_INLINE Surface two_triangles_sharing_two_edges() {
  return abstract("two bordered triangles sharing two edges", glue(2, {{0, 3}, {1, 5}}),
                  {3, 4, 2, 1});
}

TEST_MESHES_INLINE Surface disc_fan(std::uint32_t n) {
  std::vector<Point> points{{0, 0, 0}};
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / n;
    points.push_back({std::cos(angle), std::sin(angle), 0});
    triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  return embedded("disc fan", points, triangles, {n + 1, 2 * n, n, 1});
}

TEST_MESHES_INLINE Surface annulus(std::uint32_t n) {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / n;
    points.push_back({std::cos(angle), std::sin(angle), 0});
    points.push_back({2 * std::cos(angle), 2 * std::sin(angle), 0});
    const std::uint32_t in = 2 * i, out = in + 1, next_in = 2 * ((i + 1) % n);
    triangles.push_back({in, out, next_in + 1});
    triangles.push_back({next_in + 1, next_in, in});
  }
  return embedded("annulus", points, triangles, {2 * n, 4 * n, 2 * n, 2});
}

TEST_MESHES_INLINE Surface moebius_strip(std::uint32_t n) {
  std::vector<Glued> pairs;
  for (std::uint32_t i = 0; i < n; ++i) {
    pairs.push_back({6 * i + 2, 6 * i + 5});
    pairs.push_back({6 * i + 1, 6 * ((i + 1) % n) + 4, i + 1 == n});
  }
  return abstract("Moebius strip", glue(2 * n, pairs), {2 * n, 4 * n, 2 * n, 1, 1, 0, 0, 0, false},
                  {1, 1, 2});
}

TEST_MESHES_INLINE Surface moebius_triangle() {
  return abstract("Moebius strip of one triangle", glue(1, {{0, 1, true}}),
                  {1, 2, 1, 1, 1, 0, 0, 0, false});
}

TEST_MESHES_INLINE Surface klein_bottle() {
  return abstract("Klein bottle", glue(2, {{0, 3, true}, {1, 4}, {2, 5}}),
                  {1, 3, 2, 0, 1, 0, 0, 0, false}, {1, 1, 2});
}

TEST_MESHES_INLINE Surface projective_plane() {
  return abstract("projective plane", glue(2, {{0, 3, true}, {1, 4, true}, {2, 5}}),
                  {2, 3, 2, 0, 1, 0, 0, 0, false}, {1, 1, 2});
}

TEST_MESHES_INLINE Surface two_tetrahedra_sharing_a_vertex() {
  return embedded(
      "two tetrahedra sharing a vertex",
      {{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {-1, -1, 0}, {-1, 0, -1}, {0, -1, -1}},
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 4, 5}, {0, 6, 4}, {4, 6, 5}, {5, 6, 0}},
      {7, 12, 8, 0, 2, 0, 1});
}

TEST_MESHES_INLINE Surface bow_tie() {
  return embedded("two triangles sharing a vertex",
                  {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}},
                  {{0, 1, 2}, {0, 3, 4}}, {5, 6, 2, 2, 2, 0, 1});
}

TEST_MESHES_INLINE Surface two_fans_and_an_isolated_vertex() {
  return embedded(
      "two fans at one vertex and an isolated vertex",
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 5, 5}, {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}},
      {{0, 1, 2}, {0, 2, 3}, {0, 5, 6}, {0, 6, 7}}, {8, 10, 4, 2, 2, 0, 1, 1});
}

TEST_MESHES_INLINE std::vector<Surface> all() {
  return {one_vertex_torus(),
          flat_torus(1, 1),
          flat_torus(2, 1),
          flat_torus(4, 3),
          triangle_pillow(),
          tetrahedron(),
          tetrahedron_that_embeds_nowhere(),
          doubled_self_folded_cone(),
          octagon_of_genus_2(),
          triangle(),
          self_folded_cone(),
          self_folded_in_a_digon(),
          two_triangles_sharing_two_edges(),
          disc_fan(5),
          annulus(4),
          moebius_strip(1),
          moebius_strip(5),
          moebius_triangle(),
          klein_bottle(),
          projective_plane(),
          two_tetrahedra_sharing_a_vertex(),
          bow_tie(),
          two_fans_and_an_isolated_vertex()};
}

TEST_MESHES_INLINE std::vector<Surface> oriented() {
  std::vector<Surface> selected;
  for (const Surface& s : all())
    if (s.expected.is_orientable) selected.push_back(s);
  return selected;
}

} // namespace gallery

#endif // TEST_INTRINSIC_TRIANGULATIONS_GALLERY_IMPL_H
