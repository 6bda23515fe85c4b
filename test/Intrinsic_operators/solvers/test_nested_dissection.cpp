// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/ordering/Graph_separation.h>
#include <CGAL/Intrinsic_operators/solvers/ordering/Nested_dissection.h>
#include <CGAL/Intrinsic_operators/solvers/ordering/Separable_graph.h>
#include <CGAL/Intrinsic_operators/solvers/ordering/Separator_refinement.h>
#include <CGAL/Intrinsic_operators/solvers/ordering/Symbolic_factorization.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace nested_dissections {

namespace IT = CGAL::Intrinsic_triangulations;
namespace internal = IT::internal;
using Matrix = Eigen::SparseMatrix<double>;

Matrix matrix_of_edges(int size, const std::vector<std::pair<int, int>>& edges) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < size; ++i) entries.emplace_back(i, i, 1);
  for (const auto& [i, j] : edges) {
    entries.emplace_back(i, j, -1);
    entries.emplace_back(j, i, -1);
    entries.emplace_back(i, i, 1);
    entries.emplace_back(j, j, 1);
  }
  Matrix m(size, size);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

// Triangles in a rectangle, some of them apart from each other.
Matrix rectangles(int rows, int columns, int count) {
  std::vector<std::pair<int, int>> edges;
  for (int k = 0; k < count; ++k)
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) {
        const int v = (k * rows + y) * columns + x;
        if (x + 1 < columns) edges.emplace_back(v, v + 1);
        if (y + 1 < rows) edges.emplace_back(v, v + columns);
        if (x + 1 < columns && y + 1 < rows) edges.emplace_back(v, v + columns + 1);
      }
  return matrix_of_edges(count * rows * columns, edges);
}

TEST(Nested_dissection, separators_of_rectangles_are_short_and_separate) {
  for (const auto& [rows, columns] : {std::pair{20, 20}, {60, 60}, {40, 200}, {3, 1000}}) {
    const internal::Separable_graph g = internal::graph_of(rectangles(rows, columns, 1));
    const std::vector<internal::Graph_side> side = internal::Graph_separation()(g);
    std::vector<int> count(3, 0);
    for (int v = 0; v < g.size(); ++v) {
      const internal::Graph_side s = side[static_cast<std::size_t>(v)];
      ++count[s];
      if (s == internal::separating) continue;
      for (const int* n = g.neighbours(v); n != g.neighbours_end(v); ++n)
        EXPECT_NE(side[static_cast<std::size_t>(*n)], internal::opposite_side(s));
    }
    EXPECT_LE(count[internal::separating], 1.3 * rows) << rows << " x " << columns;
    EXPECT_LE(std::max(count[0], count[1]), 0.61 * g.size());
  }
}

TEST(Nested_dissection, of_components_needs_no_separator) {
  const auto side = internal::Graph_separation()(internal::graph_of(rectangles(30, 30, 2)));
  EXPECT_EQ(std::count(side.begin(), side.end(), internal::separating), 0);
}

TEST(Nested_dissection, takes_less_work_than_minimum_degree_on_a_large_torus) {
  constexpr int size = 220;
  std::vector<std::pair<int, int>> edges;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      for (const auto& [right, up] : {std::pair{1, 0}, {0, 1}, {1, 1}})
        edges.emplace_back(y * size + x, (y + up) % size * size + (x + right) % size);
  const Matrix m = matrix_of_edges(size * size, edges);
  const std::vector<int> order = internal::minimum_degree_order(m),
                         dissected = internal::dissected_order(m, order);
  std::vector<int> sorted = dissected;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size(); ++i) ASSERT_EQ(sorted[i], static_cast<int>(i));
  EXPECT_LE(internal::Symbolic_factorization(m, dissected).work,
            0.9 * internal::Symbolic_factorization(m, order).work);
}

// Hubs, stars, complete graphs, isolated vertices, edges at random: an order, whatever its work.
TEST(Nested_dissection, orders_any_graph) {
  std::mt19937 random(7);
  std::vector<Matrix> graphs{matrix_of_edges(5000, {})};
  std::vector<std::pair<int, int>> star, wheel, all, any;
  for (int i = 1; i < 5000; ++i) {
    star.emplace_back(0, i);
    wheel.emplace_back(0, i);
    if (i > 1) wheel.emplace_back(i - 1, i);
    any.emplace_back(static_cast<int>(random() % 5000), static_cast<int>(random() % 5000));
    any.emplace_back(static_cast<int>(random() % 5000), static_cast<int>(random() % 5000));
  }
  for (int i = 0; i < 2500; ++i)
    for (int j = 0; j < 20; ++j) all.emplace_back(i, (i * 37 + j * j) % 2500);
  std::erase_if(any, [](const auto& e) { return e.first == e.second; });
  std::erase_if(all, [](const auto& e) { return e.first == e.second; });
  for (const auto& edges : {star, wheel, any}) graphs.push_back(matrix_of_edges(5000, edges));
  graphs.push_back(matrix_of_edges(2500, all));
  for (const Matrix& m : graphs) {
    std::vector<int> order(static_cast<std::size_t>(m.rows()));
    std::iota(order.begin(), order.end(), 0);
    std::vector<int> dissected = internal::dissected_order(m, order);
    std::sort(dissected.begin(), dissected.end());
    EXPECT_EQ(dissected, order);
  }
}

// Complex fronts that are wide enough for panels.
TEST(Cholesky_factorization, of_dense_matrices_solves_as_a_dense_method) {
  for (const int size : {9, 65, 150}) {
    const Eigen::MatrixXcd half = Eigen::MatrixXcd::Random(size, size);
    const Eigen::MatrixXcd dense =
        half * half.adjoint() + Eigen::MatrixXcd(Eigen::VectorXcd::Ones(size).asDiagonal());
    const Eigen::SparseMatrix<std::complex<double>> m = dense.sparseView();
    const Eigen::MatrixXcd b = Eigen::MatrixXcd::Random(size, 3);
    EXPECT_LE((dense * IT::Cholesky_factorization(m).solve(b) - b).norm(), 1e-11 * b.norm());
    const Matrix real = dense.real().sparseView();
    EXPECT_LE((real * IT::Cholesky_factorization(real).solve(Eigen::MatrixXd(b.real())) - b.real())
                  .norm(),
              1e-11 * b.norm());
  }
}

} // namespace nested_dissections

} // namespace
