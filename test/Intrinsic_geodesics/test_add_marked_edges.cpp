// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/curves/add_marked_edges.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h>

#include "gallery.h"
#include "meshes.h"
#include "numbered_as_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;
using Network = IT::Curve_network<Triangulation>;
using Edges = std::set<std::pair<std::uint32_t, std::uint32_t>>;

/// Marks edges by their ends, the smaller one first.
IT::Marked_edges<Triangulation> marked(const Triangulation& t, const Edges& wanted) {
  IT::Marked_edges<Triangulation> map(t);
  for (const auto e : edges(t.mesh())) {
    const auto h = halfedge(e, t.mesh());
    const std::uint32_t a = t.index(source(h, t.mesh())), b = t.index(target(h, t.mesh()));
    if (wanted.count({std::min(a, b), std::max(a, b)}) != 0) put(map, e, true);
  }
  return map;
}

std::uint32_t marks_at(const Triangulation& t, const IT::Marked_edges<Triangulation>& map,
                       Triangulation::vertex_descriptor v) {
  std::uint32_t n = 0;
  for (const auto h : halfedges(t.mesh()))
    if (source(h, t.mesh()) == v && get(map, edge(h, t.mesh()))) ++n;
  return n;
}

IT::Marked_edges<Triangulation> all_marked(const Triangulation& t) {
  IT::Marked_edges<Triangulation> map(t);
  for (const auto e : edges(t.mesh())) put(map, e, true);
  return map;
}

/// What the function promises, by its definition.
void expect_chains(const Triangulation& t, const IT::Marked_edges<Triangulation>& map,
                   const Network& network) {
  for (const auto v : vertices(t.mesh())) {
    const std::uint32_t n = marks_at(t, map, v);
    EXPECT_EQ(network.is_fixed(v), n != 0 && n != 2);
  }
  for (const auto e : edges(t.mesh()))
    EXPECT_EQ(network.curves_along(e).size(), get(map, e) ? 1U : 0U);
  for (std::uint32_t c = 0; c < network.number_of_curves(); ++c) {
    const auto way = network.halfedges(c);
    ASSERT_FALSE(way.empty());
    for (std::size_t i = 0; i + 1 < way.size(); ++i)
      EXPECT_EQ(marks_at(t, map, target(way[i], t.mesh())), 2U);
    EXPECT_EQ(marks_at(t, map, source(way.front(), t.mesh())) == 2, network.is_loop(c));
    EXPECT_EQ(marks_at(t, map, target(way.back(), t.mesh())) == 2, network.is_loop(c));
  }
}

} // namespace

TEST(AddMarkedEdges, NoEdgeIsMarked) {
  Triangulation t = numbered_as<Triangulation>(meshes::grid(2, 2));
  Network network(t);
  EXPECT_EQ(IT::add_marked_edges(network, IT::Marked_edges<Triangulation>(t)), 0U);
  EXPECT_EQ(network.number_of_curves(), 0U);
}

TEST(AddMarkedEdges, ACrossBecomesFourPathsAndARingALoop) {
  Triangulation t = numbered_as<Triangulation>(meshes::grid(6, 4)); // vertex (i, j) is 7 j + i
  Edges wanted{{7, 8}, {8, 9}, {1, 8}, {8, 15}, {15, 22}};
  for (const auto& ring : {std::pair(11U, 12U), {12, 19}, {18, 19}, {11, 18}}) wanted.insert(ring);
  const auto map = marked(t, wanted);
  Network network(t);
  EXPECT_EQ(IT::add_marked_edges(network, map), 5U);
  expect_chains(t, map, network);
  EXPECT_EQ(network.number_of_curves(), 5U);
  EXPECT_DOUBLE_EQ(network.length(), 9.);
  for (std::uint32_t c = 0; c < 4; ++c) EXPECT_FALSE(network.is_loop(c));
  EXPECT_TRUE(network.is_loop(4));
  EXPECT_DOUBLE_EQ(network.length(4), 4.);
}

TEST(AddMarkedEdges, TheBorderBecomesALoop) {
  Triangulation t = numbered_as<Triangulation>(meshes::grid(3, 2));
  IT::Marked_edges<Triangulation> map(t);
  for (const auto e : edges(t.mesh())) put(map, e, CGAL::is_border(e, t.mesh()));
  Network network(t);
  EXPECT_EQ(IT::add_marked_edges(network, map), 1U);
  expect_chains(t, map, network);
  EXPECT_DOUBLE_EQ(network.length(0), 10.);
}

TEST(AddMarkedEdges, RandomMarksBecomeChains) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    Triangulation t = numbered_as<Triangulation>(meshes::grid(5, 5));
    IT::Marked_edges<Triangulation> map(t);
    std::mt19937 random(seed);
    for (const auto e : edges(t.mesh())) put(map, e, random() % 5 < 1 + seed % 4);
    Network network(t);
    SCOPED_TRACE(seed);
    const std::uint32_t count = IT::add_marked_edges(network, map);
    EXPECT_EQ(count, network.number_of_curves());
    expect_chains(t, map, network);
  }
}

TEST(AddMarkedEdges, DeltaComplexesWhereAllEdgesAreMarked) {
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    if (s.expected.nonmanifold_vertices != 0) continue;
    Triangulation t(gallery::input(s));
    const auto map = all_marked(t);
    Network network(t);
    IT::add_marked_edges(network, map);
    expect_chains(t, map, network);
  }
}

TEST(AddMarkedEdges, FansOfAVertexThatIsNotManifoldAreKeptApart) {
  const gallery::Surface s = gallery::two_tetrahedra_sharing_a_vertex();
  Triangulation t(gallery::input(s));
  const auto shared = *std::find_if(vertices(t.mesh()).begin(), vertices(t.mesh()).end(),
                                    [&](auto v) { return marks_at(t, all_marked(t), v) == 6; });
  IT::Marked_edges<Triangulation> map(t);
  std::set<std::uint32_t> halves; // one edge in each tetrahedron, which have four faces each
  for (const auto h : halfedges(t.mesh()))
    if (source(h, t.mesh()) == shared && halves.insert(t.index(face(h, t.mesh())) / 4).second)
      put(map, edge(h, t.mesh()), true);
  Network network(t);
  EXPECT_EQ(IT::add_marked_edges(network, map), 2U);
  EXPECT_TRUE(network.is_fixed(shared));
}

TEST(AddMarkedEdges, ACurveThatIsCrossedRefuses) {
  Triangulation t = numbered_as<Triangulation>(meshes::grid(4, 4)); // vertex (i, j) is 5 j + i
  Network network(t);
  IT::add_marked_edges(network, marked(t, {{10, 11}, {11, 12}, {12, 13}}));
  EXPECT_THROW(IT::add_marked_edges(network, marked(t, {{2, 7}, {7, 12}, {12, 17}})),
               IT::Invalid_input);
}
