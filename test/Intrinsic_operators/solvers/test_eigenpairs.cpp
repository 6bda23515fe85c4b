// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Following.h"
#include "operator_test_meshes.h"
#include "uneven_laplacians.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/surface_modes.h>
#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_operators/solvers/eigenpairs.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

namespace eigenpairs {

using namespace operator_test;
using namespace uneven_laplacians;

// On the torus of n x n unit squares the cotangent Laplacian is the five point stencil, with
// eigenvalues 4 sin^2(pi p / n) + 4 sin^2(pi q / n), and every vertex has mass one.
std::vector<double> eigenvalues_of_stencil(unsigned n) {
  std::vector<double> values;
  for (unsigned p = 0; p < n; ++p)
    for (unsigned q = 0; q < n; ++q) {
      const double a = std::sin(std::numbers::pi * p / n), b = std::sin(std::numbers::pi * q / n);
      values.push_back(4 * (a * a + b * b));
    }
  std::sort(values.begin(), values.end());
  return values;
}

TEST(Eigenpairs, of_a_flat_torus_are_those_of_the_stencil) {
  for (const auto& [n, asked] :
       {std::pair{3U, 9}, {8U, 9}, {20U, 1}, {20U, 3}, {20U, 9}, {20U, 50}, {33U, 40}}) {
    const Exact t(torus(n, 0));
    const Matrix l = IT::cotangent_laplacian(t), m = IT::lumped_mass_matrix(t);
    const Eigen::Index count = std::min<Eigen::Index>(asked, l.rows());
    const IT::Eigenpairs pairs = IT::smallest_eigenpairs(l, m, count);
    const std::vector<double> values = eigenvalues_of_stencil(n);
    ASSERT_EQ(pairs.values.size(), count);
    // inverted with a shift of about 1 / (2 n^2), values of at most 8 keep all but this of their digits
    const double error = 1e-13 * 8 * n * n;
    for (Eigen::Index i = 0; i < count; ++i)
      EXPECT_NEAR(pairs.values[i], values[static_cast<std::size_t>(i)], error) << n << ' ' << i;
    const Eigen::MatrixXd products = pairs.vectors.transpose() * m * pairs.vectors;
    EXPECT_LE((products - Eigen::MatrixXd::Identity(count, count)).norm(), 1e-10) << n;
    const Eigen::MatrixXd residual =
        l * pairs.vectors - m * pairs.vectors * pairs.values.asDiagonal();
    EXPECT_LE(residual.norm(), error) << n;
  }
}

// A sphere of micrometres in metres has masses of 1e-12; scaling by powers of two changes no digit.
TEST(Eigenpairs, do_not_depend_on_units) {
  const Exact t(torus(20, 0));
  const Matrix l = IT::cotangent_laplacian(t), m = IT::lumped_mass_matrix(t);
  const IT::Eigenpairs one = IT::smallest_eigenpairs(l, m, 9);
  for (const int k : {-400, -60, -30, 30, 60, 400}) {
    const double root = std::ldexp(1., k);
    const IT::Eigenpairs scaled = IT::smallest_eigenpairs(l, Matrix(root * root * m), 9);
    for (Eigen::Index i = 0; i < 9; ++i)
      EXPECT_EQ(scaled.values[i] * root * root, one.values[i]) << k << ' ' << i;
    EXPECT_EQ(scaled.vectors * root, one.vectors) << k;
  }
}

// Triangles that are nearly a line have eigenvalues of 1e22 and more, beside which rounding takes
// zero for any other.
TEST(Eigenpairs, of_slivers_begin_with_zero) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-1, 1), exponent(-15, -3);
  for (int k = 0; k < 40; ++k) {
    Shape s{{}, {{0, 1, 2}}};
    for (int i = 0; i < 3; ++i)
      s.points.push_back({i + 0.4 * place(random), std::pow(10, exponent(random)), 0});
    const Exact t(s.input(IT::Mollification::automatic));
    const Matrix l = IT::cotangent_laplacian(t), m = IT::lumped_mass_matrix(t);
    const IT::Eigenpairs pairs = IT::smallest_eigenpairs(l, m, 1);
    EXPECT_EQ(pairs.values[0], 0) << k;
    const Eigen::VectorXd x = pairs.vectors.col(0);
    EXPECT_EQ(x.maxCoeff(), x.minCoeff()) << k;
    EXPECT_NEAR(x.dot(m * x), 1, 1e-14) << k;
  }
}

