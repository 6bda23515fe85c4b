// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "operator_test_meshes.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>

#include <Eigen/SparseCholesky>

#include <gtest/gtest.h>

#include <complex>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

namespace {

namespace factorizations {

using namespace operator_test;
using Complex_matrix = Eigen::SparseMatrix<std::complex<double>>;

// The Laplacian of an n x n grid of squares with natural border, from its definition, with a phase along each edge to the right,
// which makes a Hermitian matrix with the same eigenvalues: a change of frames.
Complex_matrix grid_laplacian(int n, double shift, double phase) {
  std::vector<Eigen::Triplet<std::complex<double>>> entries;
  const auto connect = [&](int i, int j, std::complex<double> r) {
    entries.emplace_back(i, i, 1);
    entries.emplace_back(j, j, 1);
    entries.emplace_back(i, j, -std::conj(r));
    entries.emplace_back(j, i, -r);
  };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const int v = n * y + x;
      entries.emplace_back(v, v, shift);
      if (x + 1 < n) connect(v, v + 1, std::polar(1., phase));
      if (y + 1 < n) connect(v, v + n, 1);
    }
  Complex_matrix m(n * n, n * n);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

// Both sides of the size from which another library may factor.
TEST(Cholesky_factorization, solves_small_and_large_systems) {
  for (const int n : {1, 2, 30, 320}) {
    const Complex_matrix h = grid_laplacian(n, 0.5, 0.7);
    const Matrix a = grid_laplacian(n, 0.5, 0).real();
    // the condition is at most (8 + 0.5) / 0.5, and a row of a product has five terms
    const double error = 17 * 64 * std::numeric_limits<double>::epsilon();
    const Eigen::MatrixXd b = Eigen::MatrixXd::Random(n * n, 2);
    EXPECT_LE((a * IT::Cholesky_factorization(a).solve(b) - b).norm(), error * b.norm()) << n;
    const Eigen::VectorXcd c = Eigen::VectorXcd::Random(n * n);
    const Eigen::VectorXcd x = IT::Cholesky_factorization(h).solve(c);
    EXPECT_LE((h * x - c).norm(), error * c.norm()) << n;
  }
}

/// The row that an error names; -1 if there is none.
template <class Factor>
Eigen::Index indefinite_row(const Factor& factor) {
  try {
    factor();
  } catch (const IT::Indefinite_matrix& e) {
    return e.row();
  }
  return -1;
}

TEST(Cholesky_factorization, names_a_row_of_what_is_not_definite) {
  const Matrix singular = grid_laplacian(3, 0, 0).real();
  EXPECT_THROW(IT::Cholesky_factorization{singular}, IT::Indefinite_matrix);
  for (const int n : {3, 320}) {
    Matrix a = grid_laplacian(n, 0.5, 0).real();
    a.coeffRef(2, 2) = -1;
    const Eigen::Index row = indefinite_row([&a] { IT::Cholesky_factorization{a}; });
    EXPECT_TRUE(row >= 0 && row < a.rows()) << row;
  }
  // only one row can be named
  Matrix diagonal = grid_laplacian(1, 1, 0).real();
  diagonal.coeffRef(0, 0) = 0;
  EXPECT_EQ(indefinite_row([&] { IT::Cholesky_factorization{diagonal}; }), 0);
}

TEST(Cholesky_factorization, refuses_what_makes_no_sense) {
  EXPECT_THROW(IT::Cholesky_factorization{Matrix(2, 3)}, std::invalid_argument);
  Matrix a = grid_laplacian(2, 1, 0).real();
  EXPECT_THROW(IT::Cholesky_factorization(a).solve(Eigen::VectorXd::Ones(5)),
               std::invalid_argument);
  a.coeffRef(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(IT::Cholesky_factorization{a}, std::invalid_argument);
}

// A Hermitian matrix with some random entries in each row, whose eigenvalues are between 1 and 2 n:
// its diagonal exceeds the sum of the magnitudes of the other entries of a row by one.
Complex_matrix random_hermitian(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> d(-1, 1);
  Eigen::MatrixXcd dense = Eigen::MatrixXcd::Zero(n, n);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < 3; ++k) {
      const int j = static_cast<int>(random() % static_cast<unsigned>(n));
      const std::complex<double> z(d(random), d(random));
      if (i == j) continue;
      dense(i, j) = z;
      dense(j, i) = std::conj(z);
    }
  for (int i = 0; i < n; ++i) dense(i, i) = 1 + dense.row(i).cwiseAbs().sum();
  return dense.sparseView();
}

TEST(Cholesky_factorization, of_hermitian_matrices_agrees_with_eigen) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const int n = 1 + static_cast<int>(seed) * 13;
    const Complex_matrix h = random_hermitian(n, seed);
    const Eigen::MatrixXcd b = Eigen::MatrixXcd::Random(n, 3);
    const Eigen::MatrixXcd x = IT::Cholesky_factorization(h).solve(b);
    const Eigen::SimplicialLDLT<Complex_matrix> other(h);
    // both are backward stable: errors of n roundings times the condition, which is at most the
    // greatest eigenvalue, for each
    const double condition = 2 * h.diagonal().real().maxCoeff();
    const double error = 2 * condition * n * std::numeric_limits<double>::epsilon();
    EXPECT_LE((x - other.solve(b)).norm(), error * x.norm()) << "seed " << seed;
    for (int c = 0; c < 3; ++c) // columns together, and alone
      EXPECT_EQ(x.col(c), IT::Cholesky_factorization(h).solve(b.col(c)));
  }
}

