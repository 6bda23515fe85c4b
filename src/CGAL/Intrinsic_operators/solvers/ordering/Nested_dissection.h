// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_ORDERING_NESTED_DISSECTION_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_ORDERING_NESTED_DISSECTION_H

#include <CGAL/Intrinsic_operators/solvers/ordering/Graph_separation.h>
#include <CGAL/Intrinsic_operators/solvers/ordering/Separable_graph.h>
#include <CGAL/Intrinsic_operators/solvers/ordering/Separator_refinement.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Divides the vertices of a graph into parts that are eliminated one after another (George 1973). A
separator leaves two sides, which are divided in turn, and follows them: so elimination of a side
makes no entries in the other one. Small sides are parts.
*/
class Nested_dissection {
public:
  explicit Nested_dissection(const Separable_graph& graph)
      : part_(static_cast<std::size_t>(graph.size())) {
    std::vector<int> vertices;
    std::vector<int> hubs;
    // Rows with many entries come last: they would be in all separators.
    const double most = 10 * std::sqrt(graph.size()) + 16;
    for (int v = 0; v < graph.size(); ++v) (graph.degree(v) > most ? hubs : vertices).push_back(v);
    if (hubs.empty()) {
      divide(graph, vertices);
    } else {
      divide(graph.induced(vertices), vertices);
    }
    finish_part(hubs);
  }

  // the number of the part of each vertex, in the order of elimination
  const std::vector<int>& parts() const { return part_; }
  int number_of_parts() const { return number_; }

private:
  static constexpr int small = 2000;

  void finish_part(const std::vector<int>& vertices) {
    for (const int v : vertices) part_[static_cast<std::size_t>(v)] = number_;
    ++number_;
  }

  // \param vertices the numbers of those of the graph in the whole one
  void divide(const Separable_graph& graph, const std::vector<int>& vertices) {
    if (graph.size() <= small) return finish_part(vertices);
    const std::vector<Graph_side> side = Graph_separation()(graph);
    std::array<std::vector<int>, 3> local, global;
    for (std::size_t v = 0; v < side.size(); ++v) {
      local[side[v]].push_back(static_cast<int>(v));
      global[side[v]].push_back(vertices[v]);
    }
    // Without a small separator minimum degree does as well.
    if (3 * local[separating].size() > side.size()) return finish_part(vertices);
    for (const Graph_side s : {near_side, far_side}) divide(graph.induced(local[s]), global[s]);
    finish_part(global[separating]);
  }

  std::vector<int> part_;
  int number_ = 0;
};

// The graph of the entries of a symmetric matrix.
template <class Scalar>
Separable_graph graph_of(const Eigen::SparseMatrix<Scalar>& a) {
  Separable_graph result;
  result.neighbour.reserve(static_cast<std::size_t>(a.nonZeros()));
  for (int c = 0; c < a.cols(); ++c) {
    const int* const rows = a.innerIndexPtr();
    for (int e = a.outerIndexPtr()[c]; e < a.outerIndexPtr()[c + 1]; ++e)
      if (rows[e] != c) result.neighbour.push_back(rows[e]);
    result.add_vertex(1);
  }
  return result;
}

// The rows of a symmetric matrix by nested dissection, and in each part in a given order.
template <class Scalar>
std::vector<int> dissected_order(const Eigen::SparseMatrix<Scalar>& a,
                                 const std::vector<int>& order) {
  const Nested_dissection dissection(graph_of(a));
  const auto part = [&](int row) { return dissection.parts()[static_cast<std::size_t>(row)]; };
  std::vector<std::size_t> next(static_cast<std::size_t>(dissection.number_of_parts()) + 1, 0);
  for (const int row : order) ++next[static_cast<std::size_t>(part(row)) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<int> result(order.size());
  for (const int row : order) result[next[static_cast<std::size_t>(part(row))]++] = row;
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_ORDERING_NESTED_DISSECTION_H
