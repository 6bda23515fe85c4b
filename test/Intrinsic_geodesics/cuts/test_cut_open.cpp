// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_open.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include "gallery.h"
#include "glue_back.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Gluing;

// For each corner the least one that is joined to it across sides that are glued and not cut, until
// nothing changes, instead of walks: the vertices of the opened surface are what this makes of
// corners.
std::vector<std::uint32_t> fans(const Gluing& g, const std::vector<char>& is_cut) {
  std::vector<std::uint32_t> least(g.origin.size());
  std::iota(least.begin(), least.end(), 0U);
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    const auto join = [&](std::uint32_t i, std::uint32_t j) {
      has_changed = has_changed || least[i] != least[j];
      least[i] = least[j] = std::min(least[i], least[j]);
    };
    for (std::uint32_t h = 0; h < g.glue.size(); ++h) {
      const std::uint32_t p = Gluing::partner(g.glue[h]);
      if (p == Gluing::none || is_cut[h] != 0 || is_cut[p] != 0) continue;
      const bool is_reversed = Gluing::is_reversed(g.glue[h]);
      join(h, is_reversed ? p : Gluing::next(p));
      join(Gluing::next(h), is_reversed ? Gluing::next(p) : p);
    }
  }
  return least;
}

void expect_opened(const Gluing& g, const std::vector<char>& is_cut) {
  const IT::Opened_surface s = IT::cut_open(g, is_cut);
  IT::validate(s.gluing);
  const std::vector<std::uint32_t> fan = fans(g, is_cut);
  for (std::size_t c = 0; c < fan.size(); ++c) {
    EXPECT_EQ(s.gluing.origin[c], s.gluing.origin[fan[c]]);
    EXPECT_EQ(s.original_vertex[s.gluing.origin[c]], g.origin[c]);
  }
  const std::size_t isolated =
      g.number_of_vertices - std::set<std::uint32_t>(g.origin.begin(), g.origin.end()).size();
  EXPECT_EQ(s.gluing.number_of_vertices,
            isolated + std::set<std::uint32_t>(fan.begin(), fan.end()).size());
  EXPECT_EQ(s.original_vertex.size(), s.gluing.number_of_vertices);
  std::size_t cuts = 0;
  for (std::uint32_t h = 0; h < g.glue.size(); ++h) {
    const std::uint32_t p = Gluing::partner(g.glue[h]);
    const bool opens = p != Gluing::none && (is_cut[h] != 0 || is_cut[p] != 0);
    EXPECT_EQ(s.gluing.glue[h], opens ? Gluing::none : g.glue[h]);
    cuts += opens && h < p ? 1 : 0;
  }
  EXPECT_EQ(s.seams.size(), cuts);
  const Gluing back = cuts::glue_back(s);
  EXPECT_EQ(back.origin, g.origin);
  EXPECT_EQ(back.glue, g.glue);
  EXPECT_EQ(back.number_of_vertices, g.number_of_vertices);
}

TEST(Cut_open, gives_each_fan_a_vertex_and_is_undone_by_gluing_back_on_the_whole_gallery) {
  std::mt19937 random(11);
  for (const gallery::Surface& s : gallery::all()) {
    SCOPED_TRACE(s.name);
    for (const double part : {0., 0.2, 0.5, 0.8, 1.})
      for (int round = 0; round < 5; ++round) {
        std::vector<char> is_cut(s.gluing.origin.size(), 0);
        for (char& c : is_cut) c = std::bernoulli_distribution(part)(random) ? 1 : 0;
        expect_opened(s.gluing, is_cut);
      }
  }
}

TEST(Cut_open, leaves_a_manifold_surface_as_it_is_without_cuts_and_triangles_if_all_is_cut) {
  for (const gallery::Surface& s : gallery::all()) {
    SCOPED_TRACE(s.name);
    const std::size_t sides = s.gluing.origin.size();
    const IT::Opened_surface whole = IT::cut_open(s.gluing, std::vector<char>(sides, 0));
    if (s.expected.nonmanifold_vertices == 0) {
      EXPECT_EQ(whole.gluing.origin, s.gluing.origin);
    }
    const IT::Opened_surface all = IT::cut_open(s.gluing, std::vector<char>(sides, 1));
    EXPECT_EQ(all.gluing.number_of_vertices, sides + s.expected.isolated_vertices);
    EXPECT_EQ(IT::connected_components(IT::Gluing_map(all.gluing)).count, sides / 3);
  }
}

