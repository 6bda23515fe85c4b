// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/retriangulation/extrinsic/extrinsic_delaunay.h>

#include "meshes.h"
#include "surface_mesh.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using meshes::Point;
using Triangle = std::array<std::uint32_t, 3>;

using meshes::cross, meshes::dot, meshes::minus, meshes::norm;

/// The angles opposite to each pair of vertices that an edge joins, from coordinates alone.
std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<double>>
opposite_angles(const IT::Extrinsic_delaunay_mesh& m) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<double>> result;
  for (const Triangle& t : m.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t i = t[k], j = t[(k + 1) % 3], apex = t[(k + 2) % 3];
      const Point a = minus(m.points[i], m.points[apex]), b = minus(m.points[j], m.points[apex]);
      result[std::minmax(i, j)].push_back(std::atan2(norm(cross(a, b)), dot(a, b)));
    }
  return result;
}

std::vector<std::pair<std::string, meshes::Mesh>> surfaces() {
  std::vector<std::pair<std::string, meshes::Mesh>> result{
      {"box", meshes::box(2, 3, 4)},
      {"cap", meshes::with_cap(meshes::box(1, 1, 1), 0)},
      {"sheared grid", meshes::sheared_grid(4, 4, 5)},
      {"stairs", meshes::stairs(3, 3, 2)},
      {"l shape", meshes::l_shape(2)},
      {"prism", meshes::prism({{0, 0}, {7, 0}, {9, 2}, {3, 5}}, 2)}};
  for (unsigned seed = 1; seed <= 4; ++seed) {
    result.emplace_back("rough grid " + std::to_string(seed), meshes::rough_grid(5, seed));
    result.emplace_back("potato " + std::to_string(seed), meshes::potato(1, seed));
    result.emplace_back("terrain " + std::to_string(seed), meshes::integer_terrain(30, 50, seed));
  }
  return result;
}

TEST(extrinsic_delaunay, all_edges_are_delaunay_on_the_same_surface) {
  for (const auto& [name, m] : surfaces()) {
    const Mesh mesh = meshes::surface_mesh<Mesh>(m);
    const IT::Extrinsic_delaunay_mesh d = IT::extrinsic_delaunay(mesh);
    ASSERT_EQ(d.status, IT::Status::done) << name;
    ASSERT_EQ(d.input_face.size(), d.triangles.size()) << name;
    ASSERT_EQ(d.points.size(), m.points.size() + d.counts.inserted_vertices()) << name;
    EXPECT_TRUE(std::equal(m.points.begin(), m.points.end(), d.points.begin())) << name;
    // coordinates are rounded by 2^-53 of a size below 64; angles by that over the least height,
    // about 1e-2
    EXPECT_NEAR(meshes::area({d.points, d.triangles}) / meshes::area(m), 1, 1e-13) << name;
    for (const auto& [ends, angles] : opposite_angles(d)) {
      ASSERT_LE(angles.size(), 2u) << name;
      if (angles.size() == 1) continue;
      EXPECT_LE(angles[0] + angles[1], 3.14159265358979323846 + 1e-11)
          << name << ' ' << ends.first << ' ' << ends.second;
    }
  }
}

TEST(extrinsic_delaunay, triangles_lie_in_the_planes_of_input_faces) {
  for (const auto& [name, m] : surfaces()) {
    const IT::Extrinsic_delaunay_mesh d =
        IT::extrinsic_delaunay(meshes::surface_mesh<Mesh>(m), IT::parameters::minimum_angle(20));
    for (std::size_t i = 0; i < d.triangles.size(); ++i) {
      const Triangle& face = m.triangles[d.input_face[i]];
      const Point origin = m.points[face[0]], normal = cross(minus(m.points[face[1]], origin),
                                                             minus(m.points[face[2]], origin));
      ASSERT_GT(norm(normal), 0) << name; // a triangle with area lies over no cap
      for (const std::uint32_t v : d.triangles[i])
        EXPECT_NEAR(dot(normal, minus(d.points[v], origin)) / norm(normal), 0, 1e-12) << name;
      const Triangle& t = d.triangles[i];
      EXPECT_GT(dot(normal, cross(minus(d.points[t[1]], d.points[t[0]]),
                                  minus(d.points[t[2]], d.points[t[0]]))),
                0)
          << name << ": turned around";
    }
  }
}

TEST(extrinsic_delaunay, inserts_nothing_where_flips_in_planes_are_enough) {
  for (const meshes::Mesh& m :
       {meshes::box(2, 3, 4), meshes::sheared_grid(4, 4, 5), meshes::random_planar(40, 1000, 3)})
    EXPECT_EQ(IT::extrinsic_delaunay(meshes::surface_mesh<Mesh>(m)).counts.circumcenters, 0u);
  EXPECT_EQ(IT::extrinsic_delaunay(meshes::surface_mesh<Mesh>(meshes::box(2, 3, 4)))
                .counts.inserted_vertices(),
            0u);
}

TEST(extrinsic_delaunay, refuses_lengths_that_are_not_those_of_points) {
  const meshes::Mesh m = meshes::box(1, 1, 1);
  const IT::Gluing_map map = m.map();
  const IT::Corresponding_triangulation t(
      IT::Intrinsic_input(map, std::vector<double>(map.number_of_edges(), 1)));
  EXPECT_THROW(IT::bent_edges(t.input()), IT::Invalid_input);
}

} // namespace
