// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "delaunay.h"
#include "operator_test_meshes.h"
#include "soups.h"
#include "uneven_laplacians.h"

#include <CGAL/Intrinsic_operators/editing/Heat_flow.h>
#include <CGAL/Intrinsic_operators/editing/Surface_deformation.h>
#include <CGAL/Intrinsic_operators/editing/interpolate_harmonically.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

namespace editing {

using namespace operator_test;
using namespace uneven_laplacians;
using Rows = std::vector<std::uint32_t>;
using Energy = IT::Deformation_energy;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

Eigen::MatrixXd points_of(const Shape& s) {
  Eigen::MatrixXd x(static_cast<Eigen::Index>(s.points.size()), 3);
  for (std::uint32_t v = 0; v < s.points.size(); ++v) x.row(v) = s.point(v);
  return x;
}

// What has no energy is found: a translation by either, the bending of a strip by neither.
TEST(Surface_deformation, handles_that_move_alike_move_everything) {
  const Exact t = delaunay<Exact>(rough_grid(6, 0.3, 1, 2).input());
  const Eigen::RowVector3d shift(1, -2, 0.5);
  for (const Energy energy : {Energy::harmonic, Energy::biharmonic}) {
    const IT::Surface_deformation deformation(t, Rows{3, 17, 40, 17}, energy);
    const Eigen::MatrixXd d = deformation.displacements(shift.replicate(4, 1));
    // the condition is about the squared number of vertices, and its square
    EXPECT_LE((d.rowwise() - shift).norm(), 1e6 * epsilon) << static_cast<int>(energy);
    EXPECT_EQ(d.row(17), shift);
  }
}

// There is nothing to solve in components that stay, so that they need no handles.
TEST(Surface_deformation, components_without_handles_stay) {
  Shape many = tetrahedron();
  for (int k = 1; k < 100; ++k) many = beside(many, tetrahedron(), 5. * k);
  const Exact t(many.input());
  for (const Energy energy : {Energy::harmonic, Energy::biharmonic}) {
    const IT::Surface_deformation deformation(t, Rows{5}, energy, IT::Linear_solver::iterative);
    const Eigen::VectorXd d = deformation.displacements(Eigen::VectorXd::Ones(1));
    EXPECT_LE((d.segment(4, 4).array() - 1).abs().maxCoeff(), 1e-9);
    EXPECT_EQ(d.head(4).norm(), 0);
    EXPECT_EQ(d.tail(d.size() - 8).norm(), 0);
  }
}

// The function with given values in some rows and L M^-1 L d = 0 in the others, to 100 digits; the diagonal of L is minus the sum of the row.
std::vector<Precise> precise_biharmonic(const Matrix& l, const Eigen::VectorXd& mass,
                                        const Rows& rows, const Eigen::VectorXd& values) {
  const auto n = static_cast<std::size_t>(l.rows());
  using Table = std::vector<std::vector<Precise>>;
  Table a(n, std::vector<Precise>(n, 0)), b = a;
  for (std::size_t c = 0; c < n; ++c)
    for (Matrix::InnerIterator i(l, static_cast<int>(c)); i; ++i) {
      const auto r = static_cast<std::size_t>(i.row());
      if (r == c) continue;
      a[r][c] = i.value();
      a[c][c] -= i.value();
    }
  std::vector<Precise> x(n, 0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) {
      if (a[i][k] == 0) continue;
      const Precise factor = a[i][k] / mass[static_cast<Eigen::Index>(k)];
      for (std::size_t j = 0; j < n; ++j) b[i][j] += factor * a[k][j];
    }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    b[rows[i]].assign(n, 0);
    b[rows[i]][rows[i]] = 1;
    x[rows[i]] = values[static_cast<Eigen::Index>(i)];
  }
  const auto eliminate = [&](std::size_t k, std::size_t i) {
    if (i == k || b[i][k] == 0) return;
    const Precise factor = b[i][k] / b[k][k];
    for (std::size_t j = k; j < n; ++j) b[i][j] -= factor * b[k][j];
    x[i] -= factor * x[k];
  };
  for (const std::uint32_t k : rows) // their rows are those of the identity
    for (std::size_t i = 0; i < n; ++i) eliminate(k, i);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i) eliminate(k, i);
  for (std::size_t k = 0; k < n; ++k) x[k] /= b[k][k];
  return x;
}