// Of a triangle with masses A / 3 the eigenvalues are 0, a and b: a b = 27 / (4 A^2), as sums of
// products of cotangents are one, and a + b = (3 / A) (sum of cotangents) = 3 (sum of squared
// sides) / (4 A^2). Thin ones have a near 1 and b near 1 / A^2: beyond 1e15, a is rounding's.
TEST(Eigenpairs, of_slivers_are_right_to_a_digit_or_refused) {
  constexpr unsigned seed = 8;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1, 1), exponent(-11, 0);
  int refused = 0;
  for (int k = 0; k < 200; ++k) {
    const double x = 1 + 0.4 * place(random), height = std::pow(10, exponent(random));
    const Shape s{{{0, 0, 0}, {x, height, 0}, {2, 0, 0}}, {{0, 1, 2}}};
    const Exact t(s.input());
    const Matrix l = IT::cotangent_laplacian(t), m = IT::lumped_mass_matrix(t);
    const double squares = x * x + (2 - x) * (2 - x) + 2 * height * height + 4;
    const double sum = 3 * squares / (4 * height * height), product = 27 / (4 * height * height);
    const double greater = (sum + std::sqrt(sum * sum - 4 * product)) / 2;
    try {
      const IT::Eigenpairs pairs = IT::smallest_eigenpairs(l, m, 2);
      EXPECT_NEAR(pairs.values[1], product / greater, 0.1 * product / greater) << seed << ' ' << k;
    } catch (const std::runtime_error&) {
      ++refused;
      EXPECT_LT(height, 1e-5) << seed << ' ' << k;
    }
  }
  EXPECT_GT(refused, 20);
}

TEST(Eigenpairs, count_components_by_zeros) {
  const Shape two = two_tetrahedra();
  const Exact t(two.input());
  const IT::Eigenpairs pairs =
      IT::smallest_eigenpairs(IT::cotangent_laplacian(t), IT::lumped_mass_matrix(t), 8);
  // a regular tetrahedron: weights 1 / sqrt 3, masses A / 4 with A = 4 sqrt 3 / 4 * 8, so 4 / sqrt 3 / (2 sqrt 3) = 2 / 3
  for (Eigen::Index i = 0; i < 8; ++i) EXPECT_NEAR(pairs.values[i], i < 2 ? 0 : 2. / 3, 1e-13) << i;
}

// The number of eigenvalues below x, by Sylvester's law: that of the negative pivots of l - x m, to 100 digits; the diagonal of `l` is minus the sum of the row.
int eigenvalues_below(const Matrix& l, const Matrix& m, const Precise& x) {
  const Eigen::Index n = l.rows();
  std::vector<std::vector<Precise>> a(static_cast<std::size_t>(n));
  for (std::vector<Precise>& row : a) row.resize(static_cast<std::size_t>(n), 0);
  const auto at = [&a](Eigen::Index i, Eigen::Index j) -> Precise& {
    return a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  };
  for (int c = 0; c < n; ++c) {
    at(c, c) -= x * m.coeff(c, c);
    for (Matrix::InnerIterator i(l, c); i; ++i) {
      if (i.row() == c) continue;
      at(i.row(), c) = i.value();
      at(c, c) -= i.value();
    }
  }
  int negative = 0;
  for (Eigen::Index k = 0; k < n; ++k) {
    negative += at(k, k) < 0 ? 1 : 0;
    for (Eigen::Index i = k + 1; i < n; ++i) {
      if (at(i, k) == 0) continue;
      const Precise factor = at(i, k) / at(k, k);
      for (Eigen::Index j = k + 1; j < n; ++j) at(i, j) -= factor * at(k, j);
    }
  }
  return negative;
}

