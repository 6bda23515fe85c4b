// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/reaction_diffusion.h>
#include <CGAL/Intrinsic_operators/operators/residual_indicators.h>
#include <CGAL/Intrinsic_operators/operators/subdivision_matrices.h>
#include <CGAL/Intrinsic_operators/operators/transfer.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/optimization/odt_optimize.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/adaptive_refine.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include "meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Whatever has a unit is in the user's: a mesh that is s times as large gives s, s^2, ... times as much.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using T = IT::Corresponding_triangulation;

/// A mesh and one that is `s` times as large, flipped in the same way.
struct Pair {
  double s;
  T one, large;

  explicit Pair(double scale)
      : s(scale), one(meshes::rough_grid(6, 5).input()),
        large(meshes::scaled(meshes::rough_grid(6, 5), scale).input()) {
    IT::flip_to_delaunay(one);
    IT::flip_to_delaunay(large);
  }
  /// Whether values in units of length to some power are right.
  void expect(double in_one, double in_large, int power, double tolerance = 1e-9) const {
    const double expected = in_one * std::pow(s, power);
    EXPECT_NEAR(in_large, expected, tolerance * std::abs(expected)) << s;
  }
};

class Units : public testing::TestWithParam<double> {};

TEST_P(Units, Of_lengths_areas_and_matrices_are_the_users) {
  const Pair p(GetParam());
  EXPECT_NE(p.large.input().scale_exponent(), p.one.input().scale_exponent());
  for (const auto e : edges(p.one.mesh())) {
    p.expect(p.one.length(e), p.large.length(e), 1);
    p.expect(p.one.squared_length(e), p.large.squared_length(e), 2);
  }
  for (const auto f : faces(p.one.mesh())) p.expect(p.one.area(f), p.large.area(f), 2);
  p.expect(IT::odt_energy(p.one), IT::odt_energy(p.large), 4);
  const auto matrix = [&](const auto& a, const auto& b, int power) {
    const Eigen::SparseMatrix<double> d = b - std::pow(p.s, power) * a;
    EXPECT_LE(d.norm(), 1e-9 * b.norm()) << p.s;
  };
  matrix(IT::cotangent_laplacian(p.one), IT::cotangent_laplacian(p.large), 0);
  matrix(IT::lumped_mass_matrix(p.one), IT::lumped_mass_matrix(p.large), 2);
  matrix(IT::galerkin_mass_matrix(p.one), IT::galerkin_mass_matrix(p.large), 2);
  const IT::Common_subdivision s = IT::common_subdivision(p.one),
                               l = IT::common_subdivision(p.large);
  matrix(IT::subdivision_mass_matrix(p.one, s), IT::subdivision_mass_matrix(p.large, l), 2);
  const auto a = IT::subdivision_areas(p.one, s), b = IT::subdivision_areas(p.large, l);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t f = 0; f < a.size(); ++f) EXPECT_NEAR(b[f], p.s * p.s * a[f], 1e-9 * p.s * p.s);
}

TEST_P(Units, Of_solutions_and_errors_are_the_users) {
  Pair p(GetParam());
  const auto green = IT::harmonic_green_function(p.one, 0),
             large = IT::harmonic_green_function(p.large, 0);
  EXPECT_LE((green - large).norm(), 1e-9 * green.norm()); // of a logarithm of lengths
  const Eigen::VectorXd u = IT::short_time_heat_kernel(p.one, 0, 0.1),
                        v = IT::short_time_heat_kernel(p.large, 0, 0.1 * p.s * p.s);
  EXPECT_LE((u - p.s * p.s * v).norm(), 1e-9 * u.norm()); // per area
  // a u - c div grad u = 0 with a lengthscale; u is an inverse area
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(u.size());
  const auto e = IT::residual_indicators(p.one, {.diffusion = 0.1, .reaction = 1}, u, zero,
                                         IT::Error_norm::L2);
  const auto f = IT::residual_indicators(p.large, {.diffusion = 0.1 * p.s * p.s, .reaction = 1}, v,
                                         zero, IT::Error_norm::L2);
  for (std::size_t i = 0; i < e.size(); ++i) p.expect(e[i], f[i], -1, 1e-7);
  const IT::Common_subdivision s = IT::common_subdivision(p.one),
                               l = IT::common_subdivision(p.large);
  const Eigen::VectorXd g = IT::copy_to_input(p.one, u).reverse();
  p.expect(IT::L2_distance(p.one, s, u, g), IT::L2_distance(p.large, l, u, g), 1);
  const Eigen::VectorXd nearest = IT::L2_transfer(p.one, s)(u),
                        also = IT::L2_transfer(p.large, l)(u);
  EXPECT_LE((nearest - also).norm(), 1e-9 * nearest.norm());
}

TEST_P(Units, Of_bounds_of_refinement_and_optimization_are_the_users) {
  const double s = GetParam();
  const meshes::Mesh mesh = meshes::scaled(meshes::rough_grid(6, 5), s);
  T t(mesh.input());
  const auto r = IT::delaunay_refine(
      t,
      IT::parameters::minimum_angle(20).maximum_circumradius(0.4 * s).maximum_edge_length(0.5 * s));
  EXPECT_EQ(r.status, IT::Status::done);
  EXPECT_TRUE(r.unsatisfied.empty());
  double longest = 0;
  for (const auto e : edges(t.mesh())) longest = std::max(longest, t.length(e));
  EXPECT_LE(longest, 0.5 * s * (1 + 1e-12));
  EXPECT_GT(longest, 0.3 * s); // not refined more than required
  for (const auto f : faces(t.mesh())) {
    double product = 1;
    auto h = halfedge(f, t.mesh());
    for (int k = 0; k < 3; ++k, h = next(h, t.mesh())) product *= t.length(edge(h, t.mesh()));
    EXPECT_LE(product / (4 * t.area(f)), 0.4 * s * (1 + 1e-9));
  }
  T o(mesh.input());
  const auto result = IT::odt_optimize(o, IT::parameters::maximum_edge_length(0.5 * s));
  EXPECT_EQ(result.status, IT::Status::done);
  double longest_of_o = 0;
  for (const auto e : edges(o.mesh())) longest_of_o = std::max(longest_of_o, o.length(e));
  EXPECT_LE(longest_of_o, 0.5 * s * (1 + 1e-12));
  EXPECT_GT(longest_of_o, 0.3 * s);
  EXPECT_NEAR(result.energy_after, IT::odt_energy(o), 1e-9 * result.energy_after);
}

// All have a scale exponent that is not zero.
INSTANTIATE_TEST_SUITE_P(Scales, Units, testing::Values(1000., 0.001, 0x1p20));

} // namespace
