// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Chosen_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_operators/solvers/Multigrid_factorization.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

namespace multigrid_factorizations {

namespace IT = CGAL::Intrinsic_triangulations;
using Matrix = Eigen::SparseMatrix<double>;
using Complex_matrix = Eigen::SparseMatrix<std::complex<double>>;
using Multigrid = IT::Multigrid_factorization<double>;

static_assert(IT::Factorization<Multigrid>);
static_assert(IT::Factorization<IT::Multigrid_factorization<std::complex<double>>>);

// Squares with a diagonal each, in a rectangle; with a mass at each vertex.
template <class Weight>
Matrix grid_matrix(int n, double mass, const Weight& weight) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto join = [&](int i, int j) {
    const double w = weight();
    entries.emplace_back(i, j, -w);
    entries.emplace_back(j, i, -w);
    entries.emplace_back(i, i, w);
    entries.emplace_back(j, j, w);
  };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const int v = n * y + x;
      entries.emplace_back(v, v, mass);
      if (x + 1 < n) join(v, v + 1);
      if (y + 1 < n) join(v, v + n);
      if (x + 1 < n && y + 1 < n) join(v, v + n + 1);
    }
  Matrix m(n * n, n * n);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}
Matrix grid_matrix(int n, double mass) {
  return grid_matrix(n, mass, [] { return 1.; });
}

// The same matrix in a frame that is turned at each row.
Complex_matrix turned(const Matrix& a, std::mt19937& random) {
  std::uniform_real_distribution<double> angle(0, 2 * std::numbers::pi);
  Eigen::VectorXcd frame(a.rows());
  for (auto& f : frame) f = std::polar(1., angle(random));
  Complex_matrix result = a.cast<std::complex<double>>();
  for (int c = 0; c < result.cols(); ++c)
    for (Complex_matrix::InnerIterator i(result, c); i; ++i)
      i.valueRef() *= std::conj(frame[i.row()]) * frame[c];
  return result;
}

TEST(Multigrid_factorization, solves_as_a_factorization) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(-3, 3);
  for (const int n : {1, 2, 9, 40, 90})
    for (const double mass : {1., 1e-3}) {
      const Matrix a = grid_matrix(n, mass, [&] { return std::pow(10, exponent(random)); });
      const Eigen::MatrixXd b = Eigen::MatrixXd::Random(a.rows(), 2);
      const Multigrid multigrid(a);
      EXPECT_EQ(multigrid.size(), a.rows());
      const Eigen::MatrixXd x = multigrid.solve(b);
      EXPECT_LE((a * x - b).norm(), 2e-10 * b.norm());
      const Eigen::MatrixXd expected = IT::Cholesky_factorization(a).solve(b);
      EXPECT_LE((x - expected).norm(), 1e-6 * expected.norm()) << n;
    }
}

// On surfaces twice as fine as others, too.
TEST(Multigrid_factorization, takes_few_steps_at_any_size) {
  std::mt19937 random(4);
  for (const int n : {40, 80, 160}) {
    const Matrix a = grid_matrix(n, 1e-6);
    const Eigen::VectorXd b = Eigen::VectorXd::Random(a.rows());
    IT::Iterations steps, of_turned;
    Multigrid(a).solve(b, steps);
    EXPECT_LE(steps.most, 22) << n;
    EXPECT_LE(steps.residual, 1e-10);
    const Complex_matrix t = turned(a, random);
    const Eigen::VectorXcd right = Eigen::VectorXcd::Random(a.rows());
    const Eigen::VectorXcd x = IT::Multigrid_factorization(t).solve(right, of_turned);
    EXPECT_LE((t * x - right).norm(), 2e-10 * right.norm());
    EXPECT_LE(of_turned.most, 25) << n;
  }
}

// Two pieces without masses, and an isolated row.
TEST(Multigrid_factorization, projects_constants_out_of_components) {
  const int n = 50, size = n * n;
  const Matrix piece = grid_matrix(n, 0);
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < size; ++c)
    for (Matrix::InnerIterator i(piece, c); i; ++i)
      for (const int first : {0, size})
        entries.emplace_back(first + static_cast<int>(i.row()), first + c, i.value());
  Matrix a(2 * size + 1, 2 * size + 1);
  a.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd b = Eigen::VectorXd::Random(a.rows());
  EXPECT_THROW(Multigrid(a).solve(b), std::invalid_argument);
  for (const int first : {0, size}) b.segment(first, size).array() -= b.segment(first, size).mean();
  b[2 * size] = 0;
  const Eigen::VectorXd x = Multigrid(a).solve(b);
  EXPECT_LE((a * x - b).norm(), 1e-9 * b.norm());
  EXPECT_NEAR(x.head(size).mean(), 0, 1e-9);
  EXPECT_NEAR(x.segment(size, size).mean(), 0, 1e-9);
  EXPECT_EQ(x[2 * size], 0);
}

