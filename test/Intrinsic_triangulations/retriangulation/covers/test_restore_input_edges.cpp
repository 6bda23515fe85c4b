// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "soups.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/covers/restore_input_edges.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using meshes::Mesh;
using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                          IT::Integer_coordinates>;

// a long edge between points close above it and close below it, and fans from its start to them
Mesh edge_in_zigzag(std::uint32_t n) {
  Mesh m;
  m.points = {{0, 0, 0}, {2. * n + 1, 0, 0}};
  for (std::uint32_t i = 0; i < n; ++i) m.points.push_back({2. * i + 1, 0.6, 0});
  for (std::uint32_t i = 0; i < n; ++i) m.points.push_back({2. * i + 2, -0.7, 0});
  m.triangles = {{0, 1, n + 1}, {0, 2 * n + 1, 1}};
  for (std::uint32_t i = 0; i + 1 < n; ++i) {
    m.triangles.push_back({0, i + 3, i + 2});
    m.triangles.push_back({0, n + i + 2, n + i + 3});
  }
  return m;
}

std::uint32_t first_edge(const Exact& t) {
  for (std::uint32_t h = 0; h < t.input().number_of_halfedges(); ++h)
    if (t.input().names().row(t.input().source(h)) == 0 &&
        t.input().names().row(t.input().target(h)) == 1)
      return h;
  return IT::Gluing::none;
}

IT::Restored_edges restore(Exact& t, std::uint32_t x) {
  std::vector<char> is_wanted(t.input().number_of_edges());
  is_wanted[x / 2] = 1;
  return IT::restore_input_edges(t, is_wanted);
}

// how many edges run along an input edge
std::ptrdiff_t edges_along(const Exact& t, std::uint32_t x) {
  const auto& c = t.correspondence();
  return std::ranges::count_if(edges(t.mesh()), [&](const auto& e) {
    const std::uint32_t i = t.index(e);
    return c.normal_coordinate(i) < 0 && c.fans().halfedge(c.roundabout(2 * i)) / 2 == x / 2;
  });
}

TEST(Restore_input_edge, straightens_zigzags) {
  for (const std::uint32_t n : {1U, 2U, 3U, 10U, 50U}) {
    Exact t(soups::soup(edge_in_zigzag(n)));
    IT::flip_to_delaunay(t);
    const std::uint32_t x = first_edge(t);
    EXPECT_EQ(edges_along(t, x), 0) << n;
    const IT::Restored_edges restored = restore(t, x);
    EXPECT_EQ(restored.missing, IT::Gluing::none) << n;
    EXPECT_EQ(edges_along(t, x), 1) << n;
    EXPECT_GT(restored.flips, 0U) << n;
  }
}

TEST(Restore_input_edge, leaves_an_edge_alone_that_is_there) {
  Exact t(soups::soup(edge_in_zigzag(5)));
  const std::uint32_t x = first_edge(t);
  EXPECT_EQ(restore(t, x).missing, IT::Gluing::none);
  EXPECT_EQ(edges_along(t, x), 1);
  const IT::Restored_edges again = restore(t, x);
  EXPECT_EQ(again.missing, IT::Gluing::none);
  EXPECT_EQ(again.flips, 0U) << "it is there";
}

TEST(Restore_input_edge, restores_the_parts_of_an_edge_that_was_split) {
  Exact t(soups::soup(edge_in_zigzag(6)));
  const std::uint32_t x = first_edge(t);
  ASSERT_EQ(t.split_edge(t.numbers().halfedge_at(x), 0.4).status, IT::Move_status::done);
  IT::flip_to_delaunay(t);
  EXPECT_LT(edges_along(t, x), 2);
  EXPECT_EQ(restore(t, x).missing, IT::Gluing::none);
  EXPECT_EQ(edges_along(t, x), 2);
}

// Seeds of soups and flips where edges cross faces twice, and flips off them come back.
TEST(Restore_input_edge, ends_where_an_edge_crosses_faces_more_than_once) {
  for (const std::uint32_t seed : {427U, 711U, 963U}) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto below = [&random](std::size_t most) {
      return static_cast<std::uint32_t>(random() % most);
    };
    const std::uint32_t n = 3 + seed % 5;
    const double thin = std::pow(10, -2 * uniform(random));
    Mesh m;
    for (std::uint32_t i = 0; i < n; ++i) {
      const double x = uniform(random), y = thin * uniform(random);
      m.points.push_back({x, y, thin * uniform(random)});
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = below(n), b = below(n), c = below(n);
      if (a != b && b != c && a != c) m.triangles.push_back({a, b, c});
    }
    Exact t(IT::make_domain(soups::soup(m), IT::Domain_kind::tufted_cover).input);
    IT::flip_to_delaunay(t);
    for (int flips = 0; flips < 180; ++flips)
      t.flip_edge(t.numbers().halfedge_at(below(2 * num_edges(t.mesh()))));
    for (std::uint32_t x = 0; x < t.input().number_of_halfedges(); x += 2)
      if (restore(t, x).missing == IT::Gluing::none) {
        EXPECT_EQ(edges_along(t, x), 1) << seed << ' ' << x;
      }
  }
}

TEST(Restore_input_edges, leads_to_the_constrained_delaunay_triangulation) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Mesh m = meshes::potato(2, seed);
    Exact first(soups::soup(m)), later(soups::soup(m));
    std::mt19937 random(seed);
    std::vector<char> is_kept(first.input().number_of_edges());
    for (char& c : is_kept) c = random() % 4 == 0 ? 1 : 0;
    const auto flip = [&](Exact& t) {
      const auto marked = IT::constrained_input_edges(t, is_kept);
      IT::flip_to_delaunay(t, edges(t.mesh()), IT::parameters::edge_is_constrained_map(marked));
    };
    flip(first);
    IT::flip_to_delaunay(later);
    const IT::Restored_edges restored = IT::restore_input_edges(later, is_kept);
    EXPECT_GT(restored.flips, 0U) << seed;
    EXPECT_EQ(restored.missing, IT::Gluing::none) << seed;
    for (std::uint32_t e = 0; e < is_kept.size(); ++e)
      if (is_kept[e] != 0) {
        EXPECT_EQ(edges_along(later, 2 * e), 1) << seed;
      }
    flip(later);
    std::multiset<double> a, b;
    for (const auto e : edges(first.mesh())) a.insert(first.squared_length(e));
    for (const auto e : edges(later.mesh())) b.insert(later.squared_length(e));
    ASSERT_EQ(a.size(), b.size());
    for (auto i = a.begin(), j = b.begin(); i != a.end(); ++i, ++j)
      EXPECT_NEAR(*i, *j, 1e-12 * *i) << seed;
  }
}

} // namespace
