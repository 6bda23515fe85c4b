// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/residual_indicators.h>

#include "delaunay.h"
#include "operator_test_meshes.h"

#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/reaction_diffusion.h>

#include <boost/graph/graph_traits.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace {

using namespace operator_test;
using IT::Border_condition;
using IT::Error_norm;
using Vector = Eigen::VectorXd;

constexpr double pi = std::numbers::pi;
constexpr double rounding = 1e-12; // well-shaped faces: some hundred roundings

double norm(const std::vector<double>& x) {
  return Eigen::Map<const Vector>(x.data(), static_cast<Eigen::Index>(x.size())).norm();
}

template <class T>
bool is_border(const T& t, typename T::halfedge_descriptor h) {
  return face(h, t.mesh()) == boost::graph_traits<typename T::Mesh>::null_face();
}

/// Six equilateral triangles about vertex 0.
Shape hexagon(double side) {
  Shape s{{{0, 0, 0}}, {}};
  for (std::uint32_t k = 0; k < 6; ++k) {
    s.points.push_back({side * std::cos(k * pi / 3), side * std::sin(k * pi / 3), 0});
    s.triangles.push_back({0, 1 + k, 1 + (k + 1) % 6});
  }
  return s;
}

TEST(Residual_indicators, of_a_hat_function_on_a_hexagon) {
  for (const double side : {1., 2.}) {
    Double t(hexagon(side).input());
    const Vector u = Vector::Unit(7, 0), f = Vector::Zero(7);
    const double a = 3;
    // The gradient has length 2 / (sqrt 3 side). The normals of spokes are at 60 degrees to it: the jump
    // of the derivative is 2 / (sqrt 3 side), and so is the derivative across the rim. Its square times the
    // length of the edge is 4/3 / side, of which a face has half at two spokes, and all at the rim.
    const double jumps = 4. / 3 / side;
    const auto check = [&](Error_norm n, Border_condition b, double squared) {
      for (const double eta : IT::residual_indicators(t, {.diffusion = a}, u, f, n,
                                                      IT::parameters::border_condition(b)))
        EXPECT_NEAR(eta, std::sqrt(squared), rounding * eta);
    };
    check(Error_norm::energy, Border_condition::natural, side / a * a * a * 2 * jumps);
    check(Error_norm::energy, Border_condition::values, side / a * a * a * jumps);
    check(Error_norm::L2, Border_condition::natural, side * side * side * 2 * jumps);
    check(Error_norm::L2, Border_condition::values, side * side * side * jumps);
  }
}

TEST(Residual_indicators, of_constants_are_what_the_equation_leaves) {
  for (const double side : {1., 2.}) {
    Double t(hexagon(side).input());
    const Vector u = Vector::Constant(7, 3), f = Vector::Constant(7, 5);
    const double area = side * side * std::sqrt(3.0) / 4;
    const auto check = [&](const IT::Reaction_diffusion& e, Error_norm n, double squared) {
      for (const double eta : IT::residual_indicators(t, e, u, f, n))
        EXPECT_NEAR(eta, std::sqrt(squared), rounding * eta);
    };
    const double s2 = side * side;
    check({.diffusion = 2}, Error_norm::energy, s2 / 2 * 25 * area);
    check({.diffusion = 2}, Error_norm::L2, s2 * s2 / 4 * 25 * area);
    // resolved: a/c = 10 > side^2; the residual is 5 - 0.2 * 3
    check({.diffusion = 2, .reaction = 0.2}, Error_norm::energy, s2 / 2 * 4.4 * 4.4 * area);
    // not resolved: the weights are 1/c and 1/c^2
    check({.diffusion = 1e-3, .reaction = 2}, Error_norm::energy, 1. / 2 * area);
    check({.diffusion = 1e-3, .reaction = 2}, Error_norm::L2, 1. / 4 * area);
  }
}

TEST(Residual_indicators, are_in_range_where_their_squares_are_not) {
  for (const double side : {0x1p-300, 0x1p300}) {
    Double t(hexagon(side).input());
    const Vector u = Vector::Constant(7, 3), f = Vector::Constant(7, 5);
    const double expected = side * side / 2 * 5 * side * std::sqrt(std::sqrt(3.0) / 4);
    for (const double eta : IT::residual_indicators(t, {.diffusion = 2}, u, f, Error_norm::L2))
      EXPECT_NEAR(eta, expected, rounding * expected);
  }
}

