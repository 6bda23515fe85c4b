// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/dijkstra_ball.h>

#include "meshes.h"
#include "subdivision_oracle.h"

#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using subdivision_oracle::input;
using subdivision_oracle::Rounded;

/// Distances along edges by relaxing all of them again and again.
std::vector<double> distances(const Rounded& t, std::uint32_t center) {
  std::vector<double> d(num_vertices(t.mesh()), std::numeric_limits<double>::infinity());
  d[center] = 0;
  for (std::size_t i = 0; i < d.size(); ++i)
    for (const auto h : halfedges(t.mesh())) {
      const double to =
          d[t.index(source(h, t.mesh()))] +
          std::sqrt(t.metric().approximate_squared_length(t.index(edge(h, t.mesh()))));
      double& known = d[t.index(target(h, t.mesh()))];
      known = std::min(known, to);
    }
  return d;
}

TEST(Dijkstra_ball, Holds_the_vertices_within_the_distance_in_order) {
  for (const meshes::Mesh& m : {meshes::rough_grid(6, 3), meshes::potato(2, 5)}) {
    const Rounded t(input(m));
    const IT::Intrinsic_view view(t);
    for (const std::uint32_t center : {0U, 7U, 20U}) {
      const std::vector<double> d = distances(t, center);
      for (const double radius : {0., 0.5, 1.5, 3., 1000.}) {
        const std::vector<std::uint32_t> ball = IT::internal::dijkstra_ball(view, center, radius);
        ASSERT_FALSE(ball.empty());
        EXPECT_EQ(ball.front(), center);
        for (std::size_t i = 1; i < ball.size(); ++i) EXPECT_LE(d[ball[i - 1]], d[ball[i]]);
        std::size_t expected = 0;
        for (const double x : d) expected += x <= radius ? 1 : 0;
        EXPECT_EQ(ball.size(), expected);
        for (const std::uint32_t v : ball) EXPECT_LE(d[v], radius);
      }
    }
  }
}

TEST(For_each_outgoing, Meets_every_halfedge_once_counterclockwise) {
  for (const meshes::Mesh& m : {meshes::rough_grid(3, 3), meshes::sphere(1)}) {
    const Rounded t(input(m));
    std::vector<int> met(2 * num_edges(t.mesh()), 0);
    for (const auto v : vertices(t.mesh())) {
      std::vector<IT::Gluing_map::Halfedge> star;
      IT::for_each_outgoing(v, t.mesh(), [&](IT::Gluing_map::Halfedge h) {
        EXPECT_EQ(source(h, t.mesh()), v);
        ++met[h.index];
        star.push_back(h);
      });
      for (std::size_t k = 0; k + 1 < star.size(); ++k)
        EXPECT_EQ(face(star[k], t.mesh()), face(opposite(star[k + 1], t.mesh()), t.mesh()));
      for (std::size_t k = 0; k + 1 < star.size(); ++k)
        EXPECT_NE(face(star[k], t.mesh()).index, IT::Gluing::none);
    }
    for (const int n : met) EXPECT_EQ(n, 1);
  }
}

} // namespace