// Right sides may miss the sum zero by rounding, and more than the residual that is asked for.
TEST(Multigrid_factorization, solves_right_sides_that_nearly_sum_to_zero) {
  const Matrix a = grid_matrix(60, 0);
  Eigen::VectorXd b = Eigen::VectorXd::Random(a.rows());
  b.array() -= b.mean();
  for (const double part : {1e-13, 1e-10, 1e-9, 1e-8}) {
    const Eigen::VectorXd shifted = b.array() + part * b.norm() / 60;
    IT::Iterations steps;
    const Eigen::VectorXd x = Multigrid(a).solve(shifted, steps);
    EXPECT_EQ(steps.status, IT::Status::done) << part;
    EXPECT_LE((a * x - b).norm(), 2e-10 * b.norm()) << part;
  }
}

// In the sum of weights and these masses, rounding changes masses by more than 1e-7; and constants
// are large beside the right side, but do not hide the residual.
TEST(Multigrid_factorization, finds_constants_with_masses_near_the_rounding_of_weights) {
  const Matrix laplacian = grid_matrix(50, 0);
  for (const double mass : {1e-3, 1e-9}) {
    const Eigen::VectorXd masses = Eigen::VectorXd::LinSpaced(laplacian.rows(), mass, 5 * mass);
    const Eigen::VectorXd x = Multigrid(laplacian, masses).solve(masses);
    EXPECT_LE((x.array() - 1).abs().maxCoeff(), 1e-9) << mass;
  }
  EXPECT_THROW(Multigrid(laplacian, Eigen::VectorXd::Ones(5)), std::invalid_argument);
}

// Rows without connections are in no group, so that groups of the others stay as few.
TEST(Multigrid_factorization, takes_few_steps_where_most_rows_are_fixed) {
  constexpr int n = 120;
  const auto is_fixed = [](Eigen::Index v) { return v / n <= 2 * n / 3 || v % n == 0; };
  Matrix m = grid_matrix(n, 1);
  m.prune([&](Eigen::Index i, Eigen::Index j, double) {
    return i == j || (!is_fixed(i) && !is_fixed(j));
  });
  const Eigen::VectorXd b = Eigen::VectorXd::Random(m.rows());
  IT::Iterations steps;
  const Eigen::VectorXd x = Multigrid(m).solve(b, steps);
  EXPECT_LE((m * x - b).norm(), 2e-10 * b.norm());
  EXPECT_LE(steps.most, 22);
}