/// Weights as of needles and caps make the trace, and rounding of the diagonal, greater than the
/// wanted eigenvalues.
TEST(Eigenpairs, are_right_beside_great_weights) {
  for (const double greatest : {1., 1e7, 1e12, 1e15}) {
    const auto [l, m] = uneven_grid(9, greatest);
    constexpr Eigen::Index count = 5;
    const IT::Eigenpairs pairs = IT::smallest_eigenpairs(l, m, count);
    EXPECT_NEAR(pairs.values[0], 0, 1e-12 * pairs.values[1]) << greatest;
    for (Eigen::Index i = 1; i < count; ++i) {
      EXPECT_LE(eigenvalues_below(l, m, pairs.values[i] * Precise(1 - 1e-9)), i) << greatest;
      EXPECT_GT(eigenvalues_below(l, m, pairs.values[i] * Precise(1 + 1e-9)), i) << greatest;
    }
  }
}

/// Square grids with weights 1, in a chain that weak edges join.
Eigen::SparseMatrix<double> chain_of_grids(int grids, int n, double weight) {
  const int rows = grids * n * n;
  std::vector<Eigen::Triplet<double>> entries;
  const auto join = [&](int i, int j, double w) {
    entries.insert(entries.end(), {{i, j, -w}, {j, i, -w}, {i, i, w}, {j, j, w}});
  };
  for (int v = 0; v < rows; ++v) {
    const int x = v % n, y = v / n % n;
    if (x + 1 < n) join(v, v + 1, 1);
    if (y + 1 < n) join(v, v + n, 1);
    if (v % (n * n) == 0 && v > 0) join(v - 1, v, weight);
  }
  Eigen::SparseMatrix<double> l(rows, rows);
  l.setFromTriplets(entries.begin(), entries.end());
  return l;
}

TEST(Eigenpairs, beyond_a_cluster_of_small_ones_are_right_or_refused) {
  // those of one grid, of which the smallest but zero is that of a path of 12 vertices, twice
  const double first = 2 - 2 * std::cos(std::numbers::pi / 12);
  for (const auto& [grids, weight] :
       {std::pair(9, 1e-6), {9, 1e-8}, {20, 1e-6}, {9, 1e-14}, {12, 1e-18}}) {
    const Eigen::SparseMatrix<double> l = chain_of_grids(grids, 12, weight);
    Eigen::SparseMatrix<double> m(l.rows(), l.rows());
    m.setIdentity();
    IT::Eigenpairs pairs;
    try {
      pairs = IT::smallest_eigenpairs(l, m, grids + 2);
    } catch (const std::runtime_error&) {
      EXPECT_LT(weight, 1e-10) << grids; // sixteen digits from the others
      continue;
    }
    for (int i = 0; i < grids; ++i)
      EXPECT_LT(pairs.values[i], 4 * weight) << grids << ' ' << weight;
    for (int i = grids; i < grids + 2; ++i)
      EXPECT_NEAR(pairs.values[i], first, 8 * weight + 1e-12) << grids << ' ' << weight;
  }
}

