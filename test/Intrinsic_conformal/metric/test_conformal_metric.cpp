// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/angles/flat_angles.h>
#include <CGAL/Intrinsic_conformal/angles/ideal_start.h>
#include <CGAL/Intrinsic_conformal/metric/conformal_metric.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include "meshes.h"
#include "operator_test_meshes.h"
#include "refusals.h"

#include <CGAL/Gmpq.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Closed forms: surfaces that are scaled at random come back; and bounds that are proven.

namespace {

using namespace operator_test;
using refusals::expect_refusal;
using Ideal = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_ideal_hyperbolic_traits,
                                          IT::Integer_coordinates>;
using Double_ideal =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Ideal_hyperbolic_traits<double>>;
constexpr double pi = std::numbers::pi;

IT::Intrinsic_input closed(IT::Intrinsic_input in) {
  return IT::make_domain(std::move(in), IT::Domain_kind::closed).input;
}

template <class Triangulation = Ideal>
Triangulation ideal_delaunay(IT::Intrinsic_input in) {
  Exact t(closed(std::move(in)));
  IT::flip_to_delaunay(t);
  return Triangulation(IT::ideal_start(t));
}

// The same surface with lambdas multiplied by random factors of its vertices.
struct Scaled {
  IT::Intrinsic_input input;
  std::vector<double> u; // that undoes it
};
Scaled scaled_at_random(const Exact& t, double range, unsigned seed) {
  Scaled s{IT::ideal_start(t), {}};
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> d(-range, range);
  for (std::uint32_t v = 0; v < t.number_of_vertices(); ++v) s.u.push_back(d(random));
  for (std::uint32_t e = 0; e < s.input.squared_lengths.size(); ++e)
    for (const std::uint32_t h : {2 * e, 2 * e + 1})
      s.input.squared_lengths[e] *=
          std::exp(-s.u[s.input.names.row(s.input.mesh.source(IT::Gluing_map::Halfedge{h}).index)]);
  return s;
}

// the angles around the vertices of a surface, on one sheet
std::vector<double> angles_of(const Exact& t) {
  std::vector<double> sum(t.number_of_vertices(), 0);
  for (const auto f : faces(t.mesh())) {
    auto h = halfedge(f, t.mesh());
    for (int k = 0; k < 3; ++k, h = next(h, t.mesh())) {
      const double a = t.length(edge(h, t.mesh())),
                   b = t.length(edge(next(next(h, t.mesh()), t.mesh()), t.mesh())),
                   c = t.length(edge(next(h, t.mesh()), t.mesh()));
      sum[t.input_vertex(source(h, t.mesh()))] +=
          std::acos((a * a + b * b - c * c) / (2 * a * b)) / t.input().names().sheets;
    }
  }
  return sum;
}

// Scales the surface at random; its angles bring it back. The range is such that it flips.
void expect_back(IT::Intrinsic_input in, double range, bool flips) {
  Exact t(closed(std::move(in)));
  IT::flip_to_delaunay(t);
  for (const unsigned seed : {1U, 2U, 3U}) {
    Scaled s = scaled_at_random(t, range, seed);
    Ideal ideal(std::move(s.input));
    const IT::Conformal_metric m = IT::conformal_metric(ideal, IT::Prescribed_angles(angles_of(t)));
    EXPECT_EQ(m.status, IT::Status::done) << seed;
    EXPECT_EQ(m.flips > 0, flips) << seed;
    ASSERT_TRUE(m.proven_residual);
    EXPECT_LE(*m.proven_residual, 1.1e-10) << seed;
    EXPECT_GE(*m.proven_residual, m.residual - 1e-13) << seed;
    EXPECT_LE(m.iterations, 12U) << seed;
    double mean = 0, sum = 0;
    for (std::size_t v = 0; v < m.u.size(); ++v) {
      mean += s.u[v] / static_cast<double>(m.u.size());
      sum += m.u[v];
      // u has an error of half a unit in its last place, each factor of one
      EXPECT_NEAR(2 * std::log(m.scale_factors[v]), m.u[v], 0x1p-51 * (1 + std::abs(m.u[v])));
    }
    EXPECT_NEAR(sum, 0, 1e-12 * static_cast<double>(m.u.size()));
    // residuals of at most 1e-10 radians change u by no more on these meshes
    for (std::size_t v = 0; v < m.u.size(); ++v)
      EXPECT_NEAR(m.u[v], s.u[v] - mean, 2e-9) << seed << ' ' << v;
  }
}

TEST(Conformal_metric, ScaledFlatToriComeBack) {
  expect_back(torus(1, 0.3), 3, false);
  expect_back(torus(6, 0.3), 0.1, false);
  expect_back(torus(6, 0.3), 3, true);
}

TEST(Conformal_metric, ScaledPolyhedraComeBack) {
  expect_back(tetrahedron().input(), 0.5, false);
  expect_back(cube().input(), 2, true);
  expect_back(rough_torus(8, 0.3, 1).input(), 2, true);
}

TEST(Conformal_metric, ScaledDoublesComeBack) {
  expect_back(rough_grid(6, 0.2, 0.4, 1).input(), 2, true);
  expect_back(grid(4).input(), 2, true);
}

TEST(Conformal_metric, RegularPolyhedraStayAsTheyAre) {
  Ideal t = ideal_delaunay(tetrahedron().input());
  IT::Prescribed_angles angles(4);
  for (std::size_t v = 0; v < 4; ++v) angles.set(v, IT::Multiple_of_pi{1, 1});
  const IT::Conformal_metric m = IT::conformal_metric(t, angles);
  EXPECT_EQ(m.status, IT::Status::done);
  EXPECT_EQ(m.iterations, 0U);
  EXPECT_EQ(m.u, std::vector<double>(4, 0));
  EXPECT_LE(m.residual, 1e-15);
}

TEST(Conformal_metric, PlanarDisksWithFreeBorderStayAsTheyAre) {
  const Shape s = rough_grid(8, 0.3, 0, 5);
  Ideal t = ideal_delaunay(s.input());
  const IT::Conformal_metric m = IT::conformal_metric(t, IT::flat_angles(t));
  EXPECT_EQ(m.status, IT::Status::done);
  EXPECT_EQ(m.iterations, 0U);
}

TEST(Conformal_metric, BorderThatIsFreeKeepsItsScale) {
  const std::uint32_t n = 8;
  Ideal t = ideal_delaunay(rough_grid(n, 0.2, 0.5, 5).input());
  const IT::Conformal_metric m = IT::conformal_metric(t, IT::flat_angles(t));
  EXPECT_EQ(m.status, IT::Status::done);
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x) {
      const bool is_inner = x % n != 0 && y % n != 0;
      EXPECT_EQ(m.u[(n + 1) * y + x] != 0, is_inner) << x << ' ' << y;
    }
}