TEST(Residual_indicators, integrate_residuals_that_are_linear_on_faces) {
  const Shape s{{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, {{0, 1, 2}}};
  Double t(s.input());
  Vector f(3);
  f << 1, -2, 5;
  // the rule of midpoints is exact for quadratic polynomials
  const double squared = 6. / 3 * (0.25 + 2.25 + 9);
  const auto eta = IT::residual_indicators(t, {}, Vector::Zero(3), f, Error_norm::energy);
  EXPECT_NEAR(eta[0], 5 * std::sqrt(squared), rounding * eta[0]);
}

TEST(Residual_indicators, of_a_linear_function_on_a_flat_patch_are_fluxes_through_the_border) {
  const Shape s = rough_grid(12, 0.12, 0, 1); // nothing folds over
  const Double t = delaunay<Double>(s.input());
  Vector u(static_cast<int>(s.points.size()));
  for (std::uint32_t v = 0; v < s.points.size(); ++v)
    u[v] = 3 * s.points[v][0] - 2 * s.points[v][1];
  const Vector f = Vector::Zero(u.size());
  const auto inner = IT::residual_indicators(
      t, {}, u, f, Error_norm::energy, IT::parameters::border_condition(Border_condition::values));
  EXPECT_LE(*std::max_element(inner.begin(), inner.end()),
            1e-10); // slivers: angles of some degrees
  const auto all = IT::residual_indicators(t, {}, u, f, Error_norm::energy);
  for (const auto face : faces(t.mesh())) {
    double squared = 0; // of the flux, which is the difference of u turned by 90 degrees
    auto h = halfedge(face, t.mesh());
    for (int k = 0; k < 3; ++k, h = next(h, t.mesh())) {
      if (!is_border(t, opposite(h, t.mesh()))) continue;
      const auto &p = s.points[t.input_vertex(source(h, t.mesh()))],
                 &q = s.points[t.input_vertex(target(h, t.mesh()))];
      const double through = 3 * (q[1] - p[1]) + 2 * (q[0] - p[0]);
      squared += through * through;
    }
    EXPECT_NEAR(all[t.index(face)], std::sqrt(squared), 1e-10);
  }
}

// the integral of the outward derivative over a side, by cotangents of angles from the law of cosines
template <class T, class H>
double flux(const T& t, const Vector& u, H ij) {
  const auto& mesh = t.mesh();
  const H jk = next(ij, mesh), ki = next(jk, mesh);
  const auto l = [&](H h) { return std::sqrt(t.squared_length(edge(h, mesh))); };
  const auto cot = [](double opposite, double b, double c) {
    return 1 / std::tan(std::acos((b * b + c * c - opposite * opposite) / (2 * b * c)));
  };
  const auto at = [&](H h) { return u[t.input_vertex(source(h, mesh))]; };
  return cot(l(ki), l(ij), l(jk)) * (at(ij) - at(ki)) +
         cot(l(jk), l(ij), l(ki)) * (at(jk) - at(ki));
}

TEST(Residual_indicators, follow_the_gluing_on_every_delta_complex) {
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    Exact t(input(s));
    const Vector u = random_vector(IT::checked_matrix_size(t), 3);
    const auto eta = IT::residual_indicators(t, {}, u, Vector::Zero(u.size()), Error_norm::energy);
    for (const auto face : faces(t.mesh())) {
      double squared = 0; // w_E |jump|^2 |E| = (|E| jump)^2
      auto h = halfedge(face, t.mesh());
      for (int k = 0; k < 3; ++k, h = next(h, t.mesh())) {
        const auto o = opposite(h, t.mesh());
        const bool border = is_border(t, o);
        const double jump = flux(t, u, h) + (border ? 0 : flux(t, u, o));
        squared += (border ? 1 : 0.5) * jump * jump;
      }
      EXPECT_NEAR(eta[t.index(face)], std::sqrt(squared), 1e-9 * (1 + std::sqrt(squared)));
    }
  }
}

// ---- a smooth problem on the unit square: u = cos(pi x) cos(pi y), no flux through the border

struct Errors {
  double energy, L2, estimated_energy, estimated_L2;
};

Shape unit_square(std::uint32_t n) {
  Shape s = grid(n);
  for (auto& p : s.points)
    for (double& x : p) x /= n;
  return s;
}