// Multiple ones, too, and those of several components; constants have exactly the value zero.
TEST(Eigenpairs, by_iteration_are_those_of_the_stencil) {
  for (const auto& [n, count] : {std::pair{20U, 1}, {20U, 9}, {33U, 40}}) {
    const Exact t(torus(n, 0));
    const Matrix l = IT::cotangent_laplacian(t), m = IT::lumped_mass_matrix(t);
    const IT::Eigenpairs pairs = IT::smallest_eigenpairs(l, m, count, IT::Linear_solver::iterative);
    const std::vector<double> values = eigenvalues_of_stencil(n);
    ASSERT_EQ(pairs.values.size(), count);
    EXPECT_EQ(pairs.values[0], 0);
    for (Eigen::Index i = 0; i < count; ++i)
      EXPECT_NEAR(pairs.values[i], values[static_cast<std::size_t>(i)], 1e-12) << n << ' ' << i;
    const Eigen::MatrixXd products = pairs.vectors.transpose() * m * pairs.vectors;
    EXPECT_LE((products - Eigen::MatrixXd::Identity(count, count)).norm(), 1e-12) << n;
    const Eigen::MatrixXd residual =
        l * pairs.vectors - m * pairs.vectors * pairs.values.asDiagonal();
    for (Eigen::Index i = 0; i < count; ++i)
      EXPECT_LE(residual.col(i).norm(), 1e-8 * pairs.values[i] + 1e-14) << n << ' ' << i;
  }
  const Exact two(beside(rough_torus(12, 0.2, 1), rough_torus(12, 0.3, 2), 30).input());
  const Matrix l = IT::cotangent_laplacian(two), m = IT::galerkin_mass_matrix(two);
  const IT::Eigenpairs exact = IT::smallest_eigenpairs(l, m, 8, IT::Linear_solver::direct),
                       found = IT::smallest_eigenpairs(l, m, 8, IT::Linear_solver::iterative);
  EXPECT_EQ(found.values[1], 0);
  EXPECT_LE((found.values - exact.values).norm(), 1e-11 * exact.values[7]);
}

// A weak edge makes smoothed random vectors nearly dependent, and an eigenvalue whose residual, as
// it is asked for, is below rounding.
TEST(Eigenpairs, by_iteration_are_right_where_rounding_is_great) {
  struct Case {
    int grids, n, count;
    double weight;
  };
  for (const auto& [grids, n, count, weight] :
       {Case{1, 9, 5, 1}, {2, 20, 5, 1e-6}, {2, 20, 5, 1e-9}, {9, 12, 10, 1e7}}) {
    const Eigen::SparseMatrix<double> l = chain_of_grids(grids, n, weight);
    Eigen::SparseMatrix<double> m(l.rows(), l.rows());
    m.setIdentity();
    const auto direct = IT::Linear_solver::direct, iterative = IT::Linear_solver::iterative;
    const Eigen::VectorXd exact = IT::smallest_eigenpairs(l, m, count, direct).values,
                          found = IT::smallest_eigenpairs(l, m, count, iterative).values;
    EXPECT_LE((found - exact).norm(), 1e-9 * exact[count - 1]) << grids << ' ' << count;
  }
}

TEST(Eigenpairs, can_be_followed_and_cancelled) {
  const Exact t(torus(20, 0));
  const Matrix l = IT::cotangent_laplacian(t), m = IT::lumped_mass_matrix(t);
  std::size_t calls = 0;
  const auto count = IT::parameters::visitor(Following{[&](std::size_t solutions) {
    EXPECT_EQ(solutions, calls);
    ++calls;
    return true;
  }});
  const IT::Eigenpairs all = IT::smallest_eigenpairs(l, m, 6, count);
  EXPECT_EQ(all.status, IT::Status::done);
  EXPECT_GT(calls, 6U);
  EXPECT_EQ(all.values, IT::smallest_eigenpairs(l, m, 6).values);
  const Following third{[](std::size_t k) { return k < 3; }};
  EXPECT_EQ(
      IT::smallest_eigenpairs(l, m, 6, IT::Linear_solver::iterative, IT::parameters::visitor(third))
          .status,
      IT::Status::cancelled);
  for (const std::size_t last : {std::size_t{0}, calls / 2, calls - 1}) {
    const Following stop{[last](std::size_t k) { return k < last; }};
    const IT::Eigenpairs none = IT::smallest_eigenpairs(l, m, 6, IT::parameters::visitor(stop));
    EXPECT_EQ(none.status, IT::Status::cancelled);
    EXPECT_EQ(none.values.size(), 0);
    EXPECT_EQ(none.vectors.cols(), 0);
  }
}

