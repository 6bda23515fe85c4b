// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_operators/elements/quadratic.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include "gallery.h"
#include "meshes.h"

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Corresponding_triangulation;
using Function = std::function<double(double, double)>;

/// Values of a function of the plane at vertices and midpoints; in a convex part, edges are
/// straight.
Eigen::VectorXd sampled(const Triangulation& t, const std::vector<meshes::Point>& points,
                        const Function& f) {
  Eigen::VectorXd u =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(points.size() + num_edges(t.mesh())));
  for (std::size_t v = 0; v < points.size(); ++v)
    u[static_cast<Eigen::Index>(v)] = f(points[v][0], points[v][1]);
  for (const auto e : edges(t.mesh())) {
    const auto h = halfedge(e, t.mesh());
    const meshes::Point &p = points[t.input_vertex(source(h, t.mesh()))],
                        &q = points[t.input_vertex(target(h, t.mesh()))];
    u[static_cast<Eigen::Index>(points.size() + t.index(e))] =
        f((p[0] + q[0]) / 2, (p[1] + q[1]) / 2);
  }
  return u;
}

/// A square of side 1 with random points inside, and the intrinsic Delaunay triangulation of a bad
/// one.
meshes::Mesh random_square(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<meshes::Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  for (meshes::Point& p : points) p = {1024 * p[0], 1024 * p[1], 0};
  for (std::size_t i = 0; i < n; ++i)
    points.push_back({double(1 + random() % 1023), double(1 + random() % 1023), 0});
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return meshes::scaled(meshes::swept(points), 0x1p-10);
}

// The integral over the unit square of x^i y^j.
double moment(int i, int j) { return 1. / ((i + 1) * (j + 1)); }

TEST(Quadratic_elements, are_exact_for_quadratic_polynomials) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const meshes::Mesh m = random_square(30, seed);
    Triangulation t(m.input());
    if (seed % 2 == 0) IT::flip_to_delaunay(t);
    std::mt19937 random(seed);
    std::array<double, 6> c;
    for (double& x : c) x = std::uniform_real_distribution<double>(-1, 1)(random);
    const Eigen::VectorXd u = sampled(t, m.points, [&](double x, double y) {
      return c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y;
    });
    const Eigen::SparseMatrix<double> l = IT::quadratic_laplacian(t),
                                      mass = IT::quadratic_mass_matrix(t);
    // |grad|^2 = (c1 + 2 c3 x + c4 y)^2 + (c2 + c4 x + 2 c5 y)^2
    const auto square = [](double a, double b, double d) { // of a + b x + d y, integrated
      return a * a + b * b / 3 + d * d / 3 + a * b + a * d + b * d / 2;
    };
    const double energy = square(c[1], 2 * c[3], c[4]) + square(c[2], c[4], 2 * c[5]);
    double norm = 0;
    const int power[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j)
        norm += c[i] * c[j] * moment(power[i][0] + power[j][0], power[i][1] + power[j][1]);
    // swept triangulations have cotangents up to 1e5 or so, which multiply the rounding of u
    EXPECT_NEAR(u.dot(l * u), energy, 1e-9 * l.diagonal().maxCoeff()) << "seed " << seed;
    EXPECT_NEAR(u.dot(mass * u), norm, 1e-13) << "seed " << seed;
    EXPECT_NEAR(mass.sum(), 1, 1e-13);
  }
}

TEST(Quadratic_elements, evaluate_to_the_polynomial) {
  const meshes::Mesh m = random_square(20, 5);
  Triangulation t(m.input());
  IT::flip_to_delaunay(t);
  const auto f = [](double x, double y) { return 1 + x - 2 * y + 3 * x * x - x * y + y * y; };
  const Eigen::VectorXd u = sampled(t, m.points, f);
  for (const auto face : faces(t.mesh())) {
    auto h = halfedge(face, t.mesh());
    const IT::Surface_point p{t.numbers().halfedge(h), {0.5, 0.375, 0.125}};
    double x = 0, y = 0;
    for (const double w : p.weights) {
      x += w * m.points[t.input_vertex(source(h, t.mesh()))][0];
      y += w * m.points[t.input_vertex(source(h, t.mesh()))][1];
      h = next(h, t.mesh());
    }
    EXPECT_NEAR(IT::quadratic_value(t, u, p), f(x, y), 1e-14);
  }
}

/// On any complex, also where a face meets itself: linear functions are among the quadratic ones.
TEST(Quadratic_elements, contain_the_linear_ones_on_every_complex) {
  for (const gallery::Surface& s : gallery::oriented()) {
    const Triangulation t(gallery::input(s));
    const auto n = static_cast<Eigen::Index>(t.number_of_vertices());
    Eigen::MatrixXd to_quadratic =
        Eigen::MatrixXd::Zero(n + static_cast<Eigen::Index>(num_edges(t.mesh())), n);
    to_quadratic.topRows(n).setIdentity();
    for (const auto e : edges(t.mesh())) {
      const auto h = halfedge(e, t.mesh());
      for (const auto v : {source(h, t.mesh()), target(h, t.mesh())})
        to_quadratic(n + t.index(e), t.input_vertex(v)) += 0.5;
    }
    const Eigen::MatrixXd l = to_quadratic.transpose() * IT::quadratic_laplacian(t) * to_quadratic,
                          m = to_quadratic.transpose() * IT::quadratic_mass_matrix(t) *
                              to_quadratic;
    const Eigen::MatrixXd linear = IT::cotangent_laplacian(t), mass = IT::galerkin_mass_matrix(t);
    EXPECT_LE((l - linear).norm(), 1e-13 * (1 + linear.norm())) << s.name;
    EXPECT_LE((m - mass).norm(), 1e-14 * mass.norm()) << s.name;
  }
}

/// Error in the L2 norm of (-Laplace + 1) u = f on a square, u = cos(pi x) cos(pi y), on a jittered
/// grid of n^2 cells.
double helmholtz_error(std::uint32_t n) {
  meshes::Mesh m = meshes::scaled(meshes::grid(n, n), 1. / n); // n is a power of two
  std::mt19937 random(n);
  for (meshes::Point& p : m.points)
    for (std::size_t x : {0U, 1U})
      if (p[x] > 0 && p[x] < 1)
        p[x] += std::uniform_real_distribution<double>(-0.2, 0.2)(random) / n;
  Triangulation t(m.input());
  IT::flip_to_delaunay(t);
  const auto u = [](double x, double y) {
    return std::cos(std::numbers::pi * x) * std::cos(std::numbers::pi * y);
  };
  const Eigen::VectorXd exact = sampled(t, m.points, u);
  const Eigen::SparseMatrix<double> mass = IT::quadratic_mass_matrix(t),
                                    a = IT::quadratic_laplacian(t) + mass;
  const Eigen::VectorXd f = (2 * std::numbers::pi * std::numbers::pi + 1) * exact;
  const Eigen::VectorXd d =
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(a).solve(mass * f) - exact;
  return std::sqrt(d.dot(mass * d));
}

TEST(Quadratic_elements, converge_with_the_third_power) {
  const double coarse = helmholtz_error(8), fine = helmholtz_error(32);
  EXPECT_LT(fine, coarse / 4 / 4 / 4 * 1.5); // linear ones fall by 16 only
  EXPECT_LT(fine, 1e-5);
}

} // namespace
