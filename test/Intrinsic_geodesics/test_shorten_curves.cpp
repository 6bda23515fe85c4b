// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/shortening/certify_geodesic.h>
#include <CGAL/Intrinsic_geodesics/shortening/is_geodesic.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>

#include "gallery.h"
#include "mesh_types.h"
#include "meshes.h"
#include "numbered_as_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Curve_network;
using IT::Geodesic_report;
using IT::Gluing_map;
using IT::Joint_report;
using IT::Shortening_result;
using IT::Status;
using Exact = IT::Exact_euclidean_traits;
using Triangulation = IT::Intrinsic_triangulation<Gluing_map, Exact, IT::Integer_coordinates>;

/// The halfedge between two vertices with one common edge.
template <class T>
typename T::halfedge_descriptor halfedge_between(const T& t, std::uint32_t from, std::uint32_t to) {
  for (const auto h : halfedges(t.mesh()))
    if (t.index(source(h, t.mesh())) == from && t.index(target(h, t.mesh())) == to) return h;
  ADD_FAILURE() << "no halfedge from " << from << " to " << to;
  return *halfedges(t.mesh()).begin();
}

template <class T>
std::vector<typename T::halfedge_descriptor> way(const T& t,
                                                 const std::vector<std::uint32_t>& vertices) {
  std::vector<typename T::halfedge_descriptor> result;
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
    result.push_back(halfedge_between(t, vertices[i], vertices[i + 1]));
  return result;
}

/// Both certificates, which must agree on every joint.
template <class Network>
void expect_geodesic(const Network& network) {
  const Geodesic_report exact = is_geodesic(network), integers = certify_geodesic(network);
  EXPECT_TRUE(exact.is_geodesic());
  EXPECT_TRUE(integers.is_geodesic());
  ASSERT_EQ(exact.joints.size(), integers.joints.size());
  for (std::size_t i = 0; i < exact.joints.size(); ++i) {
    EXPECT_EQ(exact.joints[i].left.angle, integers.joints[i].left.angle);
    EXPECT_EQ(exact.joints[i].right.angle, integers.joints[i].right.angle);
  }
}

/// Sum of a few rounded lengths: every one to 1e-12.
constexpr double length_error = 1e-11;

TEST(ShortenCurves, AStaircaseOnAGridBecomesTheDiagonal) {
  constexpr std::uint32_t n = 6, m = 4; // 2^k would make the diagonal run through vertices
  Triangulation t(meshes::grid(n, m).input());
  std::vector<std::uint32_t> vertices; // (x, y) has the number (n + 1) y + x
  for (std::uint32_t x = 0; x <= n; ++x) vertices.push_back(x);
  for (std::uint32_t y = 1; y <= m; ++y) vertices.push_back((n + 1) * y + n);
  Curve_network<Triangulation> network(t);
  // along the border: one side has no faces, the other all
  network.add_path(way(t, vertices));
  const Shortening_result r = shorten_curves(network);
  EXPECT_EQ(r.status, Status::done);
  EXPECT_NEAR(network.length(0), std::hypot(n, m), length_error);
  EXPECT_EQ(network.halfedges(0).size(), 2U); // through the vertex in the middle, (3, 2)
  expect_geodesic(network);
  for (const Joint_report& j : is_geodesic(network).joints) {
    EXPECT_EQ(j.left.angle, CGAL::EQUAL);
    EXPECT_EQ(j.right.angle, CGAL::EQUAL);
  }
}

TEST(ShortenCurves, APathOverTwoFacesOfACubeIsTheDiagonalOfTheirNet) {
  const meshes::Mesh cube = meshes::box(1, 1, 1);
  Triangulation t = numbered_as<Triangulation>(cube);
  const auto vertex = [&](double x, double y, double z) {
    for (std::uint32_t v = 0; v < cube.points.size(); ++v)
      if (cube.points[v] == meshes::Point{x, y, z}) return v;
    return 0U;
  };
  Curve_network<Triangulation> network(t);
  network.add_path(way(t, {vertex(0, 0, 0), vertex(1, 0, 0), vertex(1, 1, 0), vertex(1, 1, 1)}));
  EXPECT_EQ(shorten_curves(network).status, Status::done);
  EXPECT_NEAR(network.length(0), std::sqrt(5.0), length_error);
  expect_geodesic(network);
}

// ---- Random walks

template <class T, class Random>
std::vector<typename T::halfedge_descriptor> random_walk(const T& t, std::size_t steps,
                                                         Random& random) {
  std::vector<typename T::halfedge_descriptor> result;
  auto v = t.numbers().vertex_at(static_cast<std::uint32_t>(random() % num_vertices(t.mesh())));
  for (std::size_t i = 0; i < steps; ++i) {
    std::vector<typename T::halfedge_descriptor> out;
    IT::for_each_outgoing(v, t.mesh(), [&](auto h) { out.push_back(h); });
    result.push_back(out[random() % out.size()]);
    v = target(result.back(), t.mesh());
  }
  return result;
}

/// Adds a curve unless it crosses another or itself.
template <class Network, class Halfedges>
bool add_if_it_does_not_cross(Network& network, const Halfedges& halfedges, bool is_loop) {
  try {
    is_loop ? network.add_loop(halfedges) : network.add_path(halfedges);
    return true;
  } catch (const IT::Invalid_input&) {
    return false;
  }
}