// A rectangle: right angles at the corners of a bumpy square, straight sides elsewhere.
TEST(Conformal_metric, BorderGetsPrescribedAngles) {
  const std::uint32_t n = 8;
  Ideal t = ideal_delaunay(rough_grid(n, 0.2, 0.5, 5).input());
  IT::Prescribed_angles angles(t.number_of_vertices());
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x)
      if (const int sides = (x % n == 0 ? 1 : 0) + (y % n == 0 ? 1 : 0); sides > 0)
        angles.set((n + 1) * y + x, IT::Multiple_of_pi{1, sides});
  const IT::Conformal_metric m = IT::conformal_metric(t, angles);
  EXPECT_EQ(m.status, IT::Status::done);
  angles.set(1, pi); // the same in radians, up to rounding
  const IT::Conformal_metric again = IT::conformal_metric(t, angles);
  EXPECT_EQ(again.status, IT::Status::done);
  for (std::size_t v = 0; v < m.u.size(); ++v) EXPECT_NEAR(m.u[v], again.u[v], 1e-9);
}

// The class is that of the triangles: with those of the input, other factors give the same angles.
TEST(Conformal_metric, StartsFromTheTrianglesOfTheInput) {
  const Shape s = rough_torus(8, 0.6, 1);
  const Exact t(s.input()); // without flips
  Ideal from_input(IT::ideal_start(t)), from_delaunay = ideal_delaunay(s.input());
  const IT::Conformal_metric a = IT::conformal_metric(from_input, IT::flat_angles(from_input)),
                             b = IT::conformal_metric(from_delaunay, IT::flat_angles(from_input));
  EXPECT_EQ(a.status, IT::Status::done);
  EXPECT_EQ(b.status, IT::Status::done);
  double difference = 0;
  for (std::size_t v = 0; v < a.u.size(); ++v)
    difference = std::max(difference, std::abs(a.u[v] - b.u[v]));
  EXPECT_GT(difference, 1e-3);
  EXPECT_LT(difference, 1);
}

// Full turns, but tiny angles at some vertices of a torus, and nearly two turns at as many.
IT::Prescribed_angles needle_angles(std::size_t vertices, unsigned seed) {
  constexpr std::int64_t parts = 1 << 22;
  std::mt19937 random(seed);
  std::vector<std::size_t> order(vertices);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), random);
  IT::Prescribed_angles angles(vertices);
  for (std::size_t n = 0; n < 8; n += 2) {
    angles.set(order[n], IT::Multiple_of_pi{1, parts});
    angles.set(order[n + 1], IT::Multiple_of_pi{4 * parts - 1, parts});
  }
  return angles;
}