/// Slivers make weights for which the square of the Laplacian loses the small eigenvalues: from 1e8
/// on doubles cannot hold them.
TEST(Surface_deformation, is_right_beside_great_weights) {
  for (const double greatest : {1., 1e5, 1e9, 1e15}) {
    const auto [l, m] = uneven_grid(7, greatest);
    const Eigen::VectorXd mass = m.diagonal();
    for (const Rows& handles : {Rows{0, 24}, Rows{3, 4, 10, 30, 48, 47, 41}}) {
      Eigen::VectorXd values(static_cast<Eigen::Index>(handles.size()));
      for (Eigen::Index i = 0; i < values.size(); ++i)
        values[i] = std::cos(3. * static_cast<double>(i));
      const IT::Surface_deformation deformation(l, mass, handles, Energy::biharmonic);
      const Eigen::MatrixXd d = deformation.displacements(values);
      const std::vector<Precise> wanted = precise_biharmonic(l, mass, handles, values);
      const double greatest_value = d.cwiseAbs().maxCoeff();
      for (Eigen::Index i = 0; i < d.rows(); ++i)
        EXPECT_NEAR(d(i, 0), static_cast<double>(wanted[static_cast<std::size_t>(i)]),
                    1e-13 * greatest_value)
            << greatest << ' ' << i;
    }
  }
}

// Up to 64 handles beside free vertices, the problem is solved by them; for those of two grids together, the product of Laplacians is factored.
TEST(Surface_deformation, of_many_handles_is_that_of_few) {
  for (const double greatest : {1., 1e15}) {
    const auto [l, m] = uneven_grid(16, greatest);
    Rows handles;
    for (std::uint32_t r = 0; handles.size() < 64; r += 3) handles.push_back(r);
    const Eigen::VectorXd mass = m.diagonal();
    const Eigen::VectorXd values = Eigen::ArrayXd::LinSpaced(64, 0, 63).sin();
    const Eigen::MatrixXd few =
        IT::Surface_deformation(l, mass, handles, Energy::biharmonic).displacements(values);
    std::vector<Eigen::Triplet<double>> entries;
    for (int c = 0; c < 256; ++c)
      for (Matrix::InnerIterator i(l, c); i; ++i)
        for (const int grid : {0, 256})
          entries.emplace_back(grid + static_cast<int>(i.row()), grid + c, i.value());
    Matrix both(512, 512);
    both.setFromTriplets(entries.begin(), entries.end());
    for (std::size_t i = 0; i < 64; ++i) handles.push_back(256 + handles[i]);
    const Eigen::MatrixXd many =
        IT::Surface_deformation(both, mass.replicate(2, 1), handles, Energy::biharmonic)
            .displacements(values.replicate(2, 1));
    EXPECT_LE((few.replicate(2, 1) - many).cwiseAbs().maxCoeff(), 1e-9 * few.cwiseAbs().maxCoeff())
        << greatest;
  }
}

