// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_ORDERING_SEPARATOR_REFINEMENT_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_ORDERING_SEPARATOR_REFINEMENT_H

#include <CGAL/Intrinsic_operators/solvers/ordering/Separable_graph.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

enum Graph_side : unsigned char { near_side, far_side, separating };
inline Graph_side opposite_side(Graph_side s) { return s == near_side ? far_side : near_side; }

/*
Moves vertices out of a separator while it gets lighter (Fiduccia and Mattheyses 1982): a vertex
that moves to a side takes its neighbours on the other side into the separator. It goes on for some
moves that make it heavier, and returns to the lightest separator.
*/
class Separator_refinement {
public:
  Separator_refinement(const Separable_graph& graph, std::vector<Graph_side>& side)
      : g_(graph), side_(side), beyond_(side.size()), is_moved_(side.size(), 0) {
    for (std::size_t v = 0; v < side.size(); ++v) weight_[side[v]] += g_.weight[v];
  }

  // the weight of the separator, and what the sides differ by where they differ too much
  int cost() const {
    const int all = weight_[0] + weight_[1] + weight_[2];
    return weight_[separating] + std::max(0, std::max(weight_[0], weight_[1]) - all * 3 / 5);
  }

  void run() {
    for (int pass = 0; pass < most_passes; ++pass)
      if (!improves()) return;
  }

private:
  static constexpr int most_passes = 10, most_moves_without_gain = 300;

  struct Move {
    int gain, difference, vertex;
    Graph_side to;
    bool operator<(const Move& m) const {
      return std::tie(gain, m.difference, vertex) < std::tie(m.gain, difference, m.vertex);
    }
  };
  static std::size_t at(int v) { return static_cast<std::size_t>(v); }

  // one pass; each vertex moves once
  bool improves() {
    moves_ = {};
    std::fill(is_moved_.begin(), is_moved_.end(), char{0});
    for (int v = 0; v < g_.size(); ++v)
      if (side_[at(v)] == separating) enter(v);
    const int before = cost();
    int best = before, best_balance = difference();
    std::size_t kept = 0;
    changes_.clear();
    for (int without = 0; !moves_.empty() && without < most_moves_without_gain;) {
      const Move m = moves_.top();
      moves_.pop();
      if (!is_current(m)) continue;
      make(m);
      ++without;
      if (std::pair(cost(), difference()) >= std::pair(best, best_balance)) continue;
      if (cost() < best) without = 0;
      best = cost();
      best_balance = difference();
      kept = changes_.size();
    }
    while (changes_.size() > kept) {
      set(changes_.back().first, changes_.back().second);
      changes_.pop_back();
    }
    return best < before;
  }

  int difference() const { return std::abs(weight_[0] - weight_[1]); }
  int gain(int v, Graph_side to) const {
    return g_.weight[at(v)] - beyond_[at(v)][opposite_side(to)];
  }

  bool is_current(const Move& m) const {
    if (side_[at(m.vertex)] != separating || is_moved_[at(m.vertex)] != 0 ||
        m.gain != gain(m.vertex, m.to))
      return false;
    const int w = g_.weight[at(m.vertex)], all = weight_[0] + weight_[1] + weight_[2];
    return weight_[m.to] + w <= all * 3 / 5 || weight_[m.to] <= weight_[opposite_side(m.to)];
  }

  void offer(int v) {
    if (is_moved_[at(v)] != 0) return;
    for (const Graph_side to : {near_side, far_side})
      moves_.push({gain(v, to), weight_[to], v, to});
  }

  // finds the weights beyond a vertex of the separator
  void enter(int v) {
    beyond_[at(v)] = {0, 0, 0};
    for (const int* n = g_.neighbours(v); n != g_.neighbours_end(v); ++n)
      beyond_[at(v)][side_[at(*n)]] += g_.weight[at(*n)];
    offer(v);
  }

  void set(int v, Graph_side s) {
    weight_[side_[at(v)]] -= g_.weight[at(v)];
    weight_[s] += g_.weight[at(v)];
    side_[at(v)] = s;
  }

  void change(int v, Graph_side s) {
    const Graph_side old = side_[at(v)];
    changes_.emplace_back(v, old);
    set(v, s);
    for (const int* n = g_.neighbours(v); n != g_.neighbours_end(v); ++n) {
      if (side_[at(*n)] != separating) continue;
      beyond_[at(*n)][old] -= g_.weight[at(v)];
      beyond_[at(*n)][s] += g_.weight[at(v)];
      offer(*n);
    }
  }

  void make(const Move& m) {
    is_moved_[at(m.vertex)] = 1;
    change(m.vertex, m.to);
    for (const int* n = g_.neighbours(m.vertex); n != g_.neighbours_end(m.vertex); ++n)
      if (side_[at(*n)] == opposite_side(m.to)) {
        change(*n, separating);
        enter(*n);
      }
  }

  const Separable_graph& g_;
  std::vector<Graph_side>& side_;
  std::array<int, 3> weight_{0, 0, 0};
  std::vector<std::array<int, 3>> beyond_; // of vertices of the separator, weights of neighbours
  std::vector<char> is_moved_;
  std::priority_queue<Move> moves_;
  std::vector<std::pair<int, Graph_side>> changes_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_ORDERING_SEPARATOR_REFINEMENT_H
