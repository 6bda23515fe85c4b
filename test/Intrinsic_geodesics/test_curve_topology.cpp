// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/add_marked_edges.h>
#include <CGAL/Intrinsic_geodesics/shortening/is_geodesic.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include "curve_topology.h"
#include "gallery.h"
#include "meshes.h"
#include "numbered_as_mesh.h"
#include "subdivision_oracle.h"

#include <CGAL/Interval_nt.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Properties that shortening must keep: curves do not cross, and keep their homotopy class. Curves
// are edges of a triangulation, which cross none of the others on the common subdivision as long as
// the integer coordinates are those of one: that is checked, too.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using curve_topology::Fundamental_group;
using curve_topology::Word;
using IT::Gluing_map;
using Triangulation =
    IT::Intrinsic_triangulation<Gluing_map, IT::Exact_euclidean_traits, IT::Integer_coordinates>;
using Network = IT::Curve_network<Triangulation>;
using Way = std::vector<Gluing_map::Halfedge>;

/// The surface of unit cells of a grid, whose corners are moved a little.
meshes::Mesh cells(const std::set<std::array<int, 2>>& cells, unsigned seed) {
  meshes::Mesh m;
  const auto add = [&m](std::array<meshes::Point, 4> p) {
    const auto n = static_cast<std::uint32_t>(m.points.size());
    m.points.insert(m.points.end(), p.begin(), p.end());
    m.triangles.push_back({n, n + 1, n + 2});
    m.triangles.push_back({n, n + 2, n + 3});
  };
  for (const auto& [i, j] : cells) {
    const double x = i, y = j;
    add({{{x, y, 1}, {x + 1, y, 1}, {x + 1, y + 1, 1}, {x, y + 1, 1}}});
    add({{{x, y, 0}, {x, y + 1, 0}, {x + 1, y + 1, 0}, {x + 1, y, 0}}});
    if (cells.count({i, j - 1}) == 0) add({{{x, y, 0}, {x + 1, y, 0}, {x + 1, y, 1}, {x, y, 1}}});
    if (cells.count({i + 1, j}) == 0)
      add({{{x + 1, y, 0}, {x + 1, y + 1, 0}, {x + 1, y + 1, 1}, {x + 1, y, 1}}});
    if (cells.count({i, j + 1}) == 0)
      add({{{x + 1, y + 1, 0}, {x, y + 1, 0}, {x, y + 1, 1}, {x + 1, y + 1, 1}}});
    if (cells.count({i - 1, j}) == 0) add({{{x, y + 1, 0}, {x, y, 0}, {x, y, 1}, {x, y + 1, 1}}});
  }
  meshes::Mesh result = meshes::welded(m);
  std::mt19937 random(seed);
  for (meshes::Point& p : result.points)
    for (double& x : p) x += seed == 0 ? 0 : 0.3 * (static_cast<double>(random()) / 0x1p32 - 0.5);
  return result;
}

/// A ring of cells has genus 1, two beside each other 2, and so on.
meshes::Mesh body_of_genus(int genus, unsigned seed) {
  std::set<std::array<int, 2>> all;
  for (int i = 0; i <= 2 * genus; ++i)
    for (int j = 0; j < 3; ++j)
      if (i % 2 == 0 || j != 1) all.insert({i, j});
  return cells(all, seed);
}

/// A grid without some of its cells.
meshes::Mesh grid_with_holes(unsigned seed) {
  meshes::Mesh m = seed == 0 ? meshes::grid(9, 9) : meshes::rough_grid(9, seed);
  const std::vector<meshes::Triangle> all = std::exchange(m.triangles, {});
  for (std::uint32_t f = 0; f < all.size(); ++f) {
    const std::uint32_t i = f / 2 % 9, j = f / 18;
    if (i % 3 != 1 || j % 4 != 2) m.triangles.push_back(all[f]);
  }
  return m;
}

/// Turns back only if it must; if closed, it is the first loop on its way.
Way random_walk(const Triangulation& t, std::size_t steps, bool is_closed, std::mt19937& random) {
  const auto& mesh = t.mesh();
  Way result;
  auto v = t.numbers().vertex_at(static_cast<std::uint32_t>(random() % num_vertices(mesh)));
  std::map<std::uint32_t, std::size_t> met{{t.index(v), 0}};
  for (std::size_t i = 1; i <= steps; ++i) {
    Way out;
    IT::for_each_outgoing(v, mesh, [&](Gluing_map::Halfedge h) {
      if (result.empty() || h != opposite(result.back(), mesh)) out.push_back(h);
    });
    result.push_back(out[random() % out.size()]);
    v = target(result.back(), mesh);
    const auto [first, is_new] = met.emplace(t.index(v), i);
    if (is_closed && !is_new)
      return {result.begin() + static_cast<std::ptrdiff_t>(first->second), result.end()};
  }
  return is_closed ? Way() : result;
}

struct Counts {
  std::size_t curves = 0, loops = 0, contracted = 0, nontrivial = 0, shared = 0, refused = 0;
};

