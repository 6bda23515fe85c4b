// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/cuts/Edge_graph.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_open.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

void check_surface_to_cut(const Surface_to_cut& s) {
  const std::size_t n = s.gluing.origin.size();
  if (s.length.size() != n || (!s.is_kept.empty() && s.is_kept.size() != n))
    throw Invalid_input(Element_kind::none, 0,
                        "a surface to cut needs a length, and a mark or none, for each of its " +
                            std::to_string(n) + " sides");
  for (std::uint32_t h = 0; h < n; ++h)
    if (!(s.length[h] >= 0 && std::isfinite(s.length[h])))
      throw Invalid_input(Element_kind::halfedge, h,
                          "side " + std::to_string(h % 3) + " of face " + std::to_string(h / 3) +
                              " has no finite length; correct it");
}

} // namespace

Edge_graph::Edge_graph(const Surface_to_cut& s, bool merges_borders) : s_(s) {
  check_surface_to_cut(s);
  find_nodes(merges_borders);
  find_edges();
  find_components();
  link_edges();
  distance_.resize(number_of_nodes());
  last_edge_.resize(number_of_nodes());
  parent_.resize(s.gluing.number_of_faces() + std::size_t{1});
  check_kept_edges();
}

// Trees and cotrees exist if the faces beside edges that must not be cut form no cycle.
void Edge_graph::check_kept_edges() {
  std::iota(parent_.begin(), parent_.end(), 0U);
  for (std::uint32_t e = 0; e < edges_.size(); ++e)
    if (edges_[e].is_kept && !join_faces(e))
      throw Invalid_input(Element_kind::halfedge, edges_[e].side,
                          "the faces beside sides that must not be cut close up at side " +
                              std::to_string(edges_[e].side % 3) + " of face " +
                              std::to_string(edges_[e].side / 3) +
                              ": no disk has all of them whole; permit to cut one of them");
}

void Edge_graph::find_nodes(bool merges_borders) {
  const Gluing& g = s_.gluing;
  const Opened_surface fans = cut_open(g, std::vector<char>(g.origin.size(), 0));
  node_ = fans.gluing.origin;
  if (!merges_borders) return;
  const std::vector<std::uint32_t> joined =
      joined_sets(fans.gluing.number_of_vertices, [&](const auto& join) {
        for (std::uint32_t h = 0; h < node_.size(); ++h)
          if (g.glue[h] == none) join(node_[h], node_[Gluing::next(h)]);
      });
  for (std::uint32_t& v : node_) v = joined[v];
}

void Edge_graph::find_edges() {
  const std::vector<std::uint32_t>& glue = s_.gluing.glue;
  for (std::uint32_t h = 0; h < glue.size(); ++h) {
    const std::uint32_t p = Gluing::partner(glue[h]);
    if (p != none && p < h) continue;
    const bool is_kept = p != none && !s_.is_kept.empty() && // no border is cut
                         (s_.is_kept[h] != 0 || s_.is_kept[p] != 0);
    edges_.push_back({h, {node_[h], node_[Gluing::next(h)]}, p == none, is_kept});
  }
}

void Edge_graph::find_components() {
  const std::uint32_t faces = s_.gluing.number_of_faces();
  const std::vector<std::uint32_t> least = joined_sets(faces, [&](const auto& join) {
    for (const Edge& e : edges_)
      if (!e.is_on_border) join(e.side / 3, Gluing::partner(s_.gluing.glue[e.side]) / 3);
  });
  std::vector<std::uint32_t> number(faces);
  for (std::uint32_t f = 0; f < faces; ++f) {
    if (least[f] == f) {
      number[f] = static_cast<std::uint32_t>(components_.size());
      components_.emplace_back();
    }
    number[f] = number[least[f]];
    components_[number[f]].faces.push_back(f);
  }
  for (std::uint32_t e = 0; e < edges_.size(); ++e) {
    Component& c = components_[number[edges_[e].side / 3]];
    c.edges.push_back(e);
    c.has_border = c.has_border || edges_[e].is_on_border;
  }
  std::vector<char> is_seen(node_.empty() ? 0 : *std::max_element(node_.begin(), node_.end()) + 1,
                            0);
  for (std::uint32_t h = 0; h < node_.size(); ++h) {
    if (is_seen[node_[h]] == 0) components_[number[h / 3]].nodes.push_back(node_[h]);
    is_seen[node_[h]] = 1;
  }
  first_.assign(is_seen.size() + 1, 0);
}

// Edges that must not be cut are in no tree.
void Edge_graph::link_edges() {
  const auto for_each_end = [this](const auto& f) {
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
      if (!edges_[e].is_kept && edges_[e].ends[0] != edges_[e].ends[1])
        for (const std::uint32_t v : edges_[e].ends) f(v, e);
  };
  for_each_end([this](std::uint32_t v, std::uint32_t) { ++first_[v + 1]; });
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  link_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for_each_end([&](std::uint32_t v, std::uint32_t e) { link_[next[v]++] = e; });
}

void Edge_graph::grow(const Component& c, std::span<const std::uint32_t> roots) {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const std::uint32_t v : c.nodes) {
    distance_[v] = std::numeric_limits<double>::infinity();
    last_edge_[v] = none;
  }
  for (const std::uint32_t r : roots) {
    distance_[r] = 0;
    queue.emplace(0, r);
  }
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance_[v]) continue;
    for (std::uint32_t i = first_[v]; i < first_[v + 1]; ++i) {
      const Edge& e = edges_[link_[i]];
      const std::uint32_t w = e.ends[0] == v ? e.ends[1] : e.ends[0];
      const double to = d + s_.length[e.side];
      if (!(to < distance_[w])) continue;
      distance_[w] = to;
      last_edge_[w] = link_[i];
      queue.emplace(to, w);
    }
  }
}

std::uint32_t Edge_graph::farthest(const Component& c) const {
  // Of nodes that are equally far, one that is not a root: lengths may all be zero.
  const auto key = [this](std::uint32_t v) {
    return std::pair(distance_[v], last_edge_[v] != none);
  };
  return *std::max_element(c.nodes.begin(), c.nodes.end(),
                           [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
}

std::uint32_t Edge_graph::root_face(std::uint32_t f) {
  while (parent_[f] != f) f = parent_[f] = parent_[parent_[f]];
  return f;
}

// Whether the faces beside an edge were apart; they are in one tree then.
bool Edge_graph::join_faces(std::uint32_t e) {
  const std::uint32_t p = Gluing::partner(s_.gluing.glue[edges_[e].side]);
  const std::uint32_t f = root_face(edges_[e].side / 3),
                      g = root_face(p == none ? s_.gluing.number_of_faces() : p / 3);
  parent_[f] = g;
  return f != g;
}

std::vector<std::uint32_t> Edge_graph::closing_edges(const Component& c, bool spans_border) {
  for (const std::uint32_t f : c.faces) parent_[f] = f;
  parent_.back() = s_.gluing.number_of_faces();
  std::vector<std::pair<double, std::uint32_t>> loops;
  for (const std::uint32_t e : c.edges) {
    const auto& [i, j] = edges_[e].ends;
    if (edges_[e].is_kept) join_faces(e);
    const bool is_in_tree = i != j && (last_edge_[i] == e || last_edge_[j] == e);
    if (edges_[e].is_kept || is_in_tree || (edges_[e].is_on_border && !spans_border)) continue;
    loops.emplace_back(distance_[i] + length(e) + distance_[j], e);
  }
  std::stable_sort(loops.begin(), loops.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::uint32_t> result;
  for (const auto& [weight, e] : loops)
    if (!join_faces(e)) result.push_back(e);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
