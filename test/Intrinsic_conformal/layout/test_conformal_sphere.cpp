// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/layout/conformal_sphere.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/metric/Ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include "flat_surfaces.h"
#include "polyhedra.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Polyhedra with corners on a sphere are found again, but for a Möbius transformation, from lambda
// lengths that are scaled at random.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using polyhedra::distance;
using polyhedra::Point;
using polyhedra::Polyhedron;
using Triangulation =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Ideal_hyperbolic_traits<double>,
                                IT::No_correspondence>;

Triangulation triangulation_of(const Polyhedron& p, const std::vector<double>& factors) {
  const flat::Surface s(p.triangles, p.points);
  IT::Gluing_map map(s.gluing);
  std::vector<double> squares(map.number_of_edges());
  for (std::uint32_t e = 0; e < squares.size(); ++e) {
    const std::uint32_t i = map.source(IT::Gluing_map::Halfedge{2 * e}).index,
                        j = map.target(IT::Gluing_map::Halfedge{2 * e}).index;
    squares[e] = std::pow(distance(p.points[i], p.points[j]) * factors[i] * factors[j], 2);
  }
  IT::Intrinsic_input in(std::move(map), std::move(squares), IT::Mollification::none);
  in.may_renumber = false;
  return Triangulation(in);
}

void expect_found(const IT::Conformal_sphere& s) {
  EXPECT_EQ(s.metric.status, IT::Status::done);
  EXPECT_TRUE(s.is_convex);
  EXPECT_TRUE(s.layout.is_centred);
  EXPECT_TRUE(s.layout.is_injective());
  EXPECT_LE(distance(s.layout.positions[s.layout.pole], {0, 0, 1}), 1e-14);
}

TEST(ConformalSphere, makesRegularPolyhedraRegularWhateverThePole) {
  for (const Polyhedron& p :
       {polyhedra::tetrahedron(), polyhedra::octahedron(), polyhedra::icosahedron()})
    for (std::uint32_t pole = 0; pole < p.points.size(); ++pole) {
      SCOPED_TRACE(std::to_string(p.points.size()) + " vertices, pole " + std::to_string(pole));
      Triangulation t = triangulation_of(p, std::vector<double>(p.points.size(), 1));
      const IT::Conformal_sphere s = IT::conformal_sphere(t, pole);
      expect_found(s);
      EXPECT_EQ(s.layout.pole, pole);
      for (std::size_t i = 0; i < p.points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_NEAR(distance(s.layout.positions[i], s.layout.positions[j]),
                      distance(p.points[i], p.points[j]), 1e-9);
    }
}

// Scaled lambda lengths belong to the same polyhedron, though the triangulation that is ideal
// Delaunay at first is another one.
TEST(ConformalSphere, doesNotDependOnScaleFactors) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shift(-0.03, 0.03), logarithm(-1, 1);
    Polyhedron p = polyhedra::icosahedron();
    p.divide();
    if (seed % 2 == 0) p.divide();
    for (Point& x : p.points)
      for (double& c : x) c += shift(random);
    p.normalise();
    std::vector<double> factors(p.points.size());
    for (double& w : factors) w = std::exp(logarithm(random));
    Triangulation t = triangulation_of(p, factors);
    const IT::Conformal_sphere s = IT::conformal_sphere(t);
    expect_found(s);
    for (int n = 0; n < 200; ++n) {
      const std::array<std::size_t, 4> i = polyhedra::four_of(p.points.size(), random);
      const double expected = polyhedra::cross_ratio(p.points, i);
      EXPECT_NEAR(polyhedra::cross_ratio(s.layout.positions, i), expected, 1e-7 * expected);
    }
  }
}

TEST(ConformalSphere, leavesIsolatedVerticesOut) {
  Polyhedron p = polyhedra::octahedron();
  p.points.push_back({3, 3, 3});
  Triangulation t = triangulation_of(p, std::vector<double>(p.points.size(), 1));
  expect_found(IT::conformal_sphere(t));
}

TEST(ConformalSphere, refusesPolesThatDoNotExist) {
  Triangulation t = triangulation_of(polyhedra::octahedron(), std::vector<double>(6, 1));
  EXPECT_THROW(IT::conformal_sphere(t, 6), IT::Invalid_input);
}

} // namespace
