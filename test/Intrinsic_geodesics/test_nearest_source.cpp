// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/distance/farthest_points.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>

#include "gallery.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

// Oracle: a search from each source alone.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
namespace parameters = IT::parameters;
using IT::Surface_point;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;
using Vertex = Triangulation::vertex_descriptor;
using Distance = IT::Polyhedral_distance<Triangulation>;

constexpr double infinity = std::numeric_limits<double>::infinity();

Surface_point random_point(const Triangulation& t, std::mt19937& random) {
  std::uniform_real_distribution<double> u(0, 1);
  const double a = u(random), b = u(random) * (1 - a);
  const auto f = static_cast<std::uint32_t>(random() % num_faces(t.mesh()));
  return {t.numbers().halfedge(halfedge(t.numbers().face_at(f), t.mesh())), {1 - a - b, a, b}};
}

std::vector<Surface_point> random_points(const Triangulation& t, std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Surface_point> result;
  while (result.size() < n) {
    result.push_back(random_point(t, random));
    if (result.size() % 2 == 0) result.back().weights = {1, 0, 0}; // a vertex
  }
  return result;
}

std::vector<Triangulation> surfaces() {
  std::vector<Triangulation> result;
  for (const meshes::Mesh& m :
       {meshes::grid(9, 7), meshes::rough_grid(9, 5), meshes::sphere(2), meshes::potato(2, 3),
        meshes::box(3, 2, 4), meshes::stairs(4, 3), meshes::sheared_grid(4, 4, 3.7)})
    result.emplace_back(m.input());
  result.emplace_back(gallery::input(gallery::flat_torus(5, 4)));
  result.emplace_back(gallery::input(gallery::tetrahedron()));
  return result;
}

/// Compares distance and nearest source of a place with searches from each source.
template <class Place>
void expect_nearest(const Distance& all, const std::vector<Distance>& alone, const Place& p) {
  double least = infinity;
  for (const Distance& d : alone) least = std::min(least, d.distance(p));
  EXPECT_NEAR(all.distance(p), least, 1e-12 * (1 + least));
  const std::uint32_t nearest = all.nearest_source(p);
  ASSERT_LT(nearest, alone.size());
  EXPECT_NEAR(alone[nearest].distance(p), least, 1e-12 * (1 + least));
}

void expect_nearest_everywhere(const Distance& all, const std::vector<Surface_point>& sources,
                               unsigned seed) {
  SCOPED_TRACE(seed);
  const Triangulation& t = all.triangulation();
  std::vector<Distance> alone;
  for (const Surface_point& p : sources) alone.emplace_back(t, p);
  for (const Vertex v : vertices(t.mesh())) expect_nearest(all, alone, v);
  for (const Surface_point& p : random_points(t, 100, seed + 1)) expect_nearest(all, alone, p);
}

TEST(Nearest_source, is_that_of_searches_from_each_source_alone) {
  unsigned seed = 0;
  for (const Triangulation& t : surfaces()) {
    const auto sources = random_points(t, 7, ++seed);
    expect_nearest_everywhere(Distance(t, sources), sources, seed);
  }
}

TEST(Nearest_source, of_many_sources_in_few_faces_is_the_same) {
  unsigned seed = 200;
  for (const meshes::Mesh& m : {meshes::grid(1, 1), meshes::sheared_grid(2, 2, 2.3),
                                meshes::sheared_grid(4, 4, 3.7), meshes::box(1, 1, 1)}) {
    const Triangulation t(m.input());
    for (unsigned k = 0; k < 5; ++k) {
      const auto sources = random_points(t, 12, ++seed);
      expect_nearest_everywhere(Distance(t, sources), sources, seed);
    }
  }
}

TEST(Nearest_source, of_sources_added_one_by_one_is_the_same) {
  unsigned seed = 100;
  for (const Triangulation& t : surfaces()) {
    const auto sources = random_points(t, 7, ++seed);
    Distance all(t);
    for (const Surface_point& p : sources) {
      EXPECT_EQ(all.add_source(p), IT::Status::done);
      all.distance(sources.front()); // in a face: keeps windows
    }
    EXPECT_EQ(all.number_of_sources(), sources.size());
    expect_nearest_everywhere(all, sources, seed);
  }
}

TEST(Nearest_source, paths_after_sources_are_added_end_at_the_nearest) {
  const Triangulation t(meshes::rough_grid(12, 3).input());
  const auto sources = random_points(t, 9, 5);
  Distance all(t, sources.front());
  for (std::size_t i = 1; i < sources.size(); ++i) all.add_source(sources[i]);
  for (const Vertex v : vertices(t.mesh())) {
    const IT::Shortest_path path = all.shortest_path(v);
    EXPECT_EQ(path.status, IT::Status::done);
    const Distance one(t, sources[all.nearest_source(v)]);
    EXPECT_NEAR(one.distance(path.points.front()), 0, 1e-7);
  }
}

