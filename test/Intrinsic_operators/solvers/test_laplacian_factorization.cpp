// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

namespace laplacian_factorizations {

namespace IT = CGAL::Intrinsic_triangulations;
using Matrix = Eigen::SparseMatrix<double>;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct Edge {
  int i, j;
  double weight;
};

Matrix laplacian_of(int size, const std::vector<Edge>& edges) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const Edge& e : edges) {
    entries.emplace_back(e.i, e.j, -e.weight);
    entries.emplace_back(e.j, e.i, -e.weight);
    entries.emplace_back(e.i, e.i, e.weight);
    entries.emplace_back(e.j, e.j, e.weight);
  }
  Matrix m(size, size);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

// Squares with a diagonal each; weights as given.
template <class Weight>
Matrix grid_laplacian(int n, const Weight& weight) {
  std::vector<Edge> edges;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const int v = n * y + x;
      if (x + 1 < n) edges.push_back({v, v + 1, weight()});
      if (y + 1 < n) edges.push_back({v, v + n, weight()});
      if (x + 1 < n && y + 1 < n) edges.push_back({v, v + n + 1, weight()});
    }
  return laplacian_of(n * n, edges);
}

/// The row that an error names; -1 if there is none.
Eigen::Index stopped_at(const Matrix& l, const Eigen::VectorXd& d) {
  try {
    const IT::Laplacian_factorization f(l, d);
  } catch (const IT::Indefinite_matrix& error) {
    return error.row();
  }
  return -1;
}

// One stray entry in each triangle, so that both have as many.
TEST(Laplacian_factorization, patterns_that_are_not_symmetric_are_refused) {
  Matrix m = laplacian_of(4, {{0, 1, 1.}, {1, 2, 1.}, {2, 3, 1.}});
  m.coeffRef(0, 2) = -1;
  m.coeffRef(3, 1) = -1;
  m.makeCompressed();
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(4);
  EXPECT_THROW(IT::Laplacian_factorization(m, ones), std::invalid_argument);
}

TEST(Laplacian_factorization, solves_what_cholesky_solves) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> positive(0.1, 1), any(-0.05, 1);
  for (const int n : {1, 2, 7, 40})
    for (const bool is_signed : {false, true}) {
      const Matrix l =
          grid_laplacian(n, [&] { return is_signed ? any(random) : positive(random); });
      const Eigen::VectorXd d = Eigen::VectorXd::Constant(n * n, 0.5);
      const Matrix a = l + Matrix(d.asDiagonal());
      const Eigen::MatrixXd b = Eigen::MatrixXd::Random(n * n, 3);
      const IT::Laplacian_factorization factored(l, d);
      EXPECT_EQ(factored.size(), n * n);
      EXPECT_LE((a * factored.solve(b) - b).norm(), 1e3 * epsilon * b.norm()) << n;
      EXPECT_LE((factored.solve(b) - IT::Cholesky_factorization(a).solve(b)).norm(),
                1e3 * epsilon * b.norm());
    }
}

// So many edges between vertices at random: parts, isolated vertices and cycles of all sizes.
Matrix random_laplacian(int size, int edges, std::mt19937& random) {
  std::vector<Edge> list;
  for (int k = 0; k < edges; ++k) {
    const int i = static_cast<int>(random() % static_cast<unsigned>(size)),
              j = static_cast<int>(random() % static_cast<unsigned>(size));
    if (i != j) list.push_back({i, j, 0.1 + 1e-9 * static_cast<double>(random())});
  }
  return laplacian_of(size, list);
}

// Whatever entries elimination makes: they are where the solution needs them.
TEST(Laplacian_factorization, of_random_graphs_solves_as_a_dense_method) {
  std::mt19937 random(3);
  for (const auto& [size, edges] :
       {std::pair{1, 0}, {5, 0}, {9, 8}, {30, 25}, {30, 60}, {60, 60}, {60, 130}, {25, 400}})
    for (int trial = 0; trial < 10; ++trial) {
      const Matrix l = random_laplacian(size, edges, random);
      const Eigen::VectorXd d = Eigen::VectorXd::LinSpaced(size, 0.1, 1);
      const Eigen::MatrixXd right = Eigen::MatrixXd::Random(size, 3);
      const Eigen::MatrixXd dense = Eigen::MatrixXd(l) + Eigen::MatrixXd(d.asDiagonal());
      EXPECT_LE((IT::Laplacian_factorization(l, d).solve(right) - dense.ldlt().solve(right))
                    .cwiseAbs()
                    .maxCoeff(),
                1e-12);
    }
  EXPECT_EQ(IT::Laplacian_factorization(Matrix(0, 0), Eigen::VectorXd(0)).size(), 0);
}

// A row that is joined to all others comes last: before them, it would make a dense matrix of them.
TEST(Laplacian_factorization, of_a_wheel_takes_few_operations) {
  const int rim = 20000;
  std::vector<Edge> edges;
  for (int i = 0; i < rim; ++i) {
    if (i + 1 < rim) edges.push_back({i, i + 1, 1});
    edges.push_back({i, rim, 1});
  }
  const Eigen::VectorXd d = Eigen::VectorXd::Ones(rim + 1);
  const Eigen::VectorXd x = IT::Laplacian_factorization(laplacian_of(rim + 1, edges), d).solve(d);
  EXPECT_LE((x - d).cwiseAbs().maxCoeff(), 1e3 * epsilon);
}

