// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "properties.h"
#include "soups.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
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

// ---- doubles: edges within rounding

using Double = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>;

// A sheared grid, turned about an axis: nearly all edges of its Delaunay triangulation are ties, up
// to rounding.
meshes::Mesh turned_grid(std::mt19937& random) {
  std::uniform_int_distribution<std::uint32_t> size(3, 12);
  std::uniform_real_distribution<double> real(-1, 1);
  meshes::Mesh m = meshes::sheared_grid(size(random), size(random), 4 * real(random));
  const double angle = std::numbers::pi * real(random), tilt = std::numbers::pi * real(random);
  for (meshes::Point& p : m.points) {
    const double x = std::cos(angle) * p[0] - std::sin(angle) * p[1],
                 y = std::sin(angle) * p[0] + std::cos(angle) * p[1];
    p = {x, std::cos(tilt) * y, std::sin(tilt) * y};
  }
  return m;
}

void expect_agreement(Double t) {
  const auto r = IT::flip_to_delaunay(t);
  EXPECT_EQ(r.status, IT::Status::done);
  EXPECT_EQ(r.refused_flips, 0U);
  EXPECT_TRUE(IT::is_delaunay(t));
  EXPECT_EQ(IT::check_delaunay(t).non_delaunay_edges, 0U);
  EXPECT_EQ(IT::flip_to_delaunay(t).flips, 0U);
}

TEST(Is_delaunay,
     in_doubles_agrees_with_flips_that_are_done_however_many_edges_are_within_rounding) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const meshes::Mesh m = turned_grid(random);
    expect_agreement(Double(m.input()));
    for (const meshes::Mesh& soup : {m, soups::random(12, 30, seed)})
      expect_agreement(
          Double(IT::make_domain(soups::soup(soup), IT::Domain_kind::tufted_cover).input));
  }
}

// The sine of what the angles opposite an edge exceed pi by, from points in the plane.
double sine_of_excess(const meshes::Mesh& m, const Double& t, Double::halfedge_descriptor h) {
  const auto angle = [&](auto side) {
    const auto at = [&](auto g) { return m.points[t.index(source(g, t.mesh()))]; };
    const auto i = at(side), j = at(next(side, t.mesh())),
               k = at(next(next(side, t.mesh()), t.mesh()));
    const double ax = i[0] - k[0], ay = i[1] - k[1], bx = j[0] - k[0], by = j[1] - k[1];
    return std::atan2(std::abs(ax * by - ay * bx), ax * bx + ay * by);
  };
  return -std::sin(angle(h) + angle(opposite(h, t.mesh())));
}

// Lengths and areas of these faces, the thinnest of which are some 1e-3 times as high as long, are
// right to about 1e-13 of themselves: sines of sums of angles are right to 1e-9. Points of integer
// coordinates make ties or sines above that.
TEST(Is_delaunay, in_doubles_takes_no_edge_for_a_tie_that_is_none) {
  for (unsigned seed = 1; seed <= 60; ++seed)
    for (const unsigned size : {6U, 100U}) {
      const meshes::Mesh m = meshes::random_planar(40, size, seed);
      IT::Intrinsic_input input = m.input();
      input.may_renumber = false;
      Double t(std::move(input));
      IT::flip_to_delaunay(t);
      EXPECT_TRUE(IT::is_delaunay(t)) << seed << ' ' << size;
      for (const auto h : properties::flippable_by_connectivity(t))
        EXPECT_LE(sine_of_excess(m, t, h), 1e-9) << seed << ' ' << size;
    }
}

} // namespace
