// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "subdivisions.h"

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/intrinsic_face_colors.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Subdivision = IT::Common_subdivision;
using Path = std::vector<std::uint32_t>;

Path path(const IT::Edge_polylines& lines, std::size_t e) {
  return {lines[e].begin(), lines[e].end()};
}

// side, from smaller to greater vertex
using Edge = std::array<std::uint32_t, 4>;
Edge edge(std::uint32_t a, std::uint32_t b, const Subdivision::Side& side) {
  return {std::min(a, b), std::max(a, b), side.input_edge, side.intrinsic_edge};
}

std::map<Edge, int> visited_edges(const Subdivision& s) {
  std::map<Edge, int> result;
  IT::for_each_subdivision_edge(s,
                                [&](std::uint32_t a, std::uint32_t b,
                                    const Subdivision::Side& side) { ++result[edge(a, b, side)]; });
  return result;
}

std::map<Edge, int> side_counts(const Subdivision& s) {
  std::map<Edge, int> result;
  for (std::size_t f = 0; f < s.number_of_faces(); ++f)
    for (std::size_t k = 0; k < s.face(f).size(); ++k)
      ++result[edge(s.face(f)[k], s.face(f)[(k + 1) % s.face(f).size()], s.sides(f)[k])];
  return result;
}

} // namespace

TEST(Edge_polylines, Run_from_the_first_end_over_the_crossing_to_the_second) {
  const Subdivision s = subdivisions::grid(1);
  const IT::Edge_polylines lines = IT::intrinsic_edge_polylines(s);
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(path(lines, 0), (Path{0, 1}));
  EXPECT_EQ(path(lines, 1), (Path{2, 3}));
  EXPECT_EQ(path(lines, 4), (Path{2, 4, 1})) << "its location is from vertex 2 to vertex 1";
}

TEST(Edge_polylines, Of_loops_pass_all_crossings_in_the_order_of_their_parameters) {
  for (int k = 2; k <= 12; ++k) {
    const Subdivision s = subdivisions::Torus(k).s;
    const IT::Edge_polylines lines = IT::intrinsic_edge_polylines(s);
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(path(lines, 0), (Path{0, 0}));
    for (const std::size_t e : {1u, 2u}) {
      // interior crossings of (m, 1) with (0, 1) and (1, 1): m - 1 and m - 2
      const int m = e == 1 ? k : k + 1;
      const Path p = path(lines, e);
      ASSERT_EQ(p.size(), static_cast<std::size_t>(2 * m - 1));
      EXPECT_EQ(p.front(), 0u);
      EXPECT_EQ(p.back(), 0u);
      double previous = 0;
      for (std::size_t i = 1; i + 1 < p.size(); ++i) {
        const Subdivision::Edge_point& x = s.crossings[p[i] - 1].on_intrinsic;
        EXPECT_EQ(x.edge, e);
        EXPECT_GT(x.parameter, previous);
        previous = x.parameter;
      }
    }
  }
}

TEST(Edge_polylines, Are_empty_for_numbers_that_no_edge_has) {
  Subdivision s = subdivisions::tetrahedron();
  for (Subdivision::Side& side : s.side) side.intrinsic_edge += 3;
  const IT::Edge_polylines lines = IT::intrinsic_edge_polylines(s);
  ASSERT_EQ(lines.size(), 9u);
  for (std::size_t e = 0; e < 3; ++e) EXPECT_TRUE(lines[e].empty());
  EXPECT_EQ(path(lines, 8), (Path{2, 3}));
}

TEST(Edge_polylines, Of_nothing_are_none) {
  EXPECT_EQ(IT::intrinsic_edge_polylines(Subdivision()).size(), 0u);
}

TEST(Input_edge_polylines, Run_from_the_first_end_over_the_crossing_to_the_second) {
  const Subdivision s = subdivisions::grid(1);
  const IT::Edge_polylines lines = IT::input_edge_polylines(s);
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(path(lines, 0), (Path{0, 1}));
  EXPECT_EQ(path(lines, 1), (Path{2, 3}));
  EXPECT_EQ(path(lines, 4), (Path{0, 4, 3})) << "the other diagonal";
  Subdivision turned = s;
  std::swap(turned.crossings[0].on_input.vertices[0], turned.crossings[0].on_input.vertices[1]);
  EXPECT_EQ(path(IT::input_edge_polylines(turned), 4), (Path{3, 4, 0}));
}

