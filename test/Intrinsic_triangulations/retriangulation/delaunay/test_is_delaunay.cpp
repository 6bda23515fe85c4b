// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "properties.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/is_delaunay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Exact = IT::Intrinsic_triangulation<>;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Planar =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex_base>>;
using Edges = std::set<std::pair<std::uint32_t, std::uint32_t>>;

// The edges of the Delaunay tessellation of points in the plane, and the number of all edges.
std::pair<Edges, std::size_t> planar_tessellation(const meshes::Mesh& m) {
  std::vector<std::pair<Kernel::Point_2, std::uint32_t>> points;
  for (std::uint32_t v = 0; v < m.points.size(); ++v)
    points.emplace_back(Kernel::Point_2(m.points[v][0], m.points[v][1]), v);
  Planar d(points.begin(), points.end());
  Edges result;
  std::size_t count = 0;
  for (auto e = d.finite_edges_begin(); e != d.finite_edges_end(); ++e, ++count) {
    const auto mirror = d.mirror_edge(*e);
    const bool tie =
        !d.is_infinite(e->first) && !d.is_infinite(mirror.first) &&
        d.side_of_oriented_circle(e->first, mirror.first->vertex(mirror.second)->point()) ==
            CGAL::ON_ORIENTED_BOUNDARY;
    if (!tie)
      result.insert(std::minmax({e->first->vertex(Planar::cw(e->second))->info(),
                                 e->first->vertex(Planar::ccw(e->second))->info()}));
  }
  return {result, count};
}

TEST(Is_delaunay, planar_triangulations_become_those_of_Delaunay_triangulation_2) {
  std::size_t ties = 0;
  for (unsigned seed = 1; seed <= 60; ++seed)
    for (const unsigned size : {6U, 12U, 1000U}) { // many ties, some, hardly any
      const meshes::Mesh m = meshes::random_planar(40, size, seed);
      Exact t(m.input());
      IT::flip_to_delaunay(t);
      EXPECT_TRUE(IT::is_delaunay(t));
      const auto [expected, count] = planar_tessellation(m);
      EXPECT_EQ(num_edges(t.mesh()), count) << seed << ' ' << size;
      Edges found;
      for (const auto& [i, j, length] : properties::tessellation(t)) found.insert({i, j});
      EXPECT_EQ(found, expected) << seed << ' ' << size;
      ties += IT::check_delaunay(t).cocircular_edges.size();
    }
  EXPECT_GT(ties, 500U);
}

TEST(Is_delaunay, reports_what_is_wrong_edge_by_edge) {
  Exact t(meshes::grid(1, 1, 1, 3).input());
  EXPECT_TRUE(IT::is_delaunay(t));
  EXPECT_EQ(IT::check_delaunay(t).cocircular_edges.size(), 1U);

  meshes::Mesh bent = meshes::grid(1, 1, 1, 3);
  bent.points[1] = {0.5, 1,
                    0}; // opposite the diagonal: almost a straight angle, against a right one
  Exact u(bent.input());
  EXPECT_FALSE(IT::is_delaunay(u));
  EXPECT_EQ(IT::check_delaunay(u).non_delaunay_edges, 1U);
  EXPECT_EQ(IT::check_delaunay(u).cocircular_edges.size(), 0U);
}

TEST(Is_delaunay, the_count_of_bad_edges_is_that_of_negative_signs) {
  Exact t(meshes::potato(3, 4).input());
  std::size_t negative = 0;
  for (const auto h : properties::flippable_by_connectivity(t))
    if (t.delaunay_sign(h) == CGAL::NEGATIVE) ++negative;
  EXPECT_GT(negative, 0U);
  EXPECT_EQ(IT::check_delaunay(t).non_delaunay_edges, negative);
  EXPECT_FALSE(IT::is_delaunay(t));
}

TEST(Is_delaunay, a_lone_triangle_is) {
  Exact t(meshes::Mesh{{{0, 0, 0}, {9, 0, 0}, {8, 1, 0}}, {{0, 1, 2}}}.input());
  EXPECT_TRUE(IT::is_delaunay(t));
  EXPECT_EQ(IT::check_delaunay(t).non_delaunay_edges, 0U);
}

} // namespace
