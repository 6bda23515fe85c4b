// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_ORDERING_SEPARABLE_GRAPH_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_ORDERING_SEPARABLE_GRAPH_H

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A graph whose vertices have weights: numbers of vertices of a finer graph.
struct Separable_graph {
  std::vector<int> begin{0}, neighbour, weight;

  int size() const { return static_cast<int>(weight.size()); }
  int degree(int v) const { return end(v) - first(v); }
  const int* neighbours(int v) const { return neighbour.data() + first(v); }
  const int* neighbours_end(int v) const { return neighbour.data() + end(v); }

  // the graph of some vertices, with their numbers there, and its edges
  Separable_graph induced(const std::vector<int>& vertices) const {
    std::vector<int> number(weight.size(), -1);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      number[static_cast<std::size_t>(vertices[i])] = static_cast<int>(i);
    Separable_graph result;
    for (const int v : vertices) {
      for (const int* n = neighbours(v); n != neighbours_end(v); ++n)
        if (const int u = number[static_cast<std::size_t>(*n)]; u >= 0)
          result.neighbour.push_back(u);
      result.add_vertex(weight[static_cast<std::size_t>(v)]);
    }
    return result;
  }
  // after its neighbours
  void add_vertex(int w) {
    weight.push_back(w);
    begin.push_back(static_cast<int>(neighbour.size()));
  }

private:
  int first(int v) const { return begin[static_cast<std::size_t>(v)]; }
  int end(int v) const { return begin[static_cast<std::size_t>(v) + 1]; }
};

// Joins each vertex of some, and its neighbours, to a vertex of a coarser graph.
// \param begin the first vertex \return the vertex there of each vertex
inline std::vector<int> joined_neighbours(const Separable_graph& g, int begin) {
  std::vector<int> to(g.weight.size(), -1), weight;
  const auto at = [](int v) { return static_cast<std::size_t>(v); };
  const auto is_free = [&](int v) { return to[at(v)] < 0; };
  for (int i = 0; i < g.size(); ++i) {
    const int v = i < g.size() - begin ? begin + i : i - (g.size() - begin);
    if (!is_free(v) || !std::all_of(g.neighbours(v), g.neighbours_end(v), is_free)) continue;
    const int number = static_cast<int>(weight.size());
    weight.push_back(g.weight[at(v)]);
    to[at(v)] = number;
    for (const int* n = g.neighbours(v); n != g.neighbours_end(v); ++n) {
      to[at(*n)] = number;
      weight.back() += g.weight[at(*n)];
    }
  }
  // Each other one has a neighbour there; the lightest one.
  for (int v = 0; v < g.size(); ++v) {
    if (!is_free(v)) continue;
    int best = -1;
    for (const int* n = g.neighbours(v); n != g.neighbours_end(v); ++n)
      if (const int c = to[at(*n)]; c >= 0 && (best < 0 || weight[at(c)] < weight[at(best)]))
        best = c;
    to[at(v)] = best;
    weight[at(best)] += g.weight[at(v)];
  }
  return to;
}

inline Separable_graph coarse_graph(const Separable_graph& g, const std::vector<int>& to) {
  const auto at = [](int v) { return static_cast<std::size_t>(v); };
  const int size = to.empty() ? 0 : *std::max_element(to.begin(), to.end()) + 1;
  std::vector<int> first(at(size) + 1, 0), member(to.size()), seen(at(size), -1);
  for (const int c : to) ++first[at(c) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<int> next(first.begin(), first.end() - 1);
  for (std::size_t v = 0; v < to.size(); ++v) member[at(next[at(to[v])]++)] = static_cast<int>(v);
  Separable_graph result;
  for (int c = 0; c < size; ++c) {
    seen[at(c)] = c;
    int weight = 0;
    for (int i = first[at(c)]; i < first[at(c) + 1]; ++i) {
      const int v = member[at(i)];
      weight += g.weight[at(v)];
      for (const int* n = g.neighbours(v); n != g.neighbours_end(v); ++n)
        if (std::exchange(seen[at(to[at(*n)])], c) != c) result.neighbour.push_back(to[at(*n)]);
    }
    result.add_vertex(weight);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_ORDERING_SEPARABLE_GRAPH_H