// Angles minus prescribed ones, the largest, from rational lambda lengths, by flips of their own.
// \param rests of the factors
double true_residual(const IT::Intrinsic_input& start, const std::vector<double>& factors,
                     const std::vector<double>& rests, const IT::Prescribed_angles& angles,
                     double& least_surplus) {
  IT::Intrinsic_triangulation<IT::Gluing_map, IT::Ideal_hyperbolic_traits<CGAL::Gmpq>> t(start);
  t.scale_vertices(factors, rests);
  IT::flip_to_delaunay(t);
  std::vector<long double> sum(factors.size(), 0);
  for (const auto f : faces(t.mesh())) {
    auto h = halfedge(f, t.mesh());
    for (int k = 0; k < 3; ++k, h = next(h, t.mesh())) {
      const auto side = [&](auto g) { return t.metric().lambda(t.index(edge(g, t.mesh()))); };
      const CGAL::Gmpq a = side(h), b = side(prev(h, t.mesh())), c = side(next(h, t.mesh())),
                       squared_tangent = (c - a + b) * (c + a - b) / ((a + b + c) * (a + b - c));
      least_surplus = std::min(least_surplus, CGAL::to_double((a + b - c) / (a + b + c)));
      sum[t.input_vertex(source(h, t.mesh()))] +=
          2 * std::atan(std::sqrt(static_cast<long double>(CGAL::to_double(squared_tangent))));
    }
  }
  long double largest = 0;
  for (std::size_t v = 0; v < sum.size(); ++v) {
    const IT::Multiple_of_pi m = angles.multiple(v);
    const long double prescribed = static_cast<long double>(m.numerator) *
                                   std::numbers::pi_v<long double> /
                                   static_cast<long double>(m.denominator);
    largest = std::max(largest, std::abs(sum[v] - prescribed));
  }
  return static_cast<double>(largest);
}

// Needles lose digits of their angles, but not where surpluses of their sides are precise.
TEST(Conformal_metric, ProvenResidualsAreNearlyTheTrueOnesBesideNeedles) {
  double least_surplus = 1;
  for (const unsigned seed : {1U, 2U, 3U}) {
    Exact t(rough_torus(8, 0.3, 1).input());
    IT::flip_to_delaunay(t);
    const IT::Intrinsic_input start = IT::ideal_start(t);
    Ideal ideal(start);
    const IT::Prescribed_angles angles = needle_angles(ideal.number_of_vertices(), seed);
    const IT::Conformal_metric m = IT::conformal_metric(ideal, angles);
    EXPECT_EQ(m.status, IT::Status::done) << seed;
    ASSERT_TRUE(m.proven_residual);
    const double residual =
        true_residual(start, m.scale_factors, m.scale_rests, angles, least_surplus);
    EXPECT_LE(residual, *m.proven_residual) << seed;
    EXPECT_LE(true_residual(start, m.scale_factors, {}, angles, least_surplus), *m.proven_residual)
        << seed;
    // surpluses have errors of at most 2^-38 of their own if they are not precise, each near two of
    // about six corners of a vertex; means of random errors are far smaller
    EXPECT_LE(*m.proven_residual - residual, 1e-12) << seed;
  }
  EXPECT_LT(least_surplus, 1e-6);
}

// Factors over many powers of ten, which need no more digits than doubles have.
TEST(Conformal_metric, ProvesResidualsOfWildMetrics) {
  Exact t(rough_torus(8, 0.3, 1).input());
  IT::flip_to_delaunay(t);
  Scaled s = scaled_at_random(t, 20, 7);
  Ideal ideal(std::move(s.input));
  const IT::Conformal_metric m = IT::conformal_metric(ideal, IT::flat_angles(ideal));
  EXPECT_EQ(m.status, IT::Status::done);
  ASSERT_TRUE(m.proven_residual);
  EXPECT_LE(*m.proven_residual, 1e-9);
}

