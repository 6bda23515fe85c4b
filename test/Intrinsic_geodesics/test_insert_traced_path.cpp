// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/curves/insert_polyline.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include "gallery.h"
#include "meshes.h"
#include "paths.h"
#include "validity.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Gluing_map;
using IT::Move_status;
using IT::Status;
using IT::Surface_point;
using Exact = IT::Exact_euclidean_traits;

template <class T>
class InsertTracedPath : public ::testing::Test {};
using Triangulations = ::testing::Types<
    IT::Intrinsic_triangulation<Gluing_map, Exact, IT::Integer_coordinates>,
    IT::Intrinsic_triangulation<Gluing_map, Exact, IT::No_correspondence>,
    IT::Intrinsic_triangulation<Gluing_map, IT::Euclidean_traits<double>, IT::Integer_coordinates>>;
TYPED_TEST_SUITE(InsertTracedPath, Triangulations);

template <class T>
T built(const gallery::Surface& s) {
  return T(IT::Intrinsic_input(Gluing_map(s.gluing), gallery::squared_lengths(s)));
}

template <class T, class Random>
IT::Geodesic random_geodesic(const T& t, double longest, Random& random) {
  const auto uniform = [&] { return (static_cast<double>(random()) + 0.5) / 0x1p32; };
  const auto f = t.numbers().face_at(static_cast<std::uint32_t>(random() % num_faces(t.mesh())));
  Surface_point start{t.numbers().halfedge(halfedge(f, t.mesh())), {1, 0, 0}};
  double a = uniform(), b = uniform();
  if (a + b > 1) a = 1 - a, b = 1 - b;
  switch (random() % 3) {
  case 0:
    start.weights = {a, b, 1 - a - b};
    break;
  case 1:
    start.weights = {0, a, 1 - a};
    break;
  default:
    break;
  }
  const double angle = 2 * std::numbers::pi * uniform();
  return trace_geodesic(t, start, {std::cos(angle), std::sin(angle)}, longest * uniform());
}

// Directions at random, so that no line meets itself but at one point or all along.
TYPED_TEST(InsertTracedPath, OnDeltaComplexesIsAPathOfItsLength) {
  std::mt19937 random(8);
  for (const gallery::Surface& s : gallery::oriented()) {
    if (s.expected.isolated_vertices > 0) continue;
    for (unsigned i = 0; i < 40; ++i) {
      auto t = built<TypeParam>(s);
      const IT::Geodesic g = random_geodesic(t, i % 4 == 0 ? 30 : 4, random);
      const auto path = insert_traced_path(t, g);
      EXPECT_TRUE(IT::is_valid_delta_complex(t.mesh())) << s.name << ", line " << i;
      EXPECT_EQ(path.status, Move_status::done) << s.name << ", line " << i;
      EXPECT_NEAR(paths::length_of_path(t, path.halfedges), g.length, 1e-9 * (1 + g.length))
          << s.name << ", line " << i;
    }
  }
}

// A line of slope 2/3 comes back to where it starts.
TYPED_TEST(InsertTracedPath, ThatIsClosedOnATorusEndsWhereItStarts) {
  for (const std::array<double, 3>& weights :
       {std::array{1.0, 0.0, 0.0}, std::array{0.5, 0.25, 0.25}, std::array{0.5, 0.5, 0.0}}) {
    auto t = built<TypeParam>(gallery::flat_torus(1, 1));
    const std::uint32_t h = t.numbers().halfedge(halfedge(t.numbers().face_at(0), t.mesh()));
    const auto g = trace_geodesic(t, {h, weights}, {3, 2}, std::hypot(3, 2));
    const auto path = insert_traced_path(t, g);
    ASSERT_EQ(path.status, Move_status::done);
    EXPECT_NEAR(paths::length_of_path(t, path.halfedges), std::hypot(3, 2), 1e-9);
    EXPECT_EQ(source(path.halfedges.front(), t.mesh()), target(path.halfedges.back(), t.mesh()));
  }
}

TYPED_TEST(InsertTracedPath, OnADelaunayTriangulationHasItsLength) {
  std::mt19937 random(9);
  for (unsigned i = 0; i < 40; ++i) {
    const meshes::Mesh m = i % 2 == 0 ? meshes::potato(2, i) : meshes::rough_grid(6, i, 2);
    TypeParam t(m.input());
    flip_to_delaunay(t);
    const IT::Geodesic g = random_geodesic(t, 20, random);
    const auto path = insert_traced_path(t, g);
    ASSERT_EQ(path.status, Move_status::done) << "line " << i;
    EXPECT_NEAR(paths::length_of_path(t, path.halfedges), g.length, 1e-9 * g.length)
        << "line " << i;
  }
}

TYPED_TEST(InsertTracedPath, OfNoLengthIsAPoint) {
  auto t = built<TypeParam>(gallery::tetrahedron());
  const auto path = insert_traced_path(t, trace_geodesic(t, {0, {0.5, 0.25, 0.25}}, {1, 0}, 0));
  EXPECT_EQ(path.status, Move_status::done);
  EXPECT_TRUE(path.halfedges.empty());
  EXPECT_EQ(num_vertices(t.mesh()), 5U);
}

} // namespace
