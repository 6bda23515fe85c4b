// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/insert_polyline.h>
#include <CGAL/Intrinsic_geodesics/shortening/certify_geodesic.h>
#include <CGAL/Intrinsic_geodesics/shortening/is_geodesic.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>

#include "delaunay.h"
#include "gallery.h"
#include "meshes.h"
#include "paths.h"
#include "planar_bezier.h"
#include "validity.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Gluing_map;
using IT::Move_status;
using IT::Status;
using IT::Surface_point;
using Exact = IT::Exact_euclidean_traits;
using planar_bezier::distance;

template <class T>
class InsertPolyline : public ::testing::Test {};
using Triangulations = ::testing::Types<
    IT::Intrinsic_triangulation<Gluing_map, Exact, IT::Integer_coordinates>,
    IT::Intrinsic_triangulation<Gluing_map, Exact, IT::Explicit_crossings>,
    IT::Intrinsic_triangulation<Gluing_map, Exact, IT::Signposts>,
    IT::Intrinsic_triangulation<Gluing_map, IT::Euclidean_traits<double>, IT::Integer_coordinates>>;
TYPED_TEST_SUITE(InsertPolyline, Triangulations);

/// A polyline that goes on from face to face at random, with bends inside and points on edges; now
/// and then to a vertex.
template <class Random>
std::vector<Surface_point> random_polyline(const IT::Input& input, std::size_t n, Random& random) {
  const auto uniform = [&] { return (static_cast<double>(random()) + 0.5) / 0x1p32; };
  std::uint32_t h =
      input.halfedge_of_face(static_cast<std::uint32_t>(random() % input.number_of_faces()));
  std::vector<Surface_point> points;
  while (points.size() < n) {
    if (random() % 8 == 0) {
      points.push_back({h, {1, 0, 0}});
      continue;
    }
    double a = uniform(), b = uniform();
    if (a + b > 1) a = 1 - a, b = 1 - b;
    points.push_back({h, {a, b, 1 - a - b}});
    for (auto k = random() % 3; k > 0; --k) h = input.next(h);
    if (input.is_border(h ^ 1U)) continue;
    const double x = uniform();
    points.push_back({h, {1 - x, x, 0}});
    h ^= 1U;
  }
  return points;
}

/// Where a vertex is on the input.
template <class T>
Surface_point place(const T& t, typename T::vertex_descriptor v) {
  auto h = halfedge(v, t.mesh());
  if (face(h, t.mesh()) == boost::graph_traits<typename T::Mesh>::null_face())
    return *locate_on_input(t, {t.numbers().halfedge(opposite(h, t.mesh())), {1, 0, 0}});
  return *locate_on_input(t, {t.numbers().halfedge(h), {0, 1, 0}});
}

TYPED_TEST(InsertPolyline, IsAPathOfItsLengthThroughItsPoints) {
  std::mt19937 random(3);
  for (unsigned i = 0; i < 40; ++i) {
    const meshes::Mesh m = i % 2 == 0 ? meshes::potato(2, i) : meshes::rough_grid(6, i, 2);
    auto t = delaunay<TypeParam>(m.input());
    const auto points = random_polyline(t.input(), 2 + i, random);
    const auto in_space = [&](const Surface_point& p) { return point_in_space(t, p, m.points); };
    double length = 0;
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      length += distance(in_space(points[k]), in_space(points[k + 1]));
    const auto path = insert_polyline(t, points);
    ASSERT_EQ(path.status, Move_status::done) << "polyline " << i;
    ASSERT_EQ(path.vertices.size(), points.size());
    EXPECT_NEAR(paths::length_of_path(t, path.halfedges), length, 1e-9 * length)
        << "polyline " << i;
    EXPECT_EQ(source(path.halfedges.front(), t.mesh()), path.vertices.front());
    EXPECT_EQ(target(path.halfedges.back(), t.mesh()), path.vertices.back());
    for (std::size_t k = 0; k < points.size(); ++k)
      EXPECT_LT(distance(in_space(place(t, path.vertices[k])), in_space(points[k])), 1e-9)
          << "point " << k << " of polyline " << i;
  }
}

TEST(InsertPolylineAndShorten, GivesAGeodesicThatIsCertified) {
  using T = IT::Intrinsic_triangulation<Gluing_map, Exact, IT::Integer_coordinates>;
  std::mt19937 random(4);
  unsigned shortened = 0;
  for (unsigned i = 0; i < 60; ++i) {
    auto t = delaunay<T>(meshes::potato(2, i).input());
    const auto path =
        insert_polyline(t, random_polyline(t.correspondence().input(), 3 + i % 12, random));
    ASSERT_EQ(path.status, Move_status::done);
    IT::Curve_network<T> network(t);
    try {
      network.add_path(path.halfedges);
    } catch (const IT::Invalid_input&) {
      continue; // crosses itself
    }
    const double before = network.length();
    EXPECT_EQ(shorten_curves(network).status, Status::done);
    EXPECT_LE(network.length(), before * (1 + 1e-12));
    EXPECT_TRUE(is_geodesic(network).is_geodesic());
    EXPECT_TRUE(certify_geodesic(network).is_geodesic());
    ++shortened;
  }
  EXPECT_GT(shortened, 15U);
}

