// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "planar_bezier.h"
#include "soups.h"

#include <CGAL/Intrinsic_geodesics/queries/add_geodesics.h>
#include <CGAL/Intrinsic_geodesics/shortening/certify_geodesic.h>
#include <CGAL/Intrinsic_geodesics/shortening/is_geodesic.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Gluing_map;
using Exact = IT::Exact_euclidean_traits;

template <class T>
class AddGeodesics : public ::testing::Test {};
using Triangulations = ::testing::Types<
    IT::Intrinsic_triangulation<Gluing_map, Exact, IT::Integer_coordinates>,
    IT::Intrinsic_triangulation<Gluing_map, Exact, IT::Signposts>,
    IT::Intrinsic_triangulation<Gluing_map, IT::Euclidean_traits<double>, IT::Integer_coordinates>>;
TYPED_TEST_SUITE(AddGeodesics, Triangulations);

// A random curve through points of a square, and how long it is: all geodesics there are unique,
// loops that do not stay contract.
template <class T, class Random>
double random_curve(const T& t, const meshes::Mesh& m, Random& random,
                    IT::Curve_through_vertices<T>& curve) {
  curve = {{}, random() % 3 == 0, random() % 4 != 0};
  std::vector<std::uint32_t> n =
      meshes::permutation(m.points.size(), static_cast<unsigned>(random()));
  n.resize(curve.is_loop ? 3 + random() % 3 : 2 + random() % 4);
  for (const std::uint32_t i : n) curve.vertices.push_back(IT::vertex_of_row(t, i));
  const auto distance = [&](std::size_t i, std::size_t j) {
    return planar_bezier::distance(m.points[n[i]], m.points[n[j]]);
  };
  if (!curve.stays_at_vertices) return curve.is_loop ? 0 : distance(0, n.size() - 1);
  double length = curve.is_loop ? distance(n.size() - 1, 0) : 0;
  for (std::size_t i = 0; i + 1 < n.size(); ++i) length += distance(i, i + 1);
  return length;
}

// One to four curves, which cross each other and themselves.
TYPED_TEST(AddGeodesics, AreStraightOnEveryTriangulationOfASquare) {
  std::size_t crossings = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const meshes::Mesh m = planar_bezier::random_square(10 + seed, random);
    TypeParam t(m.input());
    std::vector<IT::Curve_through_vertices<TypeParam>> curves(1 + seed % 4);
    std::vector<double> lengths;
    for (auto& curve : curves) lengths.push_back(random_curve(t, m, random, curve));
    IT::Curve_network<TypeParam> network(t);
    const auto added = IT::add_geodesics(network, curves);
    ASSERT_EQ(added.status, IT::Status::done);
    ASSERT_EQ(network.number_of_curves(), curves.size());
    // vertices at crossings are rounded to 2^-52, and moved off edges by 2^-40 of a height: bends
    // add the square of that
    for (std::uint32_t c = 0; c < curves.size(); ++c)
      EXPECT_NEAR(network.length(c), lengths[c], 1e-12);
    EXPECT_TRUE(IT::is_geodesic(network).is_geodesic());
    if constexpr (std::is_same_v<typename TypeParam::Correspondence, IT::Integer_coordinates>) {
      EXPECT_TRUE(IT::certify_geodesic(network).is_geodesic());
    }
    crossings += added.crossings.size();
  }
  EXPECT_GT(crossings, 100U);
}

TYPED_TEST(AddGeodesics, TellsWhereVerticesAreNotConnected) {
  meshes::Mesh m = meshes::grid(2, 2);
  const auto n = static_cast<std::uint32_t>(m.points.size());
  for (std::uint32_t i = 0; i < n; ++i) m.points.push_back(m.points[i]);
  for (std::size_t f = 0, all = m.triangles.size(); f < all; ++f)
    m.triangles.push_back({m.triangles[f][0] + n, m.triangles[f][1] + n, m.triangles[f][2] + n});
  TypeParam t(m.input());
  const auto at = [&](std::uint32_t i) { return IT::vertex_of_row(t, i); };
  IT::Curve_network<TypeParam> network(t);
  const auto added = IT::add_geodesics<TypeParam>(
      network, {{{at(0), at(1)}, false, false}, {{at(1), at(n)}, false, false}});
  EXPECT_EQ(added.status, IT::Status::stalled);
  EXPECT_EQ(added.failed, 1U);
  EXPECT_EQ(network.number_of_curves(), 0U);
}

// Squares of sides 1 and h, twice, glued along their border: rounding sends lines around in needles
// of height 1e-300.
TEST(AddGeodesicsToNetwork, EndsWhereNeedlesSendLinesAround) {
  constexpr double h = 1e-300;
  meshes::Mesh m;
  for (const double y : {0.0, 1.0})
    for (const double z : {0.0, h, 2 * h})
      for (const double x : {0.0, 1.0, 2.0})
        if (x < 2 || z < 2 * h) m.points.push_back({x, y, z});
  m.triangles = {{1, 4, 3},    {1, 3, 0},    {2, 5, 4},    {2, 4, 1},   {4, 7, 6},    {4, 6, 3},
                 {9, 1, 0},    {9, 0, 8},    {10, 2, 1},   {10, 1, 9},  {10, 13, 5},  {10, 5, 2},
                 {5, 13, 12},  {5, 12, 4},   {12, 15, 7},  {12, 7, 4},  {7, 15, 14},  {7, 14, 6},
                 {6, 14, 11},  {6, 11, 3},   {3, 11, 8},   {3, 8, 0},   {14, 15, 12}, {14, 12, 11},
                 {11, 12, 9},  {11, 9, 8},   {12, 13, 10}, {12, 10, 9}};
  using Triangulation = IT::Intrinsic_triangulation<Gluing_map, Exact, IT::Integer_coordinates>;
  Triangulation t(IT::make_domain(soups::soup(m), IT::Domain_kind::closed).input);
  IT::flip_to_delaunay(t);
  IT::Curve_network<Triangulation> network(t);
  IT::Curve_through_vertices<Triangulation> loop{{}, true, false};
  for (const std::uint32_t i : {3U, 5U, 8U, 2U}) loop.vertices.push_back(IT::vertex_of_row(t, i));
  EXPECT_NE(IT::add_geodesics(network, std::vector{loop}).status, IT::Status::cancelled);
}

TEST(AddGeodesicsToNetwork, EndsDuringASearchIfTheVisitorSaysSo) {
  struct Visitor {
    int calls = 0;
    bool progress(const IT::Shortening_result&) {
      ++calls;
      return false;
    }
  } visitor;
  using Triangulation = IT::Intrinsic_triangulation<Gluing_map, Exact, IT::Integer_coordinates>;
  Triangulation t(meshes::rough_grid(160, 4).input());
  IT::Curve_network<Triangulation> network(t);
  const IT::Curve_through_vertices<Triangulation> across{
      {IT::vertex_of_row(t, 0), IT::vertex_of_row(t, 160 * 161 + 160)}, false, false};
  const auto added =
      IT::add_geodesics(network, std::vector{across}, IT::parameters::visitor(std::ref(visitor)));
  EXPECT_EQ(added.status, IT::Status::cancelled);
  EXPECT_EQ(visitor.calls, 1);
  EXPECT_EQ(network.number_of_curves(), 0U);
}

} // namespace