// At the start all triangles are needles whose angles are lost in rounding, also with doubles.
TEST(Conformal_metric, BalancesFactorsOverTwentyPowersOfTen) {
  Exact t(rough_torus(8, 0.3, 1).input());
  IT::flip_to_delaunay(t);
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Scaled s = scaled_at_random(t, 46, seed); // factors exp(u/2)
    const IT::Prescribed_angles angles(angles_of(t));
    Ideal ideal(s.input);
    Double_ideal rounded(s.input);
    const IT::Conformal_metric exact = IT::conformal_metric(ideal, angles),
                               inexact = IT::conformal_metric(rounded, angles);
    EXPECT_EQ(exact.status, IT::Status::done) << seed;
    EXPECT_EQ(inexact.status, IT::Status::done) << seed;
    EXPECT_LE(exact.proven_residual.value_or(1), 1e-9) << seed;
    double mean = 0;
    for (const double u : s.u) mean += u / static_cast<double>(s.u.size());
    for (std::size_t v = 0; v < s.u.size(); ++v) {
      EXPECT_NEAR(exact.u[v], s.u[v] - mean, 1e-8) << seed << ' ' << v;
      EXPECT_NEAR(inexact.u[v], s.u[v] - mean, 1e-8) << seed << ' ' << v;
    }
  }
}

// A disk with the border angles of a regular polygon: their differences from full and straight
// angles sum to 2 pi exactly, and symmetric meshes get equal sides.
// Multiples of pi/2 from one to seven, whose curvature is that of a sphere.
IT::Prescribed_angles random_angles_of_sphere(std::size_t vertices, std::mt19937& random) {
  std::uniform_int_distribution<int> quarters(1, 7);
  std::uniform_int_distribution<std::size_t> vertex(0, vertices - 1);
  std::vector<int> angle(vertices);
  int curvature = 0;
  for (int& a : angle) curvature += 4 - (a = quarters(random));
  while (curvature != 8) {
    int& a = angle[vertex(random)];
    const int change = curvature < 8 ? -1 : 1;
    if (a + change < 1 || a + change > 7) continue;
    a += change;
    curvature -= change;
  }
  IT::Prescribed_angles result(vertices);
  for (std::size_t v = 0; v < vertices; ++v) result.set(v, IT::Multiple_of_pi{angle[v], 2});
  return result;
}

// Where steps may raise the norm of the excess as long as the energy falls, these take 261 steps.
TEST(Conformal_metric, StepsThatRaiseTheNormOfTheExcessAreHalved) {
  meshes::Mesh m = meshes::sphere(3);
  for (auto& p : m.points) p[0] *= 400;
  unsigned steps = 0;
  for (unsigned seed = 1; seed <= 7; ++seed) {
    std::mt19937 random(2 * seed);
    Double_ideal t(m.input());
    const auto result = IT::conformal_metric(t, random_angles_of_sphere(m.points.size(), random));
    EXPECT_EQ(result.status, IT::Status::done);
    EXPECT_LE(result.residual, 1e-10);
    steps += result.iterations;
  }
  EXPECT_LE(steps, 210U);
}

TEST(Conformal_metric, DisksBecomeRegularPolygons) {
  for (const std::uint32_t n : {5U, 6U, 9U}) { // more than four: the fan stays Delaunay
    Shape fan;                                 // about a raised centre
    fan.points.push_back({0, 0, 0.9});
    for (std::uint32_t k = 0; k < n; ++k) {
      fan.points.push_back({std::cos(2 * pi * k / n), std::sin(2 * pi * k / n), 0});
      fan.triangles.push_back({0, k + 1, (k + 1) % n + 1});
    }
    Ideal t = ideal_delaunay(fan.input());
    IT::Prescribed_angles angles(n + 1);
    for (std::size_t v = 1; v <= n; ++v) angles.set(v, IT::Multiple_of_pi{n - 2, n});
    const IT::Conformal_metric m = IT::conformal_metric(t, angles);
    EXPECT_EQ(m.status, IT::Status::done);
    EXPECT_LE(m.proven_residual.value_or(1), 1.1e-10);
    // sides 2 sin(pi / n) times w^2 and spokes sqrt(1 + 0.81) times w w_0 have these proportions
    const double side = 2 * std::sin(pi / n), spoke = std::sqrt(1.81);
    for (std::size_t v = 1; v <= n; ++v)
      EXPECT_NEAR(side * m.scale_factors[v] / (spoke * m.scale_factors[0]), side, 1e-9) << n;
    angles.set(1, IT::Multiple_of_pi{2 * n - 3, 2 * n});
    EXPECT_THROW(IT::conformal_metric(t, angles), IT::Invalid_input);
  }
}

