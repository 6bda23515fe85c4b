// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gallery.h"
#include "meshes.h"
#include "properties.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Fuzzing: random flips, then back to Delaunay; all that must hold then.

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Exact = IT::Intrinsic_triangulation<>;

IT::Intrinsic_input random_input(std::mt19937& random) {
  const unsigned seed = static_cast<unsigned>(random());
  switch (random() % 7) {
  case 0: {
    const auto surfaces = gallery::oriented();
    return gallery::input(surfaces[random() % surfaces.size()]);
  }
  case 1:
    return meshes::integer_height_field(3, 2 + seed % 3, seed).input();
  case 2:
    return meshes::rough_grid(4, seed).input();
  case 3:
    return meshes::integer_terrain(20, 6, seed).input(IT::Mollification::automatic);
  case 4:
    return meshes::folded_lattice(3, 4, seed % 3).input();
  case 5:
    return meshes::potato(2, seed).input();
  default:
    return meshes::box(1 + seed % 2, 1, 1 + seed % 3).input();
  }
}

using Bounds = std::vector<std::pair<double, double>>;

// Bounds of the cone angles, then of the area: intervals widen by up to ten times in a flip that
// makes a sliver, so that nothing narrower is certain.
Bounds bounds(const Exact& t) {
  Bounds result(num_vertices(t.mesh()) + 1);
  for (const auto f : faces(t.mesh())) {
    const auto& a = t.metric().quadruple_area(t.index(f));
    result.back().first += a.inf();
    result.back().second += a.sup();
    auto h = halfedge(f, t.mesh());
    for (int k = 0; k < 3; ++k, h = next(h, t.mesh())) {
      const auto length = [&](auto x) {
        return t.metric().squared_length(t.index(edge(x, t.mesh())));
      };
      const auto n = next(h, t.mesh());
      const auto u = length(h), v = length(next(n, t.mesh())), w = length(n);
      // the angle grows as the scalar product falls
      const double least = u.inf() + v.inf() - w.sup(), most = u.sup() + v.sup() - w.inf();
      auto& [low, high] = result[t.input_vertex(source(h, t.mesh()))];
      low += std::min(std::atan2(a.inf(), most), std::atan2(a.sup(), most));
      high += std::max(std::atan2(a.inf(), least), std::atan2(a.sup(), least));
    }
  }
  return result;
}

TEST(Random_flips, conserve_the_metric_and_lead_back_to_the_same_delaunay_tessellation) {
  for (unsigned seed = 1; seed <= 1500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const IT::Intrinsic_input in = random_input(random);
    Exact expected(in);
    IT::flip_to_delaunay(expected);
    Exact t(in);
    const Bounds before = bounds(t);
    const auto edges = properties::flippable_by_connectivity(t);
    for (std::size_t i = 0; !edges.empty() && i < 20; ++i)
      t.flip_edge(edges[random() % edges.size()]);
    const auto result = IT::flip_to_delaunay(t);

    EXPECT_EQ(result.status, IT::Status::done);
    EXPECT_EQ(IT::check_delaunay(t).non_delaunay_edges, 0U);
    EXPECT_EQ(t.metric().statistics().probable_zero, 0U);
    const Bounds after = bounds(t);
    for (std::size_t i = 0; i < after.size(); ++i) {
      // bounds are added up and angles taken to the nearest
      EXPECT_LE(after[i].first, before[i].second * (1 + 1e-12)) << i;
      EXPECT_GE(after[i].second, before[i].first * (1 - 1e-12)) << i;
    }
    Exact::Session session(t);
    for (const auto h : properties::flippable_by_connectivity(t))
      EXPECT_GE(session.cotangent_weight(edge(h, t.mesh())), 0);
    const auto found = properties::tessellation(t), wanted = properties::tessellation(expected);
    ASSERT_EQ(found.size(), wanted.size());
    // edges of a pair of vertices are sorted by their lengths, which may be anywhere in the
    // intervals
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(std::get<0>(found[i]), std::get<0>(wanted[i]));
      EXPECT_EQ(std::get<1>(found[i]), std::get<1>(wanted[i]));
    }
  }
}

} // namespace
