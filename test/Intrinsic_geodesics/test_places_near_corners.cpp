// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/curves/insert_point.h>
#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>

#include "meshes.h"
#include "numbered_as_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

// Distances change by no more than a source or target moves, as near to a corner as doubles go.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Surface_point;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;
using Distance = IT::Polyhedral_distance<Triangulation>;

/// A point at 10^-1 to 10^-18 of a side from a corner, or also from a side.
Surface_point near_corner(const Triangulation& t, std::mt19937& random) {
  const auto uniform = [&random] { return static_cast<double>(random()) / 0x1p32; };
  const double a = uniform() * std::pow(10, -1 - double(random() % 18)) / 2;
  const double b = random() % 4 == 0 ? 0 : uniform() * std::pow(10, -1 - double(random() % 18)) / 2;
  const auto h = static_cast<std::uint32_t>(random() % (2 * num_edges(t.mesh())));
  return {h, {1 - a - b, a, b}};
}

double length_of_move(const Triangulation& t, const meshes::Mesh& m, const Surface_point& p,
                      const Surface_point& q) {
  std::array<double, 3> v{};
  auto h = t.numbers().halfedge_at(p.halfedge);
  for (std::size_t k = 0; k < 3; ++k, h = next(h, t.mesh()))
    for (std::size_t j = 0; j < 3; ++j)
      v[j] += (p.weights[k] - q.weights[k]) * m.points[t.index(source(h, t.mesh()))][j];
  return std::hypot(v[0], v[1], v[2]);
}

TEST(PlacesNearCorners, distances_are_continuous) {
  std::mt19937 random(52);
  double most = 0;
  for (unsigned i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const meshes::Mesh m = meshes::potato(1, i);
    const Triangulation t = numbered_as<Triangulation>(m);
    for (int k = 0; k < 8; ++k) {
      const Surface_point p = near_corner(t, random), r = near_corner(t, random);
      const Surface_point corner{p.halfedge, {1, 0, 0}};
      const Distance from_point(t, p), from_corner(t, corner), back(t, r);
      const double moved = length_of_move(t, m, p, corner);
      for (const auto v : vertices(t.mesh()))
        most = std::max(most, std::abs(from_point.distance(v) - from_corner.distance(v)) - moved);
      most = std::max(most, std::abs(from_point.distance(r) - from_corner.distance(r)) - moved);
      most = std::max(most, std::abs(from_point.distance(r) - back.distance(p)));
    }
  }
  EXPECT_LE(most, 1e-12); // diameters are about 4
}

/// A point at a side, after one close to the corner that both have: it is inserted where it is, not
/// where weights end up whose sum was made 1 again without regard to the shape of the thin face.
TEST(PlacesNearCorners, points_at_sides_stay_along_them) {
  std::mt19937 random(54);
  double most = 0;
  for (unsigned i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const meshes::Mesh m = meshes::potato(1, i);
    Triangulation t = numbered_as<Triangulation>(m);
    const auto h = static_cast<std::uint32_t>(random() % (2 * num_edges(t.mesh())));
    const double a = std::pow(10, -9 - double(i % 3)), b = double(1 + random() % 9) / 10;
    const Surface_point close{h, {1 - a, a, 0}},
        far{t.input().next(t.input().next(h)), {b, 1 - b, 0}};
    ASSERT_EQ(IT::insert_point(t, close).status, IT::Move_status::done);
    const auto inserted = IT::insert_point(t, far);
    ASSERT_EQ(inserted.status, IT::Move_status::done);
    ASSERT_TRUE(inserted.is_new);
    const Surface_point place = t.places()->location(t.index(inserted.vertex));
    ASSERT_EQ(place.halfedge / 2, far.halfedge / 2);
    const double x = place.halfedge == far.halfedge ? place.weights[1] : place.weights[0];
    most = std::max(most, std::abs(x - (1 - b)));
  }
  EXPECT_LE(most, 1e-12); // faces as thin as 1e-11 were 1e-6 to 1e-4 off
}

} // namespace