TEST(Conformal_metric, ConesArePlacedWithTheCurvatureOfTheSurface) {
  for (const std::size_t cones : {3U, 4U, 7U, 8U, 12U}) {
    const meshes::Mesh potato = meshes::potato(3, 1);
    Ideal t = ideal_delaunay(Shape{potato.points, potato.triangles}.input());
    const IT::Prescribed_angles angles = IT::place_cones(t, cones);
    std::size_t found = 0;
    for (std::size_t v = 0; v < angles.size(); ++v)
      if (angles.multiple(v) != IT::Multiple_of_pi()) ++found;
    EXPECT_EQ(found, cones);
    EXPECT_EQ(IT::conformal_metric(t, angles).status, IT::Status::done) << cones;
  }
  Ideal t = ideal_delaunay(rough_torus(8, 0.3, 1).input());
  for (const std::size_t cones : {0U, 2U, 5U})
    EXPECT_EQ(IT::conformal_metric(t, IT::place_cones(t, cones)).status, IT::Status::done);
  Ideal disk = ideal_delaunay(rough_grid(8, 0.2, 0.5, 5).input());
  EXPECT_EQ(IT::conformal_metric(disk, IT::place_cones(disk, 2)).status, IT::Status::done);
}

TEST(Conformal_metric, ConesKeepTheScaleInARange) {
  const auto number_of_cones = [](Ideal t, double ratio) {
    const IT::Prescribed_angles angles = IT::place_cones_within(t, ratio);
    const IT::Conformal_metric m = IT::conformal_metric(t, angles);
    EXPECT_EQ(m.status, IT::Status::done) << ratio;
    const auto [least, most] = std::ranges::minmax(m.u);
    EXPECT_LE(std::exp(most - least), 1.5 * ratio); // the prediction is linear
    std::size_t cones = 0;
    for (std::size_t v = 0; v < angles.size(); ++v)
      if (!angles.is_free(v) && angles.multiple(v) != IT::Multiple_of_pi()) ++cones;
    return cones;
  };
  const meshes::Mesh potato = meshes::potato(3, 1);
  const Ideal sphere = ideal_delaunay(Shape{potato.points, potato.triangles}.input());
  const std::size_t few = number_of_cones(sphere, 100);
  EXPECT_GE(few, 3U);
  EXPECT_GE(number_of_cones(sphere, 8), few);
  EXPECT_EQ(number_of_cones(ideal_delaunay(torus(6, 0.3)), 1.5), 0U);
  EXPECT_EQ(number_of_cones(ideal_delaunay(rough_grid(8, 0.2, 0.5, 5).input()), 20), 0U);
}

TEST(Conformal_metric, RefusesAnglesThatNoSurfaceHas) {
  Ideal t = ideal_delaunay(cube().input());
  const auto solve = [&](const IT::Prescribed_angles& a) {
    return [&t, a] { IT::conformal_metric(t, a); };
  };
  expect_refusal(solve(IT::Prescribed_angles(8)), "Gauss and Bonnet: their sum is too large by 12");
  expect_refusal(solve(IT::Prescribed_angles(std::vector<double>(8, 1))), "too small by");
  expect_refusal(solve(IT::Prescribed_angles(7)), "7 angles for 8 vertices");
  std::vector<double> angles(8, 3 * pi / 2);
  EXPECT_EQ(IT::conformal_metric(t, IT::Prescribed_angles(angles)).status, IT::Status::done);
  angles[3] = 0;
  expect_refusal(solve(IT::Prescribed_angles(angles)), "vertex 3: its angle is not positive");
  expect_refusal([&] { IT::place_cones(t, 2); }, "place at least 3");
  expect_refusal([&] { IT::place_cones(t, 9); }, "only 8 vertices");
  expect_refusal([&] { IT::place_cones_within(t, 1); }, "above 1");
  Ideal bent = ideal_delaunay(rough_torus(4, 0.3, 1).input());
  expect_refusal([&] { IT::place_cones_within(bent, 1.0001); }, "allow at least");
  Ideal open(grid(3).input());
  expect_refusal([&] { IT::conformal_metric(open, IT::Prescribed_angles(16)); }, "border");
}

TEST(Conformal_metric, ReportsAndStops) {
  struct Once {
    bool progress(const IT::Conformal_progress& p) const { return p.iteration < 1; }
  };
  Double_ideal t = ideal_delaunay<Double_ideal>(rough_torus(8, 0.3, 1).input());
  IT::Conformal_metric m =
      IT::conformal_metric(t, IT::flat_angles(t), IT::parameters::visitor(Once()));
  EXPECT_EQ(m.status, IT::Status::cancelled);
  EXPECT_EQ(m.iterations, 1U);
  EXPECT_FALSE(m.proven_residual); // doubles prove nothing
  m = IT::conformal_metric(t, IT::flat_angles(t), IT::parameters::number_of_iterations(1));
  EXPECT_EQ(m.status, IT::Status::cap);
}

} // namespace