TEST(Input_edge_polylines, Of_loops_pass_all_crossings_in_the_order_of_their_parameters) {
  for (int k = 2; k <= 12; ++k) {
    const Subdivision s = subdivisions::Torus(k).s;
    const IT::Edge_polylines lines = IT::input_edge_polylines(s);
    ASSERT_EQ(lines.size(), 3u);
    std::size_t crossings = 0;
    for (std::size_t e = 0; e < 3; ++e) {
      const Path p = path(lines, e);
      EXPECT_EQ(p.front(), 0u);
      EXPECT_EQ(p.back(), 0u);
      crossings += p.size() - 2;
      double previous = 0;
      for (std::size_t i = 1; i + 1 < p.size(); ++i) {
        const Subdivision::Edge_point& x = s.crossings[p[i] - 1].on_input;
        EXPECT_EQ(x.edge, e);
        EXPECT_GT(x.parameter, previous);
        previous = x.parameter;
      }
    }
    EXPECT_EQ(crossings, s.crossings.size());
  }
}

TEST(Input_edge_polylines, Are_empty_for_numbers_that_no_edge_has) {
  Subdivision s = subdivisions::tetrahedron();
  for (Subdivision::Side& side : s.side) side.input_edge += 3;
  const IT::Edge_polylines lines = IT::input_edge_polylines(s);
  ASSERT_EQ(lines.size(), 9u);
  for (std::size_t e = 0; e < 3; ++e) EXPECT_TRUE(lines[e].empty());
  EXPECT_EQ(path(lines, 8), (Path{2, 3}));
  EXPECT_EQ(IT::input_edge_polylines(Subdivision()).size(), 0u);
}

// In a valid subdivision every interior edge has two sides, and every edge of the border has one.
// Two loops with one crossing each may give several edges with the same ends and labels.
TEST(For_each_subdivision_edge, Visits_each_edge_once) {
  for (const Subdivision& s : {subdivisions::grid(5), subdivisions::tetrahedron(),
                               subdivisions::Torus(2).s, subdivisions::Torus(9).s}) {
    const std::map<Edge, int> visits = visited_edges(s), sides = side_counts(s);
    ASSERT_EQ(visits.size(), sides.size());
    for (const auto& [e, count] : sides) EXPECT_EQ(visits.at(e), (count + 1) / 2);
  }
}

TEST(For_each_subdivision_edge, Counts_the_edges_that_Euler_counts) {
  const auto euler = [](const Subdivision& s) {
    int edges = 0;
    for (const auto& [e, count] : visited_edges(s)) edges += count;
    return static_cast<int>(s.number_of_vertices()) - edges + static_cast<int>(s.number_of_faces());
  };
  EXPECT_EQ(euler(subdivisions::grid(4)), 1);
  EXPECT_EQ(euler(subdivisions::tetrahedron()), 2);
  for (int k = 2; k < 9; ++k) EXPECT_EQ(euler(subdivisions::Torus(k).s), 0);
}

TEST(Intrinsic_face_colors, Differ_across_every_intrinsic_edge) {
  for (const Subdivision& s :
       {subdivisions::grid(40), subdivisions::tetrahedron(), subdivisions::Torus(5).s}) {
    const std::vector<IT::Rgb_color> colors = IT::intrinsic_face_colors(s);
    std::map<std::uint32_t, std::uint32_t> face_at;
    for (std::size_t f = 0; f < s.number_of_faces(); ++f)
      for (const Subdivision::Side& side : s.sides(f)) {
        if (side.intrinsic_edge == Subdivision::none) continue;
        const auto [it, is_new] = face_at.emplace(side.intrinsic_edge, s.intrinsic_face[f]);
        if (it->second == s.intrinsic_face[f]) continue;
        EXPECT_NE(colors[it->second], colors[s.intrinsic_face[f]]);
      }
  }
}
