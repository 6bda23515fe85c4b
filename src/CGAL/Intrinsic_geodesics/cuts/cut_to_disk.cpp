// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/cuts/Edge_graph.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

// Roots that are far from each other and from roots that are given, one after another.
class Far_roots {
public:
  Far_roots(const Edge_graph& graph, const Edge_graph::Component& c)
      : graph_(graph), c_(c), nearest_(c.nodes.size(), std::numeric_limits<double>::infinity()) {}

  // Takes the distances of the present tree into account. \return the farthest node
  std::uint32_t next() {
    std::size_t best = 0;
    for (std::size_t i = 0; i < nearest_.size(); ++i) {
      nearest_[i] = std::min(nearest_[i], graph_.distance(c_.nodes[i]));
      if (nearest_[i] > nearest_[best]) best = i;
    }
    return c_.nodes[best];
  }

private:
  const Edge_graph& graph_;
  const Edge_graph::Component& c_;
  std::vector<double> nearest_;
};

// The cut of one component after another.
class Disk_cutter {
public:
  Disk_cutter(const Surface_to_cut& s, std::span<const std::uint32_t> through)
      : s_(s), graph_(s, true), is_fixed_(graph_.number_of_nodes(), 0),
        is_reached_(graph_.number_of_nodes(), 0), degree_(graph_.number_of_nodes(), 0) {
    std::vector<char> is_passed(s.gluing.number_of_vertices, 0);
    for (const std::uint32_t v : through) {
      if (v >= is_passed.size())
        throw Invalid_input::about(Element_kind::vertex, v,
                                   ", which a cut is to pass through, does not exist");
      is_passed[v] = 1;
    }
    for (std::uint32_t h = 0; h < s.gluing.origin.size(); ++h) {
      char& passed = is_passed[s.gluing.origin[h]];
      if (passed != 0 || s.gluing.glue[h] == Gluing::none) is_fixed_[graph_.node_of_corner(h)] = 1;
      if (passed != 0) passed = 2;
    }
    for (std::uint32_t v = 0; v < is_passed.size(); ++v)
      if (is_passed[v] == 1)
        throw Invalid_input::about(Element_kind::vertex, v,
                                   " has no face, so that no cut passes through it; leave it out");
  }

  std::vector<char> run(std::size_t roots) {
    std::vector<char> is_cut(s_.gluing.origin.size(), 0);
    for (const Edge_graph::Component& c : graph_.components()) {
      for (const std::uint32_t e : best_cut(c, roots)) {
        const std::uint32_t h = graph_.edge(e).side;
        is_cut[h] = is_cut[Gluing::partner(s_.gluing.glue[h])] = 1;
      }
    }
    return is_cut;
  }

private:
  using Edges = std::vector<std::uint32_t>;

  Edges best_cut(const Edge_graph::Component& c, std::size_t roots) {
    std::vector<std::uint32_t> ends;
    for (const std::uint32_t v : c.nodes)
      if (is_fixed_[v] != 0) ends.push_back(v);
    if (!c.has_border && c.is_sphere()) add_ends_of_sphere(c, ends);
    best_.clear();
    best_length_ = std::numeric_limits<double>::infinity();
    if (!ends.empty()) {
      if (try_roots(c, ends) <= 1) return best_;
    } else {
      graph_.grow(c, std::span(c.nodes).first(1));
      roots = std::max<std::size_t>(roots, 1);
    }
    Far_roots far(graph_, c);
    std::vector<std::uint32_t> tried;
    for (std::size_t i = 0; i < roots; ++i) {
      std::uint32_t root = far.next();
      if (2 * i >= roots) root = branch(c, tried).value_or(root);
      tried.push_back(root);
      ends.push_back(root);
      try_roots(c, ends);
      ends.pop_back();
    }
    return best_;
  }

  // A sphere is cut between two nodes; if these are neighbours that the caller did not choose, also
  // through a third one.
  void add_ends_of_sphere(const Edge_graph::Component& c, std::vector<std::uint32_t>& ends) {
    if (ends.size() >= 2) return;
    if (ends.empty()) {
      graph_.grow(c, std::span(c.nodes).first(1));
      ends.push_back(graph_.farthest(c));
    }
    graph_.grow(c, ends);
    ends.push_back(graph_.farthest(c));
    if (graph_.before(ends[1]) == ends[0]) {
      graph_.grow(c, ends);
      ends.push_back(graph_.farthest(c));
    }
    for (const std::uint32_t v : ends) is_fixed_[v] = 1;
  }

