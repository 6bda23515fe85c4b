// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/layout/lay_out_on_sphere.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include "flat_surfaces.h"
#include "polyhedra.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

// Points on the sphere are found again, but for a Möbius transformation, from lengths in the plane.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using polyhedra::distance;
using polyhedra::Point;
using polyhedra::Polyhedron;

// Projected to the plane from a vertex, with lengths |p - q| / (|p - v| |q - v|).
flat::Surface seen_from(const Polyhedron& p, std::uint32_t v) {
  flat::Surface s(p.triangles, p.points);
  for (std::uint32_t h = 0; h < s.length.size(); ++h) {
    const std::uint32_t i = s.gluing.origin[h], j = s.gluing.origin[IT::Gluing::next(h)];
    if (i != v && j != v)
      s.length[h] /= distance(p.points[i], p.points[v]) * distance(p.points[j], p.points[v]);
  }
  return s;
}

void expect_on_sphere(const IT::Sphere_layout& layout, double error) {
  EXPECT_TRUE(layout.is_centred);
  EXPECT_LE(layout.distance_of_mean, error);
  EXPECT_TRUE(layout.is_injective());
  EXPECT_LE(layout.largest_side_error, 1e-10);
  for (const Point& p : layout.positions) EXPECT_NEAR(distance(p, {0, 0, 0}), 1, 1e-14);
  EXPECT_LE(distance(layout.positions[layout.pole], {0, 0, 1}), 1e-14);
}

TEST(LayOutOnSphere, makesRegularPolyhedraRegular) {
  for (const Polyhedron& p :
       {polyhedra::tetrahedron(), polyhedra::octahedron(), polyhedra::icosahedron()})
    for (std::uint32_t pole = 0; pole < p.points.size(); ++pole) {
      SCOPED_TRACE(std::to_string(p.points.size()) + " vertices, pole " + std::to_string(pole));
      const IT::Sphere_layout layout = IT::lay_out_on_sphere(seen_from(p, pole), pole);
      expect_on_sphere(layout, 1e-14);
      for (std::size_t i = 0; i < p.points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_NEAR(distance(layout.positions[i], layout.positions[j]),
                      distance(p.points[i], p.points[j]), 1e-12);
    }
}

TEST(LayOutOnSphere, keepsCrossRatiosOfPoints) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shift(-0.1, 0.1), weight(0, 1);
    Polyhedron p = polyhedra::icosahedron();
    p.divide();
    p.divide();
    for (Point& x : p.points)
      for (double& c : x) c += 0.3 * shift(random);
    p.normalise();
    for (Point& x : p.points) { // moved to one side
      const double b = 0.8, n = 1 + b * x[0];
      x = {(x[0] + b) / n, std::sqrt(1 - b * b) * x[1] / n, std::sqrt(1 - b * b) * x[2] / n};
    }
    const auto pole = static_cast<std::uint32_t>(random() % p.points.size());
    std::vector<double> weights(p.points.size());
    for (double& w : weights) w = weight(random);
    const IT::Sphere_layout layout = IT::lay_out_on_sphere(seen_from(p, pole), pole, weights);
    expect_on_sphere(layout, 1e-13);
    for (int n = 0; n < 200; ++n) {
      const std::array<std::size_t, 4> i = polyhedra::four_of(p.points.size(), random);
      const double expected = polyhedra::cross_ratio(p.points, i);
      EXPECT_NEAR(polyhedra::cross_ratio(layout.positions, i), expected, 1e-9 * expected);
    }
  }
}

TEST(LayOutOnSphere, saysThatHalfOfTheWeightAtAPointCannotBeCentred) {
  const Polyhedron p = polyhedra::octahedron();
  const std::vector<double> weights{1, 1, 1, 1, 10, 1};
  const IT::Sphere_layout layout = IT::lay_out_on_sphere(seen_from(p, 4), 4, weights);
  EXPECT_FALSE(layout.is_centred);
  EXPECT_GT(layout.distance_of_mean, 0.1);
}

TEST(LayOutOnSphere, refusesWhatIsNoSphere) {
  const flat::Surface torus = flat::Surface::torus(1, flat::Complex(0, 1), 3);
  EXPECT_THROW(IT::lay_out_on_sphere(torus, 0), IT::Invalid_input);
  const flat::Surface open({{0, 1, 2}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_THROW(IT::lay_out_on_sphere(open, 0), IT::Invalid_input);
  const flat::Surface s = seen_from(polyhedra::octahedron(), 0);
  EXPECT_THROW(IT::lay_out_on_sphere(s, 6), IT::Invalid_input);
  EXPECT_THROW(IT::lay_out_on_sphere(s, 0, std::vector<double>{1}), IT::Invalid_input);
  EXPECT_THROW(IT::lay_out_on_sphere(s, 0, std::vector<double>{1, 1, 1, 1, 1, -1}),
               IT::Invalid_input);
  // a vertex of all triangles
  const flat::Surface pillow = flat::Surface::doubled_polygon({0, 1, {0, 1}});
  EXPECT_THROW(IT::lay_out_on_sphere(pillow, 0), IT::Invalid_input);
}

} // namespace
