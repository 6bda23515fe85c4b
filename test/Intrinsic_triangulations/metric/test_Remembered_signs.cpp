// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/metric/Remembered_signs.h>

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include "meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;
using Integers = IT::Integer_only_triangulation<>;

// symmetric by three planes: many edges of its Delaunay triangulation are tied
meshes::Mesh ellipsoid() {
  meshes::Mesh m = meshes::sphere(3);
  for (auto& p : m.points) p[0] *= 100;
  return m;
}

// compares with an arithmetic that remembers nothing
void expect_right_signs(const Triangulation& t) {
  const Integers integers(t);
  const Integers::Const_session rebuilt(integers);
  const Triangulation::Const_session session(t);
  for (const auto e : edges(t.mesh())) {
    const auto h = halfedge(e, t.mesh());
    EXPECT_EQ(session.delaunay_sign(h), rebuilt.delaunay_sign(h));
  }
}

TEST(Remembered_signs, follow_flips_and_insertions) {
  Triangulation t(ellipsoid().input());
  IT::flip_to_delaunay(t);
  expect_right_signs(t);
  std::mt19937 random(17);
  for (int i = 0; i < 40; ++i) {
    const std::uint32_t e = static_cast<std::uint32_t>(random() % t.mesh().number_of_edges());
    const auto h = halfedge(IT::Gluing_map::Edge{e}, t.mesh());
    if (i % 8 == 7)
      t.insert_vertex(h, {0.25, 0.25, 0.5});
    else
      t.flip_edge(h);
    expect_right_signs(t);
  }
}

TEST(Remembered_signs, of_ties_are_proven_once_and_counted_again) {
  Triangulation t(ellipsoid().input());
  IT::flip_to_delaunay(t);
  auto& statistics = t.metric().statistics();
  for (int i = 0; i < 2; ++i) {
    statistics = {};
    const std::size_t ties = IT::check_delaunay(t).cocircular_edges.size();
    EXPECT_GT(ties, 100U);
    EXPECT_EQ(statistics.certified_zero, ties);
    EXPECT_EQ(statistics.probable_zero, 0U);
  }
  EXPECT_TRUE(statistics.escalations.empty());
}

} // namespace