TEST(Cut_open, makes_as_many_vertices_as_cuts_meet_inside_and_one_more_on_the_border) {
  const Gluing fan = gallery::disc_fan(8).gluing;
  std::vector<std::uint32_t> count(fan.number_of_vertices, 0);
  for (const std::uint32_t v : fan.origin) ++count[v];
  const auto centre = static_cast<std::uint32_t>(std::ranges::max_element(count) - count.begin());
  std::vector<std::uint32_t> spokes;
  for (std::uint32_t h = 0; h < fan.origin.size(); ++h)
    if (fan.origin[h] == centre) spokes.push_back(h);
  for (std::size_t n = 0; n <= spokes.size(); ++n) {
    std::vector<char> is_cut(fan.origin.size(), 0);
    for (std::size_t i = 0; i < n; ++i) is_cut[spokes[i]] = 1;
    const IT::Opened_surface s = IT::cut_open(fan, is_cut);
    const auto copies = [&](std::uint32_t v) {
      return static_cast<std::size_t>(std::ranges::count(s.original_vertex, v));
    };
    EXPECT_EQ(copies(centre), std::max<std::size_t>(n, 1));
    for (std::size_t i = 0; i < spokes.size(); ++i)
      EXPECT_EQ(copies(fan.origin[Gluing::next(spokes[i])]), i < n ? 2U : 1U);
    EXPECT_EQ(IT::connected_components(IT::Gluing_map(s.gluing)).count,
              std::max<std::size_t>(n, 1));
  }
}

TEST(Cut_open, makes_a_disk_of_surfaces_that_are_cut_along_all_edges_across_no_dual_tree) {
  for (const gallery::Surface& s : gallery::all()) {
    if (s.expected.components != 1 || s.expected.isolated_vertices != 0) continue;
    SCOPED_TRACE(s.name);
    std::vector<char> is_cut(s.gluing.origin.size(), 1), is_reached(s.gluing.number_of_faces(), 0);
    std::vector<std::uint32_t> stack{0};
    is_reached[0] = 1;
    while (!stack.empty()) {
      const std::uint32_t f = stack.back();
      stack.pop_back();
      for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
        const std::uint32_t p = Gluing::partner(s.gluing.glue[h]);
        if (p == Gluing::none || is_reached[p / 3] != 0) continue;
        is_reached[p / 3] = 1;
        is_cut[h] = is_cut[p] = 0;
        stack.push_back(p / 3);
      }
    }
    const IT::Gluing_map disk(IT::cut_open(s.gluing, is_cut).gluing);
    EXPECT_EQ(IT::euler_characteristic(disk), 1);
    EXPECT_EQ(IT::boundary_loops(disk).size(), 1U);
    EXPECT_EQ(IT::connected_components(disk).count, 1U);
    EXPECT_TRUE(IT::is_orientable(disk));
  }
}

TEST(Cut_open, names_the_sides_of_a_triangulation_by_its_halfedges) {
  IT::Corresponding_triangulation t(meshes::potato(2, 5).input());
  IT::flip_to_delaunay(t);
  IT::Marked_edges marked(t);
  std::mt19937 random(3);
  for (const auto e : edges(t.mesh())) put(marked, e, std::bernoulli_distribution(0.3)(random));
  const IT::Opened_surface s = IT::cut_open(t, marked);
  ASSERT_EQ(s.gluing.number_of_faces(), num_faces(t.mesh()));
  for (const auto h : halfedges(t.mesh())) {
    const std::uint32_t side = s.side[t.numbers().halfedge(h)];
    EXPECT_EQ(s.original_vertex[s.gluing.origin[side]], t.index(source(h, t.mesh())));
    EXPECT_EQ(s.gluing.glue[side] == Gluing::none, get(marked, edge(h, t.mesh())));
    EXPECT_EQ(s.side[t.numbers().halfedge(next(h, t.mesh()))], Gluing::next(side));
  }
}

TEST(Cut_open, refuses_marks_that_are_too_few) {
  EXPECT_THROW(IT::cut_open(gallery::triangle().gluing, {1}), IT::Invalid_input);
}

} // namespace
