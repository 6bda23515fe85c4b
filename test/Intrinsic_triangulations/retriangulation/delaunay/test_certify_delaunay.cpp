// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/certify_delaunay.h>

#include "meshes.h"
#include "subdivision_oracle.h"

#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <random>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using subdivision_oracle::Exact;
using subdivision_oracle::Rounded;
using Map = IT::Gluing_map;

TEST(Certify_delaunay, finds_what_exact_traits_find_after_flips_in_doubles) {
  for (const meshes::Mesh& m : {meshes::potato(3, 1), meshes::rough_grid(12, 2)}) {
    Rounded rounded(m.input());
    Exact exact(m.input());
    EXPECT_GT(IT::certify_delaunay(rounded).non_delaunay_edges, 0U);
    IT::flip_to_delaunay(rounded);
    IT::flip_to_delaunay(exact);
    const IT::Delaunay_certificate c = IT::certify_delaunay(rounded);
    EXPECT_TRUE(c.is_delaunay()); // no tie is near: the filter decides all
    EXPECT_EQ(c.statistics.filter_failures, 0U);
    EXPECT_EQ(c.ties, IT::certify_delaunay(exact).ties);
  }
}

TEST(Certify_delaunay, takes_every_correspondence) {
  const auto ties = [](auto t) {
    IT::flip_to_delaunay(t);
    const IT::Delaunay_certificate c = IT::certify_delaunay(t);
    EXPECT_TRUE(c.is_delaunay());
    return c.ties;
  };
  using Traits = IT::Exact_euclidean_traits;
  for (const meshes::Mesh& m : {meshes::potato(3, 1), meshes::box(3, 2, 2)}) {
    const std::size_t n = ties(Exact(m.input()));
    EXPECT_EQ(ties(IT::Intrinsic_triangulation<Map, Traits, IT::Explicit_crossings>(m.input())), n);
    EXPECT_EQ(ties(IT::Intrinsic_triangulation<Map, Traits, IT::Signposts>(m.input())), n);
  }
}

// On a box every rectangle is a tie: with right angles, intervals are numbers and the filter sees it.
TEST(Certify_delaunay, counts_ties_of_a_box) {
  Exact t(meshes::box(3, 2, 2).input());
  IT::flip_to_delaunay(t);
  const IT::Delaunay_certificate c = IT::certify_delaunay(t);
  EXPECT_TRUE(c.is_delaunay());
  EXPECT_EQ(c.ties, 2U * (3 * 2 + 2 * 2 + 2 * 3)); // a diagonal for each unit square
  EXPECT_EQ(c.statistics.filter_failures, c.statistics.certified_zero);
}

TEST(Certify_delaunay, finds_the_one_edge_that_was_flipped_too_much) {
  const meshes::Mesh m = meshes::potato(2, 5);
  Rounded t(m.input());
  IT::flip_to_delaunay(t);
  Rounded::Session session(t);
  int flipped = 0;
  for (const Map::Halfedge h : halfedges(t.mesh())) {
    if (session.flip_edge(h) != IT::Move_status::done) continue;
    ++flipped;
    // the diamond is strictly Delaunay one way, so it is not the other
    const IT::Delaunay_certificate c = IT::certify_delaunay(t);
    EXPECT_EQ(c.inverted_faces, 0U);
    EXPECT_GE(c.non_delaunay_edges, 1U);
    session.flip_edge(h);
    if (flipped == 10) break;
  }
  EXPECT_EQ(flipped, 10);
}

// Doubles that allow every flip.
struct Reckless_metric : IT::Euclidean_metric<double> {
  using IT::Euclidean_metric<double>::Euclidean_metric;
  std::optional<Flipped> compute_flip(const IT::Diamond&) const { return Flipped{1, 1, 1}; }
};
struct Reckless_traits {
  using FT = double;
  using Metric = Reckless_metric;
};

TEST(Certify_delaunay, finds_the_face_that_a_flip_of_a_reflex_diamond_turns_over) {
  // a diamond that is not convex at vertex 1
  meshes::Mesh m{{{0, 0, 0}, {1, 0, 0}, {3, 2, 0}, {3, -2, 0}}, {{0, 1, 2}, {1, 0, 3}}};
  using Reckless = IT::Intrinsic_triangulation<Map, Reckless_traits, IT::Integer_coordinates>;
  Reckless t(m.input());
  EXPECT_EQ(IT::certify_delaunay(t).inverted_faces, 0U);
  for (const Map::Halfedge h : halfedges(t.mesh()))
    if (t.mesh().face(h).index != IT::Gluing::none &&
        t.mesh().face(Map::opposite(h)).index != IT::Gluing::none) {
      Reckless::Session(t).flip_non_delaunay_edge(h);
      break;
    }
  const IT::Delaunay_certificate c = IT::certify_delaunay(t);
  EXPECT_EQ(c.inverted_faces, 1U);
  EXPECT_FALSE(c.is_delaunay());
}

// Flips of any diamonds can wind edges about vertices so that all faces still come out right: the Delaunay
// triangulation, seen through a twist. Only edges that run straight tell.
TEST(Certify_delaunay, is_not_given_to_edges_that_wind_about_vertices) {
  using Reckless = IT::Intrinsic_triangulation<Map, Reckless_traits, IT::Integer_coordinates>;
  const meshes::Mesh m = meshes::rough_grid(3, 1);
  const auto crossings = [](const auto& t) {
    long sum = 0;
    for (const auto e : edges(t.mesh()))
      sum += std::max(0, t.correspondence().normal_coordinate(t.index(e)));
    return sum;
  };
  IT::Integer_only_triangulation<> expected(m.input());
  IT::flip_to_delaunay(expected);
  EXPECT_EQ(IT::certify_delaunay(expected).bent_edges, 0U);
  int certified = 0, bent = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    Reckless t(m.input());
    for (unsigned i = 0; i < 10; ++i) {
      const Map::Halfedge h{static_cast<std::uint32_t>(random() % t.mesh().number_of_halfedges())};
      if (t.mesh().face(h).index == IT::Gluing::none ||
          t.mesh().face(Map::opposite(h)).index == IT::Gluing::none ||
          t.mesh().face(h) == t.mesh().face(Map::opposite(h)))
        continue;
      Reckless::Session(t).flip_non_delaunay_edge(h);
    }
    IT::Integer_only_triangulation<> exact(t);
    EXPECT_EQ(IT::flip_to_delaunay(exact).status, IT::Status::done);
    const IT::Delaunay_certificate c = IT::certify_delaunay(exact);
    bent += c.bent_edges > 0;
    if (!c.is_delaunay()) continue;
    ++certified;
    EXPECT_EQ(crossings(exact), crossings(expected)) << seed;
  }
  EXPECT_GT(certified, 0);
  EXPECT_GT(bent, 0);
}

// Inserted vertices are where their rounded weights say: nothing near a tie changes sides.
TEST(Certify_delaunay, certifies_refined_triangulations) {
  const meshes::Mesh m = meshes::potato(2, 3);
  Exact exact(m.input());
  Rounded rounded(m.input());
  IT::delaunay_refine(exact);
  IT::delaunay_refine(rounded);
  EXPECT_GT(num_vertices(exact.mesh()), m.points.size());
  EXPECT_TRUE(IT::certify_delaunay(exact).is_delaunay());
  EXPECT_TRUE(IT::certify_delaunay(rounded).is_delaunay());
}

} // namespace
