// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/cuts/cut_open.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_geodesics/cuts/flip_to_geodesic_cut.h>
#include <CGAL/Intrinsic_geodesics/shortening/is_geodesic.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>

#include "meshes.h"
#include "operator_test_meshes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;
using Vertex = Triangulation::vertex_descriptor;

double length(const Triangulation& t, const IT::Marked_edges<Triangulation>& marks) {
  double sum = 0;
  for (const auto e : edges(t.mesh()))
    if (get(marks, e)) sum += t.length(e);
  return sum;
}

std::vector<Vertex> random_vertices(const Triangulation& t, std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Vertex> result;
  for (std::size_t i = 0; i < n; ++i)
    result.push_back(
        t.numbers().vertex_at(static_cast<std::uint32_t>(random() % num_vertices(t.mesh()))));
  return result;
}

void expect_disk(const Triangulation& t, const IT::Marked_edges<Triangulation>& marks) {
  const IT::Gluing_map opened(IT::cut_open(t, marks).gluing);
  EXPECT_EQ(IT::connected_components(opened).count, 1U);
  EXPECT_EQ(IT::euler_characteristic(opened), 1);
  EXPECT_EQ(IT::boundary_loops(opened).size(), 1U);
}

// A torus in space with random bumps.
meshes::Mesh rough_torus(std::uint32_t n, unsigned seed) {
  const operator_test::Shape s = operator_test::rough_torus(n, 0.3, seed);
  return {s.points, s.triangles};
}

} // namespace

TEST(Geodesic_cut, Is_a_geodesic_cut_that_is_not_longer_than_one_along_edges) {
  for (unsigned seed = 0; seed < 8; ++seed)
    for (const std::size_t points : {0U, 1U, 2U, 7U}) {
      meshes::Mesh m = rough_torus(10, seed);
      if (seed % 2 != 0) { // borders
        m.triangles.erase(m.triangles.begin() + 120, m.triangles.begin() + 123);
        m.triangles.erase(m.triangles.begin() + 20);
      }
      Triangulation t(m.input());
      const std::vector<Vertex> through = random_vertices(t, points, seed);
      const double along_edges = length(t, IT::cut_to_disk(t, through));
      const IT::Geodesic_cut<Triangulation> cut = IT::flip_to_geodesic_cut(t, through);
      EXPECT_EQ(cut.shortening.status, IT::Status::done);
      EXPECT_LE(length(t, cut.edges), along_edges * (1 + 1e-12));
      expect_disk(t, cut.edges);
      for (const Vertex v : through) {
        bool is_passed = false;
        for (const auto e : edges(t.mesh()))
          is_passed = is_passed ||
                      (get(cut.edges, e) && (source(e, t.mesh()) == v || target(e, t.mesh()) == v));
        for (const auto h : halfedges(t.mesh()))
          is_passed = is_passed || (CGAL::is_border(h, t.mesh()) && target(h, t.mesh()) == v);
        EXPECT_TRUE(is_passed);
      }
    }
}

TEST(Geodesic_cut, Of_a_sphere_and_of_two_tori_keeps_its_ends_and_roots) {
  Triangulation sphere(meshes::potato(3, 1).input());
  const double along_edges = length(sphere, IT::cut_to_disk(sphere));
  const auto path = IT::flip_to_geodesic_cut(sphere);
  expect_disk(sphere, path.edges);
  EXPECT_LE(length(sphere, path.edges), along_edges);
  meshes::Mesh two = rough_torus(10, 6);
  const auto n = static_cast<std::uint32_t>(two.points.size());
  const meshes::Mesh other = meshes::translated(rough_torus(10, 7), {20, 0, 0});
  two.points.insert(two.points.end(), other.points.begin(), other.points.end());
  for (const auto& f : other.triangles) two.triangles.push_back({f[0] + n, f[1] + n, f[2] + n});
  Triangulation t(two.input());
  const double before = length(t, IT::cut_to_disk(t));
  const auto cut = IT::flip_to_geodesic_cut(t);
  EXPECT_LE(length(t, cut.edges), before);
  const IT::Gluing_map opened(IT::cut_open(t, cut.edges).gluing);
  EXPECT_EQ(IT::connected_components(opened).count, 2U);
  EXPECT_EQ(IT::euler_characteristic(opened), 2);
  EXPECT_EQ(IT::boundary_loops(opened).size(), 2U);
}

TEST(Geodesic_cut, Generators_of_homology_become_closed_geodesics) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    Triangulation t(rough_torus(10, seed).input());
    const auto loops = IT::homology_generators(t);
    ASSERT_EQ(loops.size(), 2U);
    for (const auto& loop : loops) {
      IT::Curve_network<Triangulation> network(t);
      network.add_loop(loop);
      const double before = network.length();
      IT::Flip_log<Triangulation> log;
      EXPECT_EQ(IT::shorten_curves(network, log).status, IT::Status::done);
      EXPECT_LE(network.length(), before);
      EXPECT_GT(network.length(), 1);
      EXPECT_TRUE(IT::is_geodesic(network).is_geodesic());
      network.clear();
      Triangulation::Session session(t);
      log.undo(session);
    }
  }
}