// One edge has nearly all of the trace, so that the first shift is far too great: the search for another takes solutions first.
TEST(Eigenpairs, can_be_cancelled_before_there_is_a_shift) {
  const Exact t(torus(20, 0));
  Matrix l = IT::cotangent_laplacian(t);
  for (const int i : {0, 1}) {
    l.coeffRef(i, i) += 1e12;
    l.coeffRef(i, 1 - i) -= 1e12;
  }
  const Matrix m = IT::lumped_mass_matrix(t);
  for (const std::size_t last : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
    std::size_t calls = 0;
    const Following stop{[&](std::size_t k) {
      calls = k + 1;
      return k < last;
    }};
    EXPECT_EQ(IT::smallest_eigenpairs(l, m, 6, IT::parameters::visitor(stop)).status,
              IT::Status::cancelled);
    EXPECT_EQ(calls, last + 1);
  }
}

TEST(Eigenpairs, without_edges_are_zeros) {
  for (const int size : {1, 20, 200}) {
    const Matrix zero(size, size);
    Eigen::SparseMatrix<double> lumped(size, size), chain(size, size);
    for (int i = 0; i < size; ++i) {
      lumped.insert(i, i) = 1 + i;
      chain.insert(i, i) = 4;
      if (i > 0) chain.coeffRef(i, i - 1) = chain.coeffRef(i - 1, i) = 1;
    }
    for (const auto& m : {lumped, chain})
      for (const int count : {0, 1, std::min(size, 9), size}) {
        const IT::Eigenpairs pairs = IT::smallest_eigenpairs(zero, m, count);
        EXPECT_EQ(pairs.values, Eigen::VectorXd::Zero(count));
        const Eigen::MatrixXd products = pairs.vectors.transpose() * m * pairs.vectors;
        EXPECT_LE((products - Eigen::MatrixXd::Identity(count, count)).norm(), 1e-12) << size;
      }
    lumped.coeffRef(size - 1, size - 1) = 0;
    EXPECT_THROW(IT::smallest_eigenpairs(zero, lumped, 1), IT::Indefinite_matrix);
  }
}

// One edge among many isolated vertices: zeros but one.
TEST(Eigenpairs, of_one_edge_are_zeros_and_its_own) {
  Eigen::SparseMatrix<double> l(100, 100), m(100, 100);
  m.setIdentity();
  for (const int i : {40, 70}) l.insert(i, i) = 3;
  l.insert(40, 70) = l.insert(70, 40) = -3;
  l.makeCompressed();
  const IT::Eigenpairs pairs = IT::smallest_eigenpairs(l, m, 5);
  EXPECT_LE(pairs.values.cwiseAbs().maxCoeff(), 1e-12);
}

// The modes are those of the matrices; an isolated vertex has none.
TEST(Surface_modes, are_eigenpairs_of_the_matrices_without_isolated_vertices) {
  const Exact t(torus(20, 0));
  const Matrix l = IT::cotangent_laplacian(t), m = IT::lumped_mass_matrix(t);
  EXPECT_EQ(IT::surface_modes(t, 5).vectors, IT::smallest_eigenpairs(l, m, 5).vectors);
  Shape cubes = cube();
  cubes.points.push_back({9, 9, 9});
  const Exact isolated(cubes.input());
  const IT::Eigenpairs all = IT::surface_modes(isolated, 100);
  ASSERT_EQ(all.values.size(), 8);
  EXPECT_LE(std::abs(all.values[0]), 1e-12);
  EXPECT_GT(all.values[1], 0.1);
  EXPECT_EQ(all.vectors.row(8).norm(), 0);
  EXPECT_THROW(IT::surface_modes(Exact(torus(32, 0)), 1025), IT::Invalid_input); // has 1024
}

TEST(Eigenpairs, refuses_what_makes_no_sense) {
  const Exact t(torus(9, 0));
  const Matrix l = IT::cotangent_laplacian(t), m = IT::lumped_mass_matrix(t);
  EXPECT_THROW(IT::smallest_eigenpairs(l, m, 82), std::invalid_argument);
  EXPECT_THROW(IT::smallest_eigenpairs(l, Matrix(3, 3), 1), std::invalid_argument);
  EXPECT_THROW(IT::smallest_eigenpairs(l, Matrix(81, 81), 1), std::exception); // no mass
}

} // namespace eigenpairs

} // namespace