TYPED_TEST(InsertPolyline, ThatPassesItsPointsAgainHasTheirVerticesAgain) {
  auto t = delaunay<TypeParam>(meshes::rough_grid(6, 1, 2).input());
  const std::uint32_t h = t.correspondence().input().halfedge_of_face(30);
  const Surface_point a{h, {0.5, 0.25, 0.25}}, b{h, {0.25, 0.5, 0.25}}, c{h, {0.25, 0.25, 0.5}};
  const auto path = insert_polyline(t, {a, b, c, a, b});
  ASSERT_EQ(path.status, Move_status::done);
  EXPECT_EQ(path.vertices[0], path.vertices[3]);
  EXPECT_EQ(path.vertices[1], path.vertices[4]);
  const auto again = insert_polyline(t, {c, b});
  EXPECT_EQ(again.status, Move_status::done);
  EXPECT_EQ(again.vertices[0], path.vertices[2]);
}

TYPED_TEST(InsertPolyline, WithPointsInDifferentFacesIsRefused) {
  auto t = delaunay<TypeParam>(meshes::rough_grid(6, 1).input());
  const IT::Input& input = t.correspondence().input();
  const auto vertices = num_vertices(t.mesh());
  const Surface_point a{input.halfedge_of_face(3), {0.5, 0.25, 0.25}},
      b{input.halfedge_of_face(30), {0.5, 0.25, 0.25}};
  EXPECT_THROW(insert_polyline(t, {a, b}), IT::Invalid_input);
  EXPECT_EQ(num_vertices(t.mesh()), vertices);
  EXPECT_TRUE(insert_polyline(t, {a}).halfedges.empty());
  EXPECT_TRUE(insert_polyline(t, {}).vertices.empty());
}

// Along input edges, the border among them, which the Delaunay triangulation may have flipped.
TYPED_TEST(InsertPolyline, RunsAlongTheBorder) {
  auto t = delaunay<TypeParam>(meshes::rough_grid(5, 2, 2).input());
  const IT::Input& input = t.correspondence().input();
  std::uint32_t h = 0;
  while (!input.is_border(h ^ 1U) || input.is_border(h)) ++h;
  const auto path = insert_polyline(
      t,
      {{h, {0.75, 0.25, 0}}, {h, {0, 1, 0}}, {input.next(h), {0.5, 0.5, 0}}, {h, {0.5, 0.5, 0}}});
  ASSERT_EQ(path.status, Move_status::done);
  for (const auto v : {path.vertices[0], path.vertices[1], path.vertices[3]})
    EXPECT_EQ(face(halfedge(v, t.mesh()), t.mesh()),
              boost::graph_traits<typename TypeParam::Mesh>::null_face());
}

// The points of a traced geodesic are a polyline: as long, and straight.
TYPED_TEST(InsertPolyline, ThroughThePointsOfAGeodesicHasItsLength) {
  std::mt19937 random(9);
  const auto uniform = [&] { return (static_cast<double>(random()) + 0.5) / 0x1p32; };
  for (unsigned i = 0; i < 40; ++i) {
    const meshes::Mesh m = i % 2 == 0 ? meshes::potato(2, i) : meshes::rough_grid(6, i, 2);
    auto t = delaunay<TypeParam>(m.input());
    Surface_point start = random_polyline(t.input(), 1, random)[0];
    if (i % 3 == 1) start.weights = {0, start.weights[0], 1 - start.weights[0]};
    if (i % 3 == 2) start.weights = {1, 0, 0};
    const double angle = 2 * std::numbers::pi * uniform();
    const IT::Geodesic g =
        trace_geodesic_on_input(t, start, {std::cos(angle), std::sin(angle)}, 20 * uniform());
    const auto path = insert_polyline(t, g.points);
    ASSERT_EQ(path.status, Move_status::done) << "line " << i;
    EXPECT_NEAR(paths::length_of_path(t, path.halfedges), g.length, 1e-9 * g.length)
        << "line " << i;
  }
}

// A line of slope 2/3 comes back to where it starts.
TYPED_TEST(InsertPolyline, ThroughTheClosedGeodesicOfATorusEndsWhereItStarts) {
  for (const std::array<double, 3>& weights :
       {std::array{1.0, 0.0, 0.0}, std::array{0.5, 0.25, 0.25}, std::array{0.5, 0.5, 0.0}}) {
    auto t = delaunay<TypeParam>(gallery::input(gallery::flat_torus(3, 3)));
    const std::uint32_t h = t.input().halfedge_of_face(0);
    const double length = 3 * std::hypot(3, 2) * std::sqrt(t.input().squared_length(h / 2));
    std::vector<Surface_point> points =
        trace_geodesic_on_input(t, {h, weights}, {3, 2}, length).points;
    points.back() = points.front(); // without rounding
    const auto path = insert_polyline(t, points);
    ASSERT_EQ(path.status, Move_status::done);
    EXPECT_NEAR(paths::length_of_path(t, path.halfedges), length, 1e-9);
    EXPECT_EQ(source(path.halfedges.front(), t.mesh()), target(path.halfedges.back(), t.mesh()));
  }
}

} // namespace