TEST(Nearest_source, is_none_beyond_the_reach_of_the_search) {
  const Triangulation t(meshes::grid(10, 10).input());
  const Vertex first = t.numbers().vertex_at(0);
  Distance d(t, first, parameters::maximum_distance(3.5));
  for (const Vertex v : vertices(t.mesh()))
    EXPECT_EQ(d.nearest_source(v), std::isinf(d.distance(v)) ? IT::Gluing::none : 0U);
  EXPECT_EQ(Distance(t).nearest_source(first), IT::Gluing::none);
  const Vertex last = t.numbers().vertex_at(120);
  d.add_source(last); // as far as before
  for (const Vertex v : vertices(t.mesh())) {
    const double expected = std::min(Distance(t, first).distance(v), Distance(t, last).distance(v));
    EXPECT_NEAR(std::min(d.distance(v), 4.0), std::min(expected > 3.5 ? 4.0 : expected, 4.0),
                1e-12);
  }
}

TEST(Nearest_source, searches_after_others_find_what_a_new_object_finds) {
  for (const Triangulation& t : surfaces()) {
    const auto sources = random_points(t, 12, 11);
    Distance used(t);
    for (std::size_t i = 0; i + 2 < sources.size(); ++i) {
      const Surface_point &p = sources[i], &q = sources[i + 1], &r = sources[i + 2];
      used.search(p, parameters::targets(q)); // cut short, with windows in the queue
      used.search(r, parameters::maximum_number(i + 1));
      used.search(p);
      used.add_source(q);
      Distance fresh(t, p);
      fresh.add_source(q);
      EXPECT_EQ(used.distances(), fresh.distances());
      EXPECT_EQ(used.number_of_windows(), fresh.number_of_windows());
      EXPECT_EQ(used.distance(r), fresh.distance(r));
    }
  }
}

// ---- farthest points

TEST(Farthest_points, are_those_of_a_search_from_all_before) {
  for (const Triangulation& t : surfaces()) {
    const Vertex first = *vertices(t.mesh()).begin();
    Distance d(t, first);
    const std::size_t most = std::min<std::size_t>(8, t.number_of_vertices() - 1);
    const auto found = IT::farthest_points(d, most);
    ASSERT_EQ(found.vertices.size(), most);
    std::vector<Vertex> sources{first};
    for (std::size_t i = 0; i <= most; ++i) {
      const std::vector<double> all = Distance(t, sources).distances();
      const double radius = std::ranges::max(all);
      if (i == most) {
        EXPECT_NEAR(found.radius, radius, 1e-12 * radius);
      } else {
        EXPECT_NEAR(all[t.input_vertex(found.vertices[i])], radius, 1e-12 * radius);
        sources.push_back(found.vertices[i]);
      }
    }
  }
}

TEST(Farthest_points, reach_each_component_first_and_end_with_the_vertices) {
  meshes::Mesh m = meshes::grid(2, 2);
  const auto n = static_cast<std::uint32_t>(m.points.size());
  const meshes::Mesh other = meshes::grid(1, 1);
  m.points.insert(m.points.end(), other.points.begin(), other.points.end());
  for (const auto& f : other.triangles) m.triangles.push_back({f[0] + n, f[1] + n, f[2] + n});
  const Triangulation t(m.input());
  Distance d(t);
  const auto two = IT::farthest_points(d, 2);
  ASSERT_EQ(two.vertices.size(), 2U);
  EXPECT_LT(t.index(two.vertices[0]), n);
  EXPECT_GE(t.index(two.vertices[1]), n);
  EXPECT_TRUE(std::isfinite(two.radius));
  const auto others = IT::farthest_points(d, 100);
  EXPECT_EQ(others.vertices.size(), t.number_of_vertices() - 2);
  EXPECT_EQ(others.radius, 0);
}

TEST(Farthest_points, end_when_the_visitor_says_so) {
  struct Visitor {
    bool progress(std::uint64_t, double) { return false; }
  };
  const Triangulation t(meshes::rough_grid(160, 4).input());
  Distance d(t, *vertices(t.mesh()).begin());
  const auto found = IT::farthest_points(d, 3, parameters::visitor(Visitor()));
  EXPECT_EQ(found.status, IT::Status::cancelled);
  EXPECT_TRUE(found.vertices.empty());
}

} // namespace