// A strip of n x 1 squares that is held at its first two columns and pulled at its last two is a beam: along it a harmonic displacement is linear,
// and a biharmonic one, with all masses alike, the cubic with the given values and slopes, of which fourth differences vanish.
TEST(Surface_deformation, of_a_strip_is_a_beam) {
  const std::uint32_t n = 12;
  Shape strip;
  for (std::uint32_t x = 0; x <= n; ++x)
    for (const double y : {0., 1.}) strip.points.push_back({static_cast<double>(x), y, 0});
  for (std::uint32_t x = 0; x < n; ++x) {
    strip.triangles.push_back({2 * x, 2 * x + 2, 2 * x + 3});
    strip.triangles.push_back({2 * x, 2 * x + 3, 2 * x + 1});
  }
  const Exact t(strip.input());
  const Matrix l = IT::cotangent_laplacian(t);
  Eigen::VectorXd mass = Eigen::VectorXd::Ones(l.rows());
  Rows handles;
  for (const std::uint32_t x : {0U, 1U, n - 1, n})
    for (const std::uint32_t y : {0U, 1U}) handles.push_back(2 * x + y);
  const auto cubic = [](double x) { return x * x * (3 - x / 6); };
  Eigen::VectorXd values(8);
  for (Eigen::Index i = 0; i < 8; ++i) values[i] = cubic(handles[static_cast<std::size_t>(i)] / 2U);
  const IT::Surface_deformation beam(l, mass, handles, Energy::biharmonic);
  const Eigen::VectorXd d = beam.displacements(values);
  for (std::uint32_t v = 0; v < d.size(); ++v)
    EXPECT_NEAR(d[v], cubic(v / 2U), 1e-10 * cubic(n)) << v;
  const IT::Surface_deformation rope(t, Rows{0, 1, 2 * n, 2 * n + 1}, Energy::harmonic);
  const Eigen::VectorXd linear = rope.displacements(Eigen::Vector4d(0, 0, 12, 12));
  for (std::uint32_t v = 0; v < linear.size(); ++v) EXPECT_NEAR(linear[v], v / 2U, 1e-12);
}

TEST(Surface_deformation, moves_nothing_where_there_is_no_handle) {
  Shape two = two_tetrahedra();
  two.points.push_back({0, 0, 20}); // isolated
  const Exact t(two.input());
  for (const Energy energy : {Energy::harmonic, Energy::biharmonic}) {
    const IT::Surface_deformation deformation(t, Rows{5}, energy);
    const Eigen::VectorXd d = deformation.displacements(Eigen::VectorXd::Constant(1, 3));
    for (Eigen::Index v = 0; v < 9; ++v) EXPECT_NEAR(d[v], v >= 4 && v < 8 ? 3 : 0, 64 * epsilon);
  }
  const IT::Surface_deformation none(t, Rows{}, Energy::biharmonic);
  EXPECT_EQ(none.displacements(Eigen::MatrixXd(0, 3)).norm(), 0);
}

struct Stopping {
  int steps_to_go; ///< then it stops
  bool progress(IT::Deformation_step) { return steps_to_go-- > 0; }
};

TEST(Surface_deformation, can_be_followed_and_cancelled) {
  const Exact t(cube().input());
  for (const Energy energy : {Energy::harmonic, Energy::biharmonic})
    for (int steps = 0; steps < 3; ++steps) {
      Stopping visitor{steps};
      const IT::Surface_deformation d(t, Rows{0}, energy,
                                      IT::parameters::visitor(std::ref(visitor)));
      const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(1, 3);
      EXPECT_EQ(d.status(), steps < 2 ? IT::Status::cancelled : IT::Status::done);
      if (steps < 2) {
        EXPECT_THROW(d.displacements(one), std::logic_error);
      } else {
        EXPECT_LE((d.displacements(one).array() - 1).abs().maxCoeff(), 16 * epsilon);
      }
    }
}

TEST(Surface_deformation, refuses_what_makes_no_sense) {
  const Exact t(cube().input());
  EXPECT_THROW(IT::Surface_deformation(t, Rows{8}), std::invalid_argument);
  const IT::Surface_deformation twice(t, Rows{0, 1, 0});
  EXPECT_THROW(twice.displacements(Eigen::MatrixXd::Ones(2, 3)), std::invalid_argument);
  EXPECT_THROW(twice.displacements(Eigen::Vector3d(1, 2, 3)), std::invalid_argument);
}