/// Adds walks that do not cross others.
void add_random_walks(Network& network, std::mt19937& random, Counts& counts) {
  const Triangulation& t = network.triangulation();
  Way walk;
  for (unsigned k = 0; k < 16; ++k) {
    const bool is_loop = random() % 2 == 0, is_again = random() % 4 == 0;
    if (!is_again || walk.empty()) walk = random_walk(t, 1 + random() % 30, is_loop, random);
    if (walk.empty() ||
        (is_loop && source(walk.front(), t.mesh()) != target(walk.back(), t.mesh())))
      continue;
    curve_topology::Crossings with_walk(network);
    with_walk.add(network, walk, is_loop);
    const bool does_cross = with_walk.count() != 0;
    try {
      is_loop ? network.add_loop(walk) : network.add_path(walk);
      EXPECT_FALSE(does_cross);
    } catch (const IT::Invalid_input&) {
      EXPECT_TRUE(does_cross);
      ++counts.refused;
    }
  }
}

void add_random_edges(Network& network, std::mt19937& random) {
  std::vector<bool> is_marked(
      network.triangulation().numbers().edge_capacity(network.triangulation().mesh()));
  for (std::size_t e = 0; e < is_marked.size(); ++e) is_marked[e] = random() % 5 == 0;
  add_marked_edges(network,
                   boost::make_function_property_map<Gluing_map::Edge>([&](Gluing_map::Edge e) {
                     return is_marked[network.triangulation().index(e)];
                   }));
}

struct Curve_before {
  Word word;
  double length;
};

void expect_same_curves(const Network& network, const Fundamental_group& group,
                        const std::vector<Curve_before>& before, Counts& counts) {
  const Triangulation& t = network.triangulation();
  for (std::uint32_t c = 0; c < network.number_of_curves(); ++c) {
    const Word word = word_of(group, t, network.halfedges(c));
    EXPECT_LE(network.length_enclosure(c).inf(), before[c].length);
    if (network.is_loop(c)) {
      EXPECT_TRUE(group.are_conjugate(before[c].word, word));
      EXPECT_TRUE(!network.is_point(c) || group.is_trivial(before[c].word));
    } else {
      Word closed = before[c].word;
      curve_topology::append(closed, curve_topology::inverse(word));
      EXPECT_TRUE(group.is_trivial(closed));
    }
    ++counts.curves;
    counts.loops += network.is_loop(c) ? 1 : 0;
    counts.contracted += network.is_point(c) ? 1 : 0;
    counts.nontrivial += group.is_trivial(word) ? 0 : 1;
  }
}

/// Shortens networks, and compares them before and after.
template <class Build>
void check(Triangulation t, unsigned seed, const Build& build, Counts& counts) {
  std::mt19937 random(seed);
  const Fundamental_group group(t.input());
  Network network(t);
  build(network, random);
  EXPECT_EQ(curve_topology::Crossings(network).count(), 0U);
  std::vector<Curve_before> before;
  for (std::uint32_t c = 0; c < network.number_of_curves(); ++c)
    before.push_back({word_of(group, t, network.halfedges(c)), network.length_enclosure(c).sup()});
  ASSERT_EQ(shorten_curves(network).status, IT::Status::done);
  EXPECT_TRUE(is_geodesic(network).is_geodesic());
  EXPECT_EQ(curve_topology::Crossings(network).count(), 0U);
  EXPECT_EQ(subdivision_oracle::defect(t), "");
  for (const auto e : edges(t.mesh())) counts.shared += network.curves_along(e).size() > 1 ? 1 : 0;
  expect_same_curves(network, group, before, counts);
}

void check(Triangulation t, unsigned seed, Counts& counts) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  if (seed % 2 == 1) flip_to_delaunay(t);
  check(
      t, seed, [&](Network& n, std::mt19937& r) { add_random_walks(n, r, counts); }, counts);
  check(
      t, seed, [](Network& n, std::mt19937& r) { add_random_edges(n, r); }, counts);
}

TEST(CurveTopology, IsKeptByShorteningOnBodiesWithHandles) {
  for (int genus = 0; genus < 4; ++genus) {
    SCOPED_TRACE(genus);
    Counts counts;
    for (unsigned seed = 0; seed < 100; ++seed) {
      const Triangulation t = numbered_as<Triangulation>(body_of_genus(genus, seed));
      EXPECT_EQ(Fundamental_group(t.input()).rank(), 2 * genus);
      check(t, seed, counts);
    }
    EXPECT_GT(counts.curves, 500U);
    EXPECT_GT(counts.loops, 200U);
    EXPECT_GT(counts.contracted, 200U);
    EXPECT_GT(counts.shared, 40U);
    EXPECT_GT(counts.refused, 300U);
    if (genus > 0) {
      EXPECT_GT(counts.nontrivial, 100U);
    }
  }
}

TEST(CurveTopology, IsKeptByShorteningOnDiscsWithHoles) {
  Counts counts;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Triangulation t = numbered_as<Triangulation>(grid_with_holes(seed));
    EXPECT_EQ(Fundamental_group(t.input()).rank(), 6);
    check(t, seed, counts);
  }
  EXPECT_GT(counts.curves, 500U);
  EXPECT_GT(counts.nontrivial, 100U);
  EXPECT_GT(counts.shared, 100U);
}

TEST(CurveTopology, IsKeptByShorteningOnFlatTori) {
  Counts counts;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const gallery::Surface s = gallery::flat_torus(3 + seed % 4, 3 + seed % 3);
    check(Triangulation(gallery::input(s)), seed, counts);
  }
  EXPECT_GT(counts.nontrivial, 30U);
}

} // namespace
