// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/angles/flat_angles.h>
#include <CGAL/Intrinsic_conformal/angles/ideal_start.h>
#include <CGAL/Intrinsic_conformal/metric/conformal_metric.h>
#include <CGAL/Intrinsic_conformal/metric/hyperbolic_metric.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include "hyperbolic_surfaces.h"
#include "ideal_triangulations.h"
#include "operator_test_meshes.h"
#include "refusals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Surfaces with symmetries, whose hyperbolic metrics are known; surfaces that are scaled at random
// come back; and what holds for all hyperbolic triangles.

namespace {

using namespace operator_test;
using refusals::expect_refusal;
using Ideal = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_ideal_hyperbolic_traits,
                                          IT::Integer_coordinates>;
constexpr double pi = std::numbers::pi;

Ideal ideal(IT::Intrinsic_input in) {
  return Ideal(
      IT::ideal_start(Exact(IT::make_domain(std::move(in), IT::Domain_kind::closed).input)));
}

// the angle opposite the first side of a hyperbolic triangle, by the law of cosines
double angle(double a, double b, double c) {
  return std::acos((std::cosh(b) * std::cosh(c) - std::cosh(a)) / (std::sinh(b) * std::sinh(c)));
}

// the angles at the corners of the sides of a hyperbolic surface
std::vector<double> corner_angles(const IT::Surface_to_cut& s) {
  std::vector<double> result;
  for (std::uint32_t h = 0; h < s.length.size(); ++h) {
    const std::uint32_t n = IT::Gluing::next(h), p = IT::Gluing::next(n);
    result.push_back(angle(s.length[n], s.length[h], s.length[p]));
  }
  return result;
}

void expect_solved(const IT::Conformal_metric& m, unsigned iterations) {
  EXPECT_EQ(m.status, IT::Status::done);
  EXPECT_LE(m.iterations, iterations);
  ASSERT_TRUE(m.proven_residual);
  EXPECT_LE(*m.proven_residual, 1e-9);
  EXPECT_GE(*m.proven_residual, m.residual - 1e-13);
  for (std::size_t v = 0; v < m.u.size(); ++v) // half a unit in the last place of u, one of factors
    EXPECT_NEAR(2 * std::log(m.scale_factors[v]), m.u[v], 0x1p-51 * (1 + std::abs(m.u[v])));
}

// The surface, some flips away from itself, gets sides of the given lengths.
void expect_lengths(const gallery::Surface& s, const std::vector<double>& lengths) {
  for (const double unit : {1., 1000., 1e-3})
    for (const std::size_t flips : {0U, 20U}) {
      IT::Intrinsic_input in = gallery::input(s);
      for (double& squared : in.squared_lengths) squared *= unit * unit;
      Ideal t = ideal(std::move(in));
      ideal::flip_at_random(t, flips, 5);
      const IT::Conformal_metric m = IT::hyperbolic_metric(t, IT::flat_angles(t));
      expect_solved(m, 8);
      for (const double length : IT::hyperbolic_surface(t).length) {
        double least = 1;
        for (const double expected : lengths) least = std::min(least, std::abs(length - expected));
        EXPECT_LT(least, 1e-9) << s << ' ' << unit << ' ' << flips << ' ' << length;
      }
    }
}

TEST(Hyperbolic_metric, RegularSurfacesHaveKnownLengths) {
  const double eighth = pi / 8;
  for (const double spoke : {0.7, 2., 30.}) // triangles of any shape
    expect_lengths(hyperbolic::octagon(spoke), {hyperbolic::side(2 * eighth, eighth, eighth),
                                                hyperbolic::side(eighth, eighth, 2 * eighth)});
  expect_lengths(hyperbolic::bolza(), {hyperbolic::side(2 * eighth, 2 * eighth, 2 * eighth)});
  const double seventh = 2 * pi / 7;
  expect_lengths(hyperbolic::klein_quartic(), {hyperbolic::side(seventh, seventh, seventh)});
}

TEST(Hyperbolic_metric, ConesMakeOtherSurfacesHyperbolic) {
  Ideal t = ideal(tetrahedron().input());
  const IT::Prescribed_angles right(std::vector<double>(4, pi / 2));
  expect_solved(IT::hyperbolic_metric(t, right), 8);
  for (const double length : IT::hyperbolic_surface(t).length)
    EXPECT_NEAR(length, hyperbolic::side(pi / 6, pi / 6, pi / 6), 1e-9);
}

// The search starts from areas: Heron's product is of degree four, and underflows for the smaller
// component.
TEST(Hyperbolic_metric, SizesOfComponentsMayDifferByManyPowersOfTen) {
  for (const double unit : {1e-140, 1e-90, 1., 1e90, 1e140}) {
    Shape other = tetrahedron();
    for (std::array<double, 3>& p : other.points)
      for (double& x : p) x *= unit;
    Ideal t = ideal(beside(tetrahedron(), other, 0).input());
    expect_solved(IT::hyperbolic_metric(t, IT::Prescribed_angles(std::vector<double>(8, pi / 2))),
                  8);
    for (const double length : IT::hyperbolic_surface(t).length)
      EXPECT_NEAR(length, hyperbolic::side(pi / 6, pi / 6, pi / 6), 1e-9) << unit;
  }
}

// A pentagon with five right angles and its centre, as a double.
TEST(Hyperbolic_metric, BordersGetPrescribedAngles) {
  Shape fan;
  fan.points.push_back({0, 0, 0.9});
  for (std::uint32_t k = 0; k < 5; ++k) {
    fan.points.push_back({std::cos(2 * pi * k / 5), std::sin(2 * pi * k / 5), 0});
    fan.triangles.push_back({0, k + 1, (k + 1) % 5 + 1});
  }
  Ideal t = ideal(fan.input());
  IT::Prescribed_angles angles(6);
  for (std::size_t v = 1; v < 6; ++v) angles.set(v, IT::Multiple_of_pi{1, 2});
  expect_solved(IT::hyperbolic_metric(t, angles), 8);
  const double outer = hyperbolic::side(2 * pi / 5, pi / 4, pi / 4),
               spoke = hyperbolic::side(pi / 4, pi / 4, 2 * pi / 5);
  for (const double length : IT::hyperbolic_surface(t).length)
    EXPECT_LT(std::min(std::abs(length - outer), std::abs(length - spoke)), 1e-9);
}

// Random lengths; the angles that they have bring them back after random scaling and flips.
TEST(Hyperbolic_metric, ScaledSurfacesComeBack) {
  for (const double size : {0.01, 1., 5.})
    for (const unsigned seed : {1U, 2U, 3U}) {
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> d(0.5, 1);
      IT::Intrinsic_input in = gallery::input(hyperbolic::klein_quartic());
      for (double& squared : in.squared_lengths) squared = size * size * d(random);
      Ideal t(std::move(in));
      IT::flip_to_delaunay(t);
      const IT::Surface_to_cut s = IT::hyperbolic_surface(t);
      std::vector<double> sums(t.number_of_vertices(), 0), u;
      const std::vector<double> angles = corner_angles(s);
      for (std::size_t h = 0; h < angles.size(); ++h) sums[s.gluing.origin[h]] += angles[h];
      // start from elsewhere: the solution has the factors 1 again
      t.scale_vertices(ideal::random_factors(sums.size(), 3, seed));
      IT::flip_to_delaunay(t);
      const IT::Conformal_metric m = IT::hyperbolic_metric(t, IT::Prescribed_angles(sums));
      expect_solved(m, 12);
      for (const double x : m.u) EXPECT_NEAR(x, 0, 1e-7) << size << ' ' << seed;
    }
}

// In a Delaunay triangulation circumcircles are empty: the angles at an edge minus those opposite
// it sum to a positive number; so do cosines of Euclidean triangles with sides 2 sinh(l/2).
TEST(Hyperbolic_metric, DelaunayTrianglesAreThoseOfIdealOnes) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> logarithm(-3, 2);
  int ideal_edges = 0, tested = 0;
  for (int n = 0; n < 100000; ++n) {
    std::array<double, 5> lambda; // an edge, and the other sides of two triangles
    for (double& x : lambda) x = std::exp(logarithm(random));
    const auto excess = [&](std::size_t i, std::size_t j) { // twice the cosine, and d
      const double a = lambda[0], b = lambda[i], c = lambda[j];
      const double x = 2 * std::asinh(a / 2), y = 2 * std::asinh(b / 2), z = 2 * std::asinh(c / 2);
      return std::pair((b * b + c * c - a * a) / (b * c),
                       angle(y, z, x) + angle(z, x, y) - angle(x, y, z));
    };
    const auto is_triangle = [&](std::size_t i, std::size_t j) {
      const double a = lambda[0], b = lambda[i], c = lambda[j];
      return std::max({a, b, c}) < 0.999 * (a + b + c) / 2;
    };
    if (!is_triangle(1, 2) || !is_triangle(3, 4)) continue;
    const auto [p, d] = excess(1, 2);
    const auto [q, e] = excess(3, 4);
    if (std::abs(p + q) < 1e-6) continue; // rounding
    EXPECT_EQ(p + q > 0, d + e > 0) << p + q << ' ' << d + e;
    ideal_edges += p + q > 0 ? 1 : 0;
    ++tested;
  }
  EXPECT_GT(std::min(ideal_edges, tested - ideal_edges), 100);
}