// The sum of the numbers of the hub's neighbours is more than an `int` holds, where Eigen's
// ordering reads and writes beyond its arrays.
TEST(Laplacian_factorization, of_a_hub_in_a_large_matrix_solves) {
  constexpr int size = 400000, leaves = 6000;
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = size - leaves; i < size; ++i) {
    entries.emplace_back(0, i, -1);
    entries.emplace_back(i, 0, -1);
  }
  Matrix l(size, size); // no diagonal: it is not read
  l.setFromTriplets(entries.begin(), entries.end());
  // of 1 at the hub, and of 2 = 1 + 1 at leaves: x_leaf = (b_leaf + x_hub) / 2
  const IT::Laplacian_factorization factored(l, Eigen::VectorXd::Ones(size));
  Eigen::VectorXd b = Eigen::VectorXd::Zero(size);
  b[0] = 1;
  const Eigen::VectorXd x = factored.solve(b);
  const double hub = 1 / (1 + leaves / 2.); // (1 + leaves) x_hub - leaves x_leaf = 1
  EXPECT_NEAR(x[0], hub, 1e-15);
  EXPECT_NEAR(x[size - 1], hub / 2, 1e-15);
  EXPECT_EQ(x[1], 0);
}

TEST(Laplacian_factorization, of_both_is_that_of_each) {
  std::mt19937 random(4);
  for (const auto& [size, edges] : {std::pair{1, 0}, {30, 40}, {200, 700}, {3000, 7000}}) {
    const Matrix a = random_laplacian(size, edges, random);
    const Eigen::VectorXd of_a = Eigen::VectorXd::Constant(size, 1e-3),
                          of_b = Eigen::VectorXd::LinSpaced(size, 1, 2);
    const auto both = IT::Laplacian_factorization::of_both(a, of_a, 0.3, of_b);
    const Eigen::MatrixXd right = Eigen::MatrixXd::Random(size, 2);
    EXPECT_EQ(both.first.solve(right), IT::Laplacian_factorization(a, of_a).solve(right));
    EXPECT_EQ(both.second.solve(right), IT::Laplacian_factorization(0.3 * a, of_b).solve(right));
    Eigen::VectorXd none = of_b;
    none.setZero();
    EXPECT_THROW(IT::Laplacian_factorization::of_both(a, of_a, 0.3, none), IT::Indefinite_matrix);
    EXPECT_THROW(IT::Laplacian_factorization::of_both(a, of_a, 0.3, Eigen::VectorXd(size + 1)),
                 std::invalid_argument);
    EXPECT_THROW(IT::Laplacian_factorization::of_both(
                     a, of_a, std::numeric_limits<double>::quiet_NaN(), of_b),
                 std::invalid_argument);
  }
}

TEST(Laplacian_factorization, solves_columns_together_as_one_by_one) {
  std::mt19937 random(6);
  const Matrix l = random_laplacian(500, 1600, random);
  const IT::Laplacian_factorization factored(l, Eigen::VectorXd::Constant(500, 1e-2));
  for (Eigen::Index columns = 0; columns < 12; ++columns) {
    Eigen::MatrixXd right = Eigen::MatrixXd::Random(500, columns);
    if (columns > 1) right.col(1).setZero(); // nothing is skipped for the others
    const Eigen::MatrixXd together = factored.solve(right);
    ASSERT_EQ(together.cols(), columns);
    for (Eigen::Index c = 0; c < columns; ++c)
      EXPECT_EQ(together.col(c), factored.solve(right.col(c))) << c << " of " << columns;
  }
}

// The grid is so large that two threads eliminate its halves: the row at which they stop is the same whichever is faster.
TEST(Laplacian_factorization, indefinite_rows_of_halves_are_told) {
  const Matrix l = grid_laplacian(90, [] { return 1.; });
  const auto negative_in = [&l](const std::vector<Eigen::Index>& rows) {
    Eigen::VectorXd d = Eigen::VectorXd::Constant(l.rows(), 0.1);
    for (const Eigen::Index row : rows) d[row] = -1e3;
    return stopped_at(l, d);
  };
  for (Eigen::Index row = 0; row < l.rows(); row += 613) EXPECT_EQ(negative_in({row}), row);
  const Eigen::Index first = negative_in({5, 8000});
  for (int trial = 0; trial < 5; ++trial) EXPECT_EQ(negative_in({5, 8000}), first);
}