// On the torus of n x n unit squares, exp(2 pi i (p x + q y) / n) is an eigenfunction of the five point stencil: each step divides it.
TEST(Heat_flow, divides_eigenfunctions) {
  const std::uint32_t n = 10;
  const Exact t(torus(n, 0));
  const double time = 2.5, angle = 2 * std::numbers::pi / n;
  Eigen::MatrixXd x(n * n, 2);
  for (std::uint32_t v = 0; v < n * n; ++v)
    x.row(v) << std::cos(angle * (v % n)), std::sin(angle * (v % n + 3 * (v / n)));
  const Eigen::MatrixXd y = IT::Heat_flow(t, time).step(x);
  const auto eigenvalue = [&](double p) { return 4 * std::pow(std::sin(angle * p / 2), 2); };
  EXPECT_LE((y.col(0) * (1 + time * eigenvalue(1)) - x.col(0)).norm(), 1e-12);
  EXPECT_LE((y.col(1) * (1 + time * (eigenvalue(1) + eigenvalue(3))) - x.col(1)).norm(), 1e-12);
}

TEST(Heat_flow, stays_in_range_and_keeps_the_mean) {
  Shape s = rough_torus(8, 0.4, 3);
  const double far = 100;
  s.points.push_back({far, far, far}); // isolated
  const Exact t = delaunay<Exact>(s.input());
  const Eigen::MatrixXd x = points_of(s), y = IT::Heat_flow(t, 0.3).step(x);
  const Eigen::RowVectorXd mass = IT::lumped_mass_matrix(t).diagonal();
  EXPECT_LE((mass * (x - y)).norm(), 1e-11 * (mass * x.cwiseAbs()).norm());
  for (Eigen::Index c = 0; c < 3; ++c) {
    EXPECT_LE(y.col(c).maxCoeff(), x.col(c).maxCoeff() + 16 * epsilon * far);
    EXPECT_GE(y.col(c).minCoeff(), x.col(c).minCoeff() - 16 * epsilon);
  }
  EXPECT_LE((y.bottomRows(1) - x.bottomRows(1)).norm(), 4 * epsilon * far);
  EXPECT_THROW(IT::Heat_flow(t, -1), std::invalid_argument);
  EXPECT_THROW(IT::Heat_flow(t, 1).step(Eigen::MatrixXd::Ones(3, 3)), std::invalid_argument);
}

// A sphere shrinks by mean curvature flow, r dr = -2 dt: one implicit step multiplies it by 1 / (1 + 2 t / r^2), as its coordinates are eigenfunctions.
TEST(Heat_flow, shrinks_a_sphere) {
  Shape s{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  // an octahedron: weights 1 / sqrt 3, so L x = 4 / sqrt 3 x, and masses 2 / sqrt 3: eigenvalue 2 / r^2 to the digit
  const Exact t(s.input());
  const Eigen::MatrixXd x = points_of(s), y = IT::Heat_flow(t, 0.25).step(x);
  EXPECT_LE((1.5 * y - x).norm(), 64 * epsilon);
}

TEST(Interpolate_harmonically, stays_in_range_on_covers_of_anything) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    auto domain =
        IT::make_domain(soups::soup(soups::random(30, 60, seed)), IT::Domain_kind::tufted_cover);
    const Exact t = delaunay<Exact>(std::move(domain.input));
    const Matrix l = IT::cotangent_laplacian(t);
    Rows rows = IT::rows_with_constant_kernel(l); // a vertex in each component, and others
    for (const std::uint32_t r : {3U, 11U, 20U}) rows.push_back(r);
    Eigen::VectorXd values(static_cast<Eigen::Index>(rows.size()));
    for (Eigen::Index i = 0; i < values.size(); ++i)
      values[i] = std::sin(rows[static_cast<std::size_t>(i)]);
    const Eigen::VectorXd x = IT::interpolate_harmonically(t, rows, values);
    EXPECT_GE(x.minCoeff(), values.minCoeff());
    EXPECT_LE(x.maxCoeff(), values.maxCoeff());
    for (std::size_t i = 0; i < rows.size(); ++i)
      EXPECT_EQ(x[rows[i]], values[static_cast<Eigen::Index>(i)]);
  }
}

} // namespace editing

} // namespace