// two tori of n x n cells in space, each without a triangle, glued at the holes
Shape double_torus(std::uint32_t n, double height) {
  Shape s = rough_torus(n, height, 1), other = s;
  const auto size = static_cast<std::uint32_t>(s.points.size());
  const std::array<std::uint32_t, 3> hole = s.triangles.back();
  s.triangles.pop_back();
  other.triangles.pop_back();
  const auto at_hole = [&](std::uint32_t v) {
    return std::find(hole.begin(), hole.end(), v) != hole.end();
  };
  for (const auto& p : other.points) s.points.push_back({20 - p[0], p[1], p[2]});
  for (const auto& t : other.triangles) {
    std::array<std::uint32_t, 3> mirrored{t[0], t[2], t[1]};
    for (std::uint32_t& v : mirrored)
      if (!at_hole(v)) v += size;
    s.triangles.push_back(mirrored);
  }
  return s;
}

TEST(Hyperbolic_metric, AreasAreThoseOfGaussAndBonnet) {
  Exact euclidean(double_torus(8, 0.3).input());
  IT::flip_to_delaunay(euclidean);
  Ideal t(IT::ideal_start(euclidean));
  const IT::Conformal_metric m =
      IT::hyperbolic_metric(t, IT::Prescribed_angles(t.number_of_vertices()));
  expect_solved(m, 10);
  EXPECT_GT(m.flips, 0U);
  EXPECT_TRUE(IT::is_delaunay(t));
  const IT::Surface_to_cut s = IT::hyperbolic_surface(t);
  const std::vector<double> angles = corner_angles(s);
  double area = 0;
  for (std::size_t h = 0; h < angles.size(); h += 3) {
    area += pi - angles[h] - angles[h + 1] - angles[h + 2];
    const auto [least, most] = std::minmax({s.length[h], s.length[h + 1], s.length[h + 2]});
    EXPECT_LT(most, s.length[h] + s.length[h + 1] + s.length[h + 2] - most);
    EXPECT_GT(least, 0);
  }
  EXPECT_NEAR(area, 4 * pi, 1e-8);
  // another triangulation of the same surface, from the triangles that it has now
  Ideal flipped(IT::ideal_start(euclidean));
  ideal::flip_at_random(flipped, 300, 1);
  const IT::Conformal_metric again =
      IT::hyperbolic_metric(flipped, IT::Prescribed_angles(t.number_of_vertices()));
  expect_solved(again, 10);
  for (std::size_t v = 0; v < m.u.size(); ++v) EXPECT_NEAR(m.u[v], again.u[v], 1e-8);
}

TEST(Hyperbolic_metric, RefusesAnglesThatLeaveNoArea) {
  for (IT::Intrinsic_input in : {cube().input(), rough_torus(8, 0.3, 1).input()}) {
    Ideal t = ideal(std::move(in));
    expect_refusal([&] { IT::hyperbolic_metric(t, IT::flat_angles(t)); }, "Gauss and Bonnet");
  }
  Ideal t = ideal(tetrahedron().input());
  const auto solve = [&t](double angle) {
    return [&t, angle] {
      IT::hyperbolic_metric(t, IT::Prescribed_angles(std::vector<double>(4, angle)));
    };
  };
  expect_refusal(solve(pi), "its area would be");
  expect_refusal(solve(-1), "not positive");
  expect_refusal([&] { IT::hyperbolic_metric(t, IT::Prescribed_angles(3)); }, "3 angles");
  solve(pi / 100)();
}

} // namespace