// Springs in a row from a wall, pulled at the end: each is stretched by 1 / weight.
TEST(Laplacian_factorization, has_full_relative_accuracy_whatever_the_weights) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-60, 60);
  const int n = 200;
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Edge> edges;
    Eigen::VectorXd wall = Eigen::VectorXd::Zero(n);
    wall[0] = std::pow(10, exponent(random));
    std::vector<long double> expected{1.0L / wall[0]};
    for (int i = 0; i + 1 < n; ++i) {
      edges.push_back({i, i + 1, std::pow(10, exponent(random))});
      expected.push_back(expected.back() + 1.0L / edges.back().weight);
    }
    const Matrix l = laplacian_of(n, edges);
    const Eigen::VectorXd x = IT::Laplacian_factorization(l, wall).solve(
        Eigen::VectorXd(Eigen::VectorXd::Unit(n, n - 1)));
    for (int i = 0; i < n; ++i)
      EXPECT_NEAR(static_cast<double>(x[i] / expected[static_cast<std::size_t>(i)]), 1,
                  20 * n * epsilon);
    EXPECT_THROW(IT::Cholesky_factorization(Matrix(l + Matrix(wall.asDiagonal()))),
                 IT::Indefinite_matrix);
  }
}

// Random walks on a grid: their probabilities of leaving sum to 1, and are computed without any cancellation.
TEST(Laplacian_factorization, of_weights_that_differ_by_many_powers_of_ten_keeps_sums) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> exponent(-30, 30);
  const int n = 20;
  const Matrix l = grid_laplacian(n, [&] { return std::pow(10, exponent(random)); });
  Eigen::VectorXd d = Eigen::VectorXd::Zero(n * n);
  for (int i = 0; i < n * n; i += 37) d[i] = std::pow(10, exponent(random));
  const Eigen::VectorXd x = IT::Laplacian_factorization(l, d).solve(d);
  for (const double p : x) EXPECT_NEAR(p, 1, 1e3 * epsilon); // (L + D) 1 = D 1
}

// The solution by elimination one by one, without subtraction, in higher precision.
std::vector<long double> solved_without_subtraction(const Matrix& l, const Eigen::VectorXd& d,
                                                    const Eigen::VectorXd& right) {
  const auto n = static_cast<std::size_t>(l.rows());
  std::vector<std::vector<long double>> w(n, std::vector<long double>(n + 1, 0)); // last: to ground
  std::vector<long double> x(right.begin(), right.end()), pivot(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j)
      if (i != j) w[i][j] = -l.coeff(static_cast<int>(i), static_cast<int>(j));
    w[i][n] = d[static_cast<Eigen::Index>(i)];
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t j = k + 1; j <= n; ++j) pivot[k] += w[k][j];
    for (std::size_t i = k + 1; i < n; ++i) {
      x[i] += w[i][k] / pivot[k] * x[k];
      for (std::size_t j = k + 1; j <= n; ++j)
        if (i != j) w[i][j] += w[i][k] / pivot[k] * w[k][j];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) x[k] += w[k][j] * x[j];
    x[k] /= pivot[k];
  }
  return x;
}

// All rows are one supernode, wide enough for panels and products of dense matrices.
TEST(Laplacian_factorization, of_a_complete_graph_has_full_relative_accuracy) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> exponent(-30, 30);
  for (const int size : {9, 70, 150, 203}) {
    std::vector<Edge> edges;
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < i; ++j) edges.push_back({i, j, std::pow(10, exponent(random))});
    const Matrix l = laplacian_of(size, edges);
    Eigen::VectorXd d(size);
    for (double& x : d) x = std::pow(10, exponent(random));
    const Eigen::VectorXd right = Eigen::VectorXd::Unit(size, size / 2);
    const Eigen::VectorXd x = IT::Laplacian_factorization(l, d).solve(right);
    const std::vector<long double> expected = solved_without_subtraction(l, d, right);
    for (int i = 0; i < size; ++i)
      ASSERT_NEAR(static_cast<double>(x[i] / expected[static_cast<std::size_t>(i)]), 1,
                  100 * size * epsilon);
    const auto both = IT::Laplacian_factorization::of_both(l, d, 0.5, 2 * d);
    EXPECT_EQ(both.first.solve(right), x);
    EXPECT_EQ(both.second.solve(right), IT::Laplacian_factorization(0.5 * l, 2 * d).solve(right));
  }
}

TEST(Laplacian_factorization, names_a_row_of_a_component_without_diagonal) {
  const Matrix l = laplacian_of(5, {{0, 1, 1}, {1, 2, 1e-9}, {3, 4, 3}});
  Eigen::VectorXd d = Eigen::VectorXd::Zero(5);
  d[1] = 1e-300;
  EXPECT_GE(stopped_at(l, d), 3);
  d[4] = 1e-30;
  EXPECT_NO_THROW(IT::Laplacian_factorization(l, d));
  EXPECT_THROW(IT::Laplacian_factorization(l, Eigen::VectorXd::Ones(4)), std::invalid_argument);
  d[4] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(IT::Laplacian_factorization(l, d), std::invalid_argument);
  const Matrix lower = l.triangularView<Eigen::Lower>();
  EXPECT_THROW(IT::Laplacian_factorization(lower, Eigen::VectorXd::Ones(5)), std::invalid_argument);
  const IT::Laplacian_factorization good(l, Eigen::VectorXd::Ones(5));
  EXPECT_THROW(good.solve(Eigen::VectorXd(Eigen::VectorXd::Ones(4))), std::invalid_argument);
}

} // namespace laplacian_factorizations

} // namespace