  // Keeps the cut of a tree if it is the shortest so far. \return the number of loops
  std::size_t try_roots(const Edge_graph::Component& c, const std::vector<std::uint32_t>& roots) {
    graph_.grow(c, roots);
    const Edges closing = graph_.closing_edges(c, false);
    Edges cut = closing;
    for (const std::uint32_t v : c.nodes) is_reached_[v] = 0;
    for (const std::uint32_t e : closing)
      for (std::uint32_t v : graph_.edge(e).ends)
        for (; is_reached_[v] == 0 && graph_.last_edge(v) != Gluing::none; v = graph_.before(v)) {
          is_reached_[v] = 1;
          cut.push_back(graph_.last_edge(v));
        }
    prune(cut);
    double length = 0;
    for (const std::uint32_t e : cut) length += graph_.length(e);
    if (length < best_length_) {
      best_length_ = length;
      best_ = std::move(cut);
    }
    return closing.size();
  }

  void count_ends(const Edges& cut, int by) {
    for (const std::uint32_t e : cut)
      for (const std::uint32_t v : graph_.edge(e).ends) degree_[v] += by;
  }
  bool is_loose(std::uint32_t v) const { return degree_[v] == 1 && is_fixed_[v] == 0; }

  // Removes the way from a root to the first branch, if it is the only one there.
  void prune(Edges& cut) {
    count_ends(cut, 1);
    for (std::size_t before = cut.size() + 1; cut.size() < before;) {
      before = cut.size();
      Edges kept;
      for (std::size_t i = cut.size(); i-- > 0;) {
        const auto& [v, w] = graph_.edge(cut[i]).ends;
        if (!is_loose(v) && !is_loose(w)) {
          kept.push_back(cut[i]);
          continue;
        }
        --degree_[v];
        --degree_[w];
      }
      cut = std::move(kept);
    }
    count_ends(cut, -1);
  }

  // A node where the best cut branches, with most branches, that is none of those given.
  std::optional<std::uint32_t> branch(const Edge_graph::Component& c,
                                      const std::vector<std::uint32_t>& but) {
    count_ends(best_, 1);
    std::optional<std::uint32_t> result;
    for (const std::uint32_t v : c.nodes)
      if (degree_[v] >= 3 && is_fixed_[v] == 0 && (!result || degree_[v] > degree_[*result]) &&
          std::find(but.begin(), but.end(), v) == but.end())
        result = v;
    count_ends(best_, -1);
    return result;
  }

  const Surface_to_cut& s_;
  Edge_graph graph_;
  std::vector<char> is_fixed_;   // per node: no end of the cut there is loose
  std::vector<char> is_reached_; // per node: its way to the root is in the cut
  std::vector<int> degree_;      // per node, zero between uses
  Edges best_;
  double best_length_ = 0;
};

// The loop that an edge closes, as sides with marks.
std::vector<std::uint32_t> loop_of(const Edge_graph& graph, std::uint32_t closing) {
  // edges from the end of the edge back to the root, and the marks of their directions away from it
  const auto way_to_root = [&graph](std::uint32_t v) {
    std::vector<std::uint32_t> way;
    for (; graph.last_edge(v) != Gluing::none; v = graph.before(v)) {
      const Edge_graph::Edge& e = graph.edge(graph.last_edge(v));
      way.push_back(e.ends[1] == v ? e.side : Gluing::reversed(e.side));
    }
    return way;
  };
  const Edge_graph::Edge& e = graph.edge(closing);
  std::vector<std::uint32_t> out = way_to_root(e.ends[0]), back = way_to_root(e.ends[1]);
  while (!out.empty() && !back.empty() && out.back() == back.back()) {
    out.pop_back();
    back.pop_back();
  }
  std::reverse(out.begin(), out.end());
  out.push_back(e.side);
  for (const std::uint32_t h : back) out.push_back(h ^ Gluing::reversed_bit);
  return out;
}

} // namespace

} // namespace internal

std::vector<char> cut_to_disk(const Surface_to_cut& s, std::span<const std::uint32_t> through,
                              std::size_t roots) {
  return internal::Disk_cutter(s, through).run(roots);
}

std::vector<std::vector<std::uint32_t>> homology_generators(const Surface_to_cut& s,
                                                            std::size_t roots) {
  internal::Edge_graph graph(s, false);
  std::vector<std::vector<std::uint32_t>> result;
  for (const internal::Edge_graph::Component& c : graph.components()) {
    graph.grow(c, std::span(c.nodes).first(1));
    internal::Far_roots far(graph, c);
    std::vector<std::vector<std::uint32_t>> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < std::max<std::size_t>(roots, 1); ++i) {
      const std::array root{far.next()};
      graph.grow(c, root);
      std::vector<std::vector<std::uint32_t>> loops;
      double length = 0;
      for (const std::uint32_t e : graph.closing_edges(c, c.has_border)) {
        loops.push_back(internal::loop_of(graph, e));
        for (const std::uint32_t h : loops.back()) length += s.length[Gluing::partner(h)];
      }
      if (length < least) {
        least = length;
        best = std::move(loops);
      }
      if (best.empty()) break;
    }
    result.insert(result.end(), best.begin(), best.end());
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
