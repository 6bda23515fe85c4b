// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_ORDERING_GRAPH_SEPARATION_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_ORDERING_GRAPH_SEPARATION_H

#include <CGAL/Intrinsic_operators/solvers/ordering/Separable_graph.h>
#include <CGAL/Intrinsic_operators/solvers/ordering/Separator_refinement.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Half of a graph around a vertex, and the separator next to it.
// \param seed the vertex; becomes one that is far from it
inline std::vector<Graph_side> grown_side(const Separable_graph& g, int& seed) {
  const auto at = [](int v) { return static_cast<std::size_t>(v); };
  std::vector<Graph_side> side(g.weight.size(), far_side);
  std::vector<int> queue{seed};
  std::vector<char> is_seen(side.size(), 0);
  is_seen[at(seed)] = 1;
  const int all = std::accumulate(g.weight.begin(), g.weight.end(), 0);
  int grown = 0, another = 0;
  for (std::size_t i = 0; i < side.size(); ++i) {
    while (i == queue.size()) { // in the next component
      if (std::exchange(is_seen[at(another)], char{1}) == 0) queue.push_back(another);
      ++another;
    }
    const int v = queue[i];
    if (2 * grown < all) side[at(v)] = near_side;
    grown += g.weight[at(v)];
    for (const int* n = g.neighbours(v); n != g.neighbours_end(v); ++n)
      if (std::exchange(is_seen[at(*n)], char{1}) == 0) queue.push_back(*n);
  }
  seed = queue.back();
  for (int v = 0; v < g.size(); ++v)
    if (side[at(v)] == far_side && std::any_of(g.neighbours(v), g.neighbours_end(v),
                                               [&](int u) { return side[at(u)] == near_side; }))
      side[at(v)] = separating;
  return side;
}

// The lightest separator of a small graph, from some seeds.
inline std::vector<Graph_side> separated_coarsest(const Separable_graph& g) {
  std::vector<Graph_side> best;
  int least = 0;
  int seed = 0;
  for (int i = 0; i < 8; ++i) {
    if (i >= 3) seed = (i - 3) * g.size() / 5;
    std::vector<Graph_side> side = grown_side(g, seed);
    Separator_refinement refinement(g, side);
    refinement.run();
    if (!best.empty() && refinement.cost() >= least) continue;
    least = refinement.cost();
    best = std::move(side);
  }
  return best;
}

/*
Separates two sides of a graph by few vertices: those of a coarser graph, refined (Hendrickson and
Rothberg 1998). A coarser graph depends on the vertex where joining begins; the first one that is
small takes the best of some.
*/
class Graph_separation {
public:
  std::vector<Graph_side> operator()(const Separable_graph& g) {
    return by_coarser(g, 0, attempts);
  }

private:
  static constexpr int coarsest = 120, small = 30'000, attempts = 4;

  // \param attempt its number, of `count`
  std::vector<Graph_side> by_coarser(const Separable_graph& g, int attempt, int count) {
    const int begin = static_cast<int>(std::int64_t{attempt} * g.size() / attempts);
    const std::vector<int> to = joined_neighbours(g, begin);
    const Separable_graph coarse = coarse_graph(g, to);
    if (5 * std::int64_t{coarse.size()} > 4 * std::int64_t{g.size()}) return separated_coarsest(g);
    const std::vector<Graph_side> of_coarse = separated(coarse, attempt, count);
    std::vector<Graph_side> side(to.size());
    for (std::size_t v = 0; v < to.size(); ++v)
      side[v] = of_coarse[static_cast<std::size_t>(to[v])];
    Separator_refinement(g, side).run();
    return side;
  }

  std::vector<Graph_side> separated(const Separable_graph& g, int attempt, int count) {
    if (g.size() <= coarsest) return separated_coarsest(g);
    if (count == 1 || g.size() > small) return by_coarser(g, attempt, count);
    std::vector<Graph_side> best;
    int least = 0;
    for (int i = 0; i < count; ++i) {
      std::vector<Graph_side> side = by_coarser(g, i, 1);
      const int cost = Separator_refinement(g, side).cost();
      if (!best.empty() && cost >= least) continue;
      least = cost;
      best = std::move(side);
    }
    return best;
  }
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_ORDERING_GRAPH_SEPARATION_H