/// Vectors along the sides of a torus of unit squares, see `gallery::flat_torus()`.
std::vector<std::array<int, 2>> displacements(const Triangulation& t) {
  std::vector<std::array<int, 2>> result(2 * num_edges(t.mesh()));
  for (const auto f : faces(t.mesh())) {
    const int sign = t.index(f) % 2 == 0 ? 1 : -1;
    auto h = halfedge(f, t.mesh());
    for (const auto& [x, y] : {std::array{1, 0}, std::array{0, 1}, std::array{-1, -1}}) {
      result[t.numbers().halfedge(h)] = {sign * x, sign * y};
      h = next(h, t.mesh());
    }
  }
  return result;
}

template <class Network>
bool is_straight(const Network& network) {
  const Geodesic_report report = is_geodesic(network);
  return std::all_of(report.joints.begin(), report.joints.end(),
                     [](const Joint_report& j) { return j.is_straight(); });
}

// On a flat torus every curve gets the length of the vector that it goes along, however it winds: a straight line. Loops
// along no vector contract.
TEST(ShortenCurves, CurvesOnAFlatTorusGetTheLengthOfTheirClass) {
  std::mt19937 random(5);
  unsigned loops = 0, paths = 0, contracted = 0, blocked = 0;
  for (unsigned i = 0; i < 1500; ++i) {
    const auto size = [&] { return static_cast<std::uint32_t>(1 + random() % 4); };
    const gallery::Surface s = gallery::flat_torus(size(), size());
    Triangulation t(gallery::input(s));
    const auto vectors = displacements(t);
    const auto walk = random_walk(t, 1 + random() % 12, random);
    const bool is_loop = source(walk.front(), t.mesh()) == target(walk.back(), t.mesh());
    int x = 0, y = 0;
    for (const auto h : walk) {
      x += vectors[t.numbers().halfedge(h)][0];
      y += vectors[t.numbers().halfedge(h)][1];
    }
    Curve_network<Triangulation> network(t);
    if (!add_if_it_does_not_cross(network, walk, is_loop)) continue;
    ASSERT_EQ(shorten_curves(network).status, Status::done) << "walk " << i;
    // a path that winds about its own end cannot pass it
    if (is_loop || is_straight(network)) {
      EXPECT_NEAR(network.length(0), std::hypot(x, y), length_error) << "walk " << i;
    } else {
      EXPECT_GT(network.length(0), std::hypot(x, y)) << "walk " << i;
    }
    if (is_loop) {
      EXPECT_EQ(network.is_point(0), x == 0 && y == 0) << "walk " << i;
    }
    expect_geodesic(network);
    ++(is_loop ? network.is_point(0) ? contracted : loops : paths);
    blocked += !is_straight(network);
  }
  EXPECT_GT(loops, 50U);
  EXPECT_GT(contracted, 50U);
  EXPECT_GT(paths, 100U);
  EXPECT_LT(blocked, 20U);
}

/// Whether curves cross at a vertex.
template <class T>
bool has_crossing(const T& t, const Curve_network<T>& network) {
  for (const auto e : edges(t.mesh()))
    if (network.carries_curve(e))
      for (const auto h : {halfedge(e, t.mesh()), opposite(halfedge(e, t.mesh()), t.mesh())})
        if (network.has_crossing_at_source(h)) return true;
  return false;
}

template <class T>
class ShortenCurvesOn : public ::testing::Test {};
using Triangulations = ::testing::Types<
    Triangulation, IT::Intrinsic_triangulation<Gluing_map, Exact, IT::No_correspondence>,
    IT::Intrinsic_triangulation<Gluing_map, IT::Euclidean_traits<double>, IT::Integer_coordinates>,
    IT::Intrinsic_triangulation<Gluing_map, Exact, IT::Signposts>,
    IT::Intrinsic_triangulation<Surface_mesh, Exact, IT::Explicit_crossings>,
    IT::Intrinsic_triangulation<OpenMesh_triangles, Exact, IT::Integer_coordinates>>;
TYPED_TEST_SUITE(ShortenCurvesOn, Triangulations);

// Networks of random walks, on surfaces where an edge has one face on both sides, or one vertex at both ends: shortening ends,
// lengths decrease, nothing crosses, what can be decided is straight.
TYPED_TEST(ShortenCurvesOn, DeltaComplexesMakesNetworksGeodesic) {
  std::mt19937 random(7);
  for (const gallery::Surface& s : gallery::oriented())
    for (unsigned i = 0; i < 60; ++i) {
      TypeParam t(gallery::input(s));
      bool has_isolated = false;
      for (const auto v : vertices(t.mesh()))
        has_isolated |=
            halfedge(v, t.mesh()) == boost::graph_traits<typename TypeParam::Mesh>::null_halfedge();
      if (has_isolated) break;
      Curve_network<TypeParam> network(t);
      for (unsigned k = 0; k < 4; ++k) {
        const auto walk = random_walk(t, 1 + random() % 8, random);
        const bool is_closed = source(walk.front(), t.mesh()) == target(walk.back(), t.mesh());
        add_if_it_does_not_cross(network, walk, is_closed && random() % 4 != 0);
      }
      ASSERT_FALSE(has_crossing(t, network)) << s.name << ", network " << i;
      const double before = network.length();
      const Shortening_result r = shorten_curves(network);
      ASSERT_EQ(r.status, Status::done) << s.name << ", network " << i;
      EXPECT_LE(network.length(), before * (1 + 1e-12));
      EXPECT_FALSE(has_crossing(t, network)) << s.name << ", network " << i;
      if (TypeParam::Metric::is_exact) {
        EXPECT_EQ(r.refused_flips, 0U);
        EXPECT_TRUE(is_geodesic(network).is_geodesic()) << s.name;
      }
    }
}

} // namespace
