// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/retriangulation/certify_delaunay.h>

#include "meshes.h"
#include "subdivision_oracle.h"

#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay_refine.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <optional>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using subdivision_oracle::Exact;
using subdivision_oracle::Rounded;
using Map = IT::Gluing_map;

TEST(Certify_delaunay, finds_what_exact_traits_find_after_flips_in_doubles) {
  for (const meshes::Mesh& m : {meshes::potato(3, 1), meshes::rough_grid(12, 2)}) {
    Rounded rounded(m.input());
    Exact exact(m.input());
    EXPECT_GT(IT::certify_delaunay(rounded, m.input()).non_delaunay_edges, 0U);
    IT::flip_to_delaunay(rounded);
    IT::flip_to_delaunay(exact);
    const IT::Delaunay_certificate c = IT::certify_delaunay(rounded, m.input());
    EXPECT_TRUE(c.is_delaunay()); // no tie is near: the filter decides all
    EXPECT_EQ(c.statistics.filter_failures, 0U);
    EXPECT_EQ(c.cocircular_edges, IT::certify_delaunay(exact, m.input()).cocircular_edges);
  }
}

// On a box every rectangle is a tie: with right angles, intervals are numbers and the filter sees it.
TEST(Certify_delaunay, counts_ties_of_a_box) {
  Exact t(meshes::box(3, 2, 2).input());
  IT::flip_to_delaunay(t);
  const IT::Delaunay_certificate c = IT::certify_delaunay(t, meshes::box(3, 2, 2).input());
  EXPECT_TRUE(c.is_delaunay());
  EXPECT_EQ(c.cocircular_edges, 2U * (3 * 2 + 2 * 2 + 2 * 3)); // a diagonal for each unit square
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
    const IT::Delaunay_certificate c = IT::certify_delaunay(t, m.input());
    EXPECT_EQ(c.inverted_faces, 0U);
    EXPECT_GE(c.non_delaunay_edges, 1U);
    session.flip_edge(h);
    if (flipped == 10) break;
  }
  EXPECT_EQ(flipped, 10);
}

// Doubles that flip whatever they are asked to.
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
  EXPECT_EQ(IT::certify_delaunay(t, m.input()).inverted_faces, 0U);
  for (const Map::Halfedge h : halfedges(t.mesh()))
    if (t.mesh().face(h).index != IT::Gluing::none &&
        t.mesh().face(Map::opposite(h)).index != IT::Gluing::none) {
      Reckless::Session(t).flip_non_delaunay_edge(h);
      break;
    }
  const IT::Delaunay_certificate c = IT::certify_delaunay(t, m.input());
  EXPECT_EQ(c.inverted_faces, 1U);
  EXPECT_FALSE(c.is_delaunay());
}

// Inserted vertices are where their rounded weights say: nothing near a tie changes sides.
TEST(Certify_delaunay, certifies_refined_triangulations) {
  const meshes::Mesh m = meshes::potato(2, 3);
  Exact exact(m.input());
  Rounded rounded(m.input());
  IT::delaunay_refine(exact, IT::Refinement_options{});
  IT::delaunay_refine(rounded, IT::Refinement_options{});
  EXPECT_GT(num_vertices(exact.mesh()), m.points.size());
  EXPECT_TRUE(IT::certify_delaunay(exact, m.input()).is_delaunay());
  EXPECT_TRUE(IT::certify_delaunay(rounded, m.input()).is_delaunay());
}

} // namespace