TEST(Cholesky_factorization, of_hermitian_matrices_reads_the_lower_triangle_only) {
  const Complex_matrix h = random_hermitian(80, 5), lower = h.triangularView<Eigen::Lower>();
  const Eigen::VectorXcd b = Eigen::VectorXcd::Random(80);
  EXPECT_EQ(IT::Cholesky_factorization(h).solve(b), IT::Cholesky_factorization(lower).solve(b));
}

TEST(Cholesky_factorization, names_a_row_of_hermitian_matrices_that_are_not_definite) {
  EXPECT_THROW(IT::Cholesky_factorization{grid_laplacian(3, 0, 0.7)}, IT::Indefinite_matrix);
  for (const int n : {3, 320}) {
    Complex_matrix h = grid_laplacian(n, 0.5, 0.7);
    h.coeffRef(2, 2) = -1;
    try {
      IT::Cholesky_factorization{h};
      ADD_FAILURE() << "nothing was thrown";
    } catch (const IT::Indefinite_matrix& e) {
      EXPECT_GE(e.row(), 0);
      EXPECT_LT(e.row(), h.rows());
    }
  }
  EXPECT_THROW(IT::Cholesky_factorization{Complex_matrix(2, 3)}, std::invalid_argument);
  Complex_matrix h = random_hermitian(4, 1);
  EXPECT_THROW(IT::Cholesky_factorization(h).solve(Eigen::VectorXcd::Ones(5)),
               std::invalid_argument);
  h.coeffRef(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(IT::Cholesky_factorization{h}, std::invalid_argument);
}

TEST(Cholesky_factorization, uses_the_analysis_of_a_matrix_with_entries_in_the_same_places) {
  const Complex_matrix h = grid_laplacian(30, 0.5, 0.7);
  const Matrix a = grid_laplacian(30, 0, 0).real();
  const Eigen::VectorXcd b = Eigen::VectorXcd::Random(900);
  IT::internal::Shared_analysis analysis;
  const IT::Laplacian_factorization real(a, Eigen::VectorXd::Ones(900), analysis);
  const auto kept = analysis;
  ASSERT_NE(kept, nullptr);
  EXPECT_EQ(IT::Cholesky_factorization<std::complex<double>>(h, analysis).solve(b),
            IT::Cholesky_factorization(h).solve(b));
  EXPECT_EQ(analysis, kept);
  EXPECT_THROW(
      (IT::Cholesky_factorization<std::complex<double>>(random_hermitian(900, 1), analysis)),
      std::invalid_argument);
}

TEST(Fixed_values_solver, solves_again_with_other_values) {
  const Exact t(grid(8).input());
  const Matrix l = IT::cotangent_laplacian(t);
  std::vector<std::uint32_t> border;
  for (std::uint32_t v = 0; v < 81; ++v)
    if (v % 9 == 0 || v % 9 == 8 || v / 9 == 0 || v / 9 == 8) border.push_back(v);
  for (const double sign : {1., -1.}) { // definite either way
    const IT::Fixed_values_solver solver(sign * l, border);
    for (const auto& [a, b] : {std::pair{1., 0.}, {2., -3.}}) { // linear functions are harmonic
      Eigen::VectorXd values(static_cast<Eigen::Index>(border.size())), all(81);
      for (std::uint32_t v = 0; v < 81; ++v) all[v] = a * (v % 9) + b * (v / 9);
      for (std::size_t i = 0; i < border.size(); ++i)
        values[static_cast<Eigen::Index>(i)] = all[border[i]];
      const Eigen::VectorXd x = solver.solve(Eigen::VectorXd::Zero(81), values);
      EXPECT_LE((x - all).norm(), 1024 * std::numeric_limits<double>::epsilon() * all.norm());
    }
  }
}

TEST(Fixed_values_solver, names_rows_of_the_whole_problem) {
  Eigen::MatrixXd a(4, 4); // without row 0 of rank two
  a << 9, 1, 1, 1, 1, 2, 1, 3, 1, 1, 4, 5, 1, 3, 5, 8;
  const std::vector<std::uint32_t> first{0};
  EXPECT_GE(indefinite_row([&] { IT::Fixed_values_solver(a.sparseView(), first); }), 1);
}

TEST(Fixed_values_solver, finds_components_with_constants_in_the_kernel) {
  Shape two = two_tetrahedra();
  two.points.push_back({0, 0, 20}); // isolated
  const Exact t(two.input());
  const Matrix l = IT::cotangent_laplacian(t);
  EXPECT_EQ(IT::rows_with_constant_kernel(l), (std::vector<std::uint32_t>{0, 4, 8}));
  EXPECT_TRUE(
      IT::rows_with_constant_kernel(l + 0.01 * Matrix(Eigen::MatrixXd::Identity(9, 9).sparseView()))
          .empty());
}

} // namespace factorizations

} // namespace
