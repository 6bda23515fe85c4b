// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/reaction_diffusion.h>

#include "delaunay.h"
#include "operator_test_meshes.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>

namespace {

using namespace operator_test;
using Vector = Eigen::VectorXd;

constexpr double pi = std::numbers::pi;
constexpr double solve_error = 1e-11; // condition numbers are under 1e4

TEST(Point_sources, of_the_green_function_balance_a_constant_sink) {
  Exact t = delaunay<Exact>(rough_torus(12, 0.8, 6).input());
  const Matrix m = IT::galerkin_mass_matrix(t), l = IT::cotangent_laplacian(t);
  const Vector u = IT::harmonic_green_function(t, 17);
  Vector expected = m * Vector::Constant(m.rows(), -1 / m.sum());
  expected[17] += 1;
  EXPECT_LE((l * u - expected).norm(), solve_error);
  EXPECT_NEAR((m * u).sum(), 0, solve_error * m.sum());
  EXPECT_NEAR(u[40], IT::harmonic_green_function(t, 40)[17], solve_error); // symmetric
}

TEST(Point_sources, of_heat_keep_their_integral_and_are_symmetric) {
  Exact t = delaunay<Exact>(rough_torus(12, 0.8, 7).input());
  const Matrix m = IT::galerkin_mass_matrix(t);
  const Vector u = IT::short_time_heat_kernel(t, 17, 0.5);
  EXPECT_NEAR((m * u).sum(), 1, solve_error);
  EXPECT_NEAR(u[40], IT::short_time_heat_kernel(t, 40, 0.5)[17], solve_error);
}

TEST(Point_sources, on_a_flat_torus_are_those_of_the_plane_nearby) {
  constexpr int n = 96; // cells of size 1
  Double t(torus(n, 0));
  const Vector green = IT::harmonic_green_function(t, 0);
  const double time = 25; // e^(-96/2/5): copies beyond a period are below 1e-4
  const Vector heat = IT::short_time_heat_kernel(t, 0, time);
  const auto singular = [](double r) { // near the source, up to a constant and r^4
    return -std::log(r) / (2 * pi) + r * r / (4. * n * n);
  };
  for (const int r : {8, 10, 12, 15}) {
    // five-point stencil: relative errors in the order of 1/r^2, from the expansion of the lattice function
    EXPECT_NEAR(green[r] - green[n * r], 0, 1e-9) << "symmetric in x and y";
    EXPECT_NEAR(green[r] - green[6], singular(r) - singular(6), 2e-3) << r;
    const double kernel = std::cyl_bessel_k(0, r / std::sqrt(time)) / (2 * pi * time);
    EXPECT_NEAR(heat[r], kernel, 0.02 * kernel) << r;
  }
}

TEST(Point_sources, refuse_vertices_without_faces_and_bad_times) {
  Shape s = tetrahedron();
  s.points.push_back({9, 9, 9});
  Exact t(s.input());
  for (const std::uint32_t v : {4U, 5U, 4000000000U}) {
    EXPECT_THROW(IT::harmonic_green_function(t, v), std::invalid_argument);
    EXPECT_THROW(IT::short_time_heat_kernel(t, v, 1), std::invalid_argument);
  }
  for (const double time : {0., -1.})
    EXPECT_THROW(IT::short_time_heat_kernel(t, 0, time), std::invalid_argument);
}

} // namespace