TEST(Multigrid_factorization, refuses_what_it_cannot_solve) {
  const Matrix good = grid_matrix(40, 1);
  EXPECT_THROW(Multigrid(Matrix(3, 4)), std::invalid_argument);
  Matrix bad = good;
  bad.coeffRef(5, 5) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Multigrid{bad}, std::invalid_argument);
  bad.coeffRef(5, 5) = -1;
  EXPECT_THROW(Multigrid{bad}, IT::Indefinite_matrix);
  for (const double tolerance : {0., 2., std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(Multigrid(good, tolerance), std::invalid_argument);
  const Multigrid multigrid(good);
  Eigen::VectorXd b = Eigen::VectorXd::Ones(1600);
  EXPECT_THROW(multigrid.solve(Eigen::VectorXd(b.head(7))), std::invalid_argument);
  b[3] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(multigrid.solve(b), std::invalid_argument);
  EXPECT_EQ(multigrid.solve(Eigen::VectorXd(Eigen::VectorXd::Zero(1600))).norm(), 0);
  EXPECT_EQ(Multigrid(Matrix(0, 0)).size(), 0);
}

// Between the eigenvalues of the grid: no diagonal entry shows it.
TEST(Multigrid_factorization, of_an_indefinite_matrix_says_so) {
  Matrix a = grid_matrix(60, -1);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(a.rows());
  EXPECT_THROW(Multigrid(a).solve(b), std::runtime_error);
}

// Rounding of the entries leaves a residual far above the least tolerance: the solution is 1e9.
TEST(Multigrid_factorization, never_returns_a_wrong_solution_silently) {
  std::mt19937 random(5);
  const Complex_matrix a = turned(grid_matrix(60, 1e-9), random);
  const Eigen::VectorXcd b = Eigen::VectorXcd::Ones(a.rows());
  const IT::Multigrid_factorization<std::complex<double>> multigrid(a, 1e-14);
  IT::Iterations iterations;
  multigrid.solve(b, iterations);
  EXPECT_EQ(iterations.status, IT::Status::cap);
  EXPECT_GT(iterations.residual, 1e-14);
  try {
    multigrid.solve(b);
    ADD_FAILURE();
  } catch (const IT::No_convergence& error) {
    EXPECT_EQ(error.iterations().residual, iterations.residual);
  }
}

// An automatic choice where rounding keeps the iteration from 1e-14: the factor takes over, and the
// iteration is not tried again.
template <class Scalar>
void expect_factor_after_iteration(const Eigen::SparseMatrix<Scalar>& a) {
  using Chosen = IT::internal::Chosen_factorization<Scalar>;
  using Vectors = typename Chosen::Vectors;
  int factors = 0;
  const auto factored = [&] {
    ++factors;
    return Chosen(IT::Cholesky_factorization<Scalar>(a));
  };
  Vectors b(a.rows(), 2);
  for (Eigen::Index i = 0; i < b.size(); ++i) b(i) = 1 + std::cos(double(i));
  const IT::internal::Iteration_or_factor<Scalar> coarse(
      IT::Multigrid_factorization<Scalar>(a, 1e-6), factored);
  const Vectors rough = coarse.solve(b);
  EXPECT_EQ(factors, 0);
  EXPECT_LE((a * rough - b).norm(), 2e-6 * b.norm());
  const IT::internal::Iteration_or_factor<Scalar> fine(
      IT::Multigrid_factorization<Scalar>(a, 1e-14), factored);
  EXPECT_EQ(fine.size(), a.rows());
  const auto copy = fine; // shares the factor
  const Vectors x = fine.solve(b);
  EXPECT_EQ(factors, 1);
  EXPECT_EQ(copy.solve(b), x);
  EXPECT_EQ(factors, 1);
  EXPECT_LE((rough - x).norm(), 1e-3 * x.norm());
  EXPECT_EQ(x, Vectors(IT::Cholesky_factorization<Scalar>(a).solve(b)));
}

TEST(Chosen_factorization, factors_once_where_the_iteration_does_not_converge) {
  std::mt19937 random(5);
  expect_factor_after_iteration<double>(grid_matrix(60, 1e-9));
  expect_factor_after_iteration<std::complex<double>>(turned(grid_matrix(60, 1e-9), random));
}

// Linear functions are harmonic on a grid of squares.
TEST(Multigrid_factorization, solves_with_fixed_values) {
  const int n = 60;
  const Matrix a = grid_matrix(n, 0);
  std::vector<std::uint32_t> rows;
  for (int v = 0; v < n * n; ++v)
    if (v < n || v >= n * (n - 1) || v % n == 0 || v % n == n - 1)
      rows.push_back(static_cast<std::uint32_t>(v));
  const auto linear = [](int v) { return v % n + 2. * (v / n); };
  Eigen::VectorXd values(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    values[static_cast<Eigen::Index>(i)] = linear(static_cast<int>(rows[i]));
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(n * n);
  for (const auto solver :
       {IT::Linear_solver::automatic, IT::Linear_solver::direct, IT::Linear_solver::iterative}) {
    const Eigen::VectorXd x = IT::solve_with_fixed_values(a, zero, rows, values, solver);
    for (int v = 0; v < n * n; ++v) EXPECT_NEAR(x[v], linear(v), 1e-7);
  }
}

TEST(Linear_solver, is_chosen_by_size_and_number_of_right_sides) {
  using enum IT::Linear_solver;
  EXPECT_EQ(IT::solver_for(999'999, 1), direct);
  EXPECT_EQ(IT::solver_for(1'000'000, 3), iterative);
  EXPECT_EQ(IT::solver_for(1'000'000, 4), direct);
  EXPECT_EQ(IT::solver_for(1'000'000), direct);
  EXPECT_EQ(IT::solver_for(5'000'001), iterative);
  EXPECT_EQ(IT::solver_named("auto"), automatic);
  EXPECT_EQ(IT::solver_named("direct"), direct);
  EXPECT_EQ(IT::solver_named("iterative"), iterative);
  EXPECT_THROW(IT::solver_named("fast"), std::invalid_argument);
}

} // namespace multigrid_factorizations

} // namespace