Errors smooth_problem(std::uint32_t n, const IT::Reaction_diffusion& e) {
  const Shape s = unit_square(n);
  Double t(s.input());
  const auto exact = [](double x, double y) { return std::cos(pi * x) * std::cos(pi * y); };
  Vector w(static_cast<int>(s.points.size()));
  for (std::uint32_t v = 0; v < s.points.size(); ++v) w[v] = exact(s.points[v][0], s.points[v][1]);
  const Vector f = (2 * pi * pi * e.diffusion + e.reaction) * w;
  Vector load = IT::galerkin_mass_matrix(t) * f;
  if (e.reaction == 0) load.array() -= load.mean(); // a rounding
  const Vector u = IT::solve_reaction_diffusion(t, e, load);
  Errors r{};
  for (const auto& c : s.triangles) {
    const double area = 0.5 / n / n;
    Eigen::Matrix2d sides;
    sides << s.points[c[1]][0] - s.points[c[0]][0], s.points[c[1]][1] - s.points[c[0]][1],
        s.points[c[2]][0] - s.points[c[0]][0], s.points[c[2]][1] - s.points[c[0]][1];
    const Eigen::Vector2d gradient =
        sides.inverse() * Eigen::Vector2d(u[c[1]] - u[c[0]], u[c[2]] - u[c[0]]);
    for (unsigned k = 0; k < 3; ++k) { // midpoints
      const std::uint32_t i = c[k], j = c[(k + 1) % 3];
      const double x = (s.points[i][0] + s.points[j][0]) / 2;
      const double y = (s.points[i][1] + s.points[j][1]) / 2;
      const Eigen::Vector2d g(-pi * std::sin(pi * x) * std::cos(pi * y),
                              -pi * std::cos(pi * x) * std::sin(pi * y));
      const double d = (u[i] + u[j]) / 2 - exact(x, y);
      r.L2 += area / 3 * d * d;
      r.energy += area / 3 * (e.diffusion * (gradient - g).squaredNorm() + e.reaction * d * d);
    }
  }
  r.L2 = std::sqrt(r.L2);
  r.energy = std::sqrt(r.energy);
  r.estimated_energy = norm(IT::residual_indicators(t, e, u, f, Error_norm::energy));
  r.estimated_L2 = norm(IT::residual_indicators(t, e, u, f, Error_norm::L2));
  return r;
}

TEST(Residual_indicators, fall_with_the_error_at_the_rates_of_linear_elements) {
  for (const IT::Reaction_diffusion& e :
       {IT::Reaction_diffusion{1, 0}, IT::Reaction_diffusion{1, 1}}) {
    const Errors coarse = smooth_problem(16, e), fine = smooth_problem(64, e);
    // h falls by 4: the energy error by 4, the L2 error by 16, up to h^2
    EXPECT_NEAR(coarse.energy / fine.energy, 4, 0.1);
    EXPECT_NEAR(coarse.estimated_energy / fine.estimated_energy, 4, 0.2);
    EXPECT_NEAR(coarse.L2 / fine.L2, 16, 0.8);
    EXPECT_NEAR(coarse.estimated_L2 / fine.estimated_L2, 16, 1.6);
  }
}

TEST(Residual_indicators, bound_the_energy_error_whatever_the_coefficients) {
  // The bound has its own constant, that of interpolation on right isosceles faces, for all
  // coefficients. Where diffusion is not resolved, linear elements with data at the nodes are
  // better than the bound.
  for (const double c : {0., 1., 1e2, 1e3, 1e4}) {
    const Errors r = smooth_problem(24, {1, c});
    SCOPED_TRACE(testing::Message()
                 << "reaction " << c << ", effectivity " << r.estimated_energy / r.energy);
    EXPECT_GE(r.estimated_energy, r.energy);
    EXPECT_LE(r.estimated_energy, 10 * r.energy);
  }
  // scaling the equation by k scales energies by k: the effectivity stays
  const Errors one = smooth_problem(8, {1, 3}), thousand = smooth_problem(8, {1000, 3000});
  EXPECT_NEAR(thousand.estimated_energy / thousand.energy, one.estimated_energy / one.energy, 1e-6);
  EXPECT_NEAR(thousand.estimated_L2, one.estimated_L2, 1e-6 * one.estimated_L2);
}

TEST(Residual_indicators, agree_across_arithmetics) {
  const Shape s = rough_torus(12, 0.8, 6);
  const Exact exact = delaunay<Exact>(s.input());
  const Double rounded = delaunay<Double>(s.input());
  const Vector u = random_vector(144, 1), f = random_vector(144, 2);
  const IT::Reaction_diffusion e{0.1, 1};
  auto x = IT::residual_indicators(exact, e, u, f, Error_norm::L2);
  auto y = IT::residual_indicators(rounded, e, u, f, Error_norm::L2);
  std::sort(x.begin(), x.end()); // numbers of faces depend on the order of flips
  std::sort(y.begin(), y.end());
  ASSERT_EQ(x.size(), y.size());
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], y[i], 1e-10 * x[i]);
}

TEST(Residual_indicators, refuse_what_makes_no_sense) {
  Double t(hexagon(1).input());
  const Vector u = Vector::Zero(7), w = Vector::Zero(6);
  EXPECT_THROW(IT::residual_indicators(t, {}, w, u, Error_norm::L2), std::invalid_argument);
  EXPECT_THROW(IT::residual_indicators(t, {}, u, w, Error_norm::L2), std::invalid_argument);
  EXPECT_THROW(IT::residual_indicators(t, {.diffusion = 0}, u, u, Error_norm::L2),
               std::invalid_argument);
  const Shape flat{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}}, {{0, 1, 2}, {1, 0, 3}}};
  Double degenerate(flat.input());
  EXPECT_THROW(
      IT::residual_indicators(degenerate, {}, Vector::Unit(4, 0), Vector::Zero(4), Error_norm::L2),
      IT::Invalid_input);
}

} // namespace
