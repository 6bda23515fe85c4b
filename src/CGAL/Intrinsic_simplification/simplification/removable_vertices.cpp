// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/simplification/Simplifier.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

// Which vertices may be removed, before any of them is.

namespace CGAL::Intrinsic_triangulations::internal {

// Sorts vertices by their rows.
void Simplifier::find_copies() {
  std::vector<std::uint32_t> size(fine_.number_of_rows, 0);
  for (const std::uint32_t row : fine_.row) ++size[row];
  begin_.assign(1, 0);
  for (const std::uint32_t n : size) begin_.push_back(begin_.back() + n);
  copies_.resize(fine_.row.size());
  std::vector<std::uint32_t> next = begin_;
  for (const std::uint32_t v : mesh_.vertices()) copies_[next[fine_.row[mesh_.number(v)]]++] = v;
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
    vertices_[v].first_copy = copies(v).front();
    vertices_[v].is_alone = copies(v).size() == 1;
  }
}

// If one copy stays, all do.
void Simplifier::keep_copies() {
  for (std::uint32_t v = 0; v < vertices_.size(); ++v)
    if (vertices_[v].fate == Fate::stays)
      for (const std::uint32_t copy : copies(v)) vertices_[copy].fate = Fate::stays;
}

void Simplifier::mark_kept(const std::vector<char>& may_go) {
  std::vector<char> is_kept(fine_.number_of_rows, 0);
  for (const std::uint32_t row : options_.kept_vertices) {
    if (row >= fine_.number_of_rows)
      throw Invalid_input::about(Element_kind::vertex, row, " shall stay, but does not exist");
    is_kept[row] = 1;
  }
  const auto fate = [this](std::uint32_t number) -> Fate& {
    return vertices_[mesh_.vertices()[number]].fate;
  };
  for (std::uint32_t n = 0; n < vertices_.size(); ++n)
    if (mesh_.outgoing(mesh_.vertices()[n]) == Gluing::none || is_kept[fine_.row[n]] != 0 ||
        (!may_go.empty() && may_go[n] == 0))
      fate(n) = Fate::stays;
  std::vector<std::uint32_t> edges = options_.kept_edges;
  std::ranges::sort(edges);
  if (!edges.empty() && edges.back() > *std::ranges::max_element(fine_.edge))
    throw Invalid_input::about(Element_kind::edge, edges.back(), " shall stay, but does not exist");
  for (std::uint32_t h = 0; h < fine_.edge.size() && !edges.empty(); ++h)
    if (std::ranges::binary_search(edges, fine_.edge[h])) {
      mesh_.keep_side(mesh_.side(h));
      fate(fine_.gluing.origin[h]) = fate(fine_.gluing.origin[Gluing::next(h)]) = Fate::stays;
    }
  // several fans of faces at one vertex
  std::vector<std::uint32_t> corners(vertices_.size(), 0);
  for (const std::uint32_t v : fine_.gluing.origin) ++corners[v];
  for (std::uint32_t v = 0; v < vertices_.size(); ++v)
    if (vertices_[v].fate == Fate::open) {
      star_.find(mesh_, v);
      if (star_.size() != corners[mesh_.number(v)]) vertices_[v].fate = Fate::stays;
    }
}

// By Gauss and Bonnet, curvatures sum to 2 pi times the Euler characteristic of a component. They
// are below 2 pi inside and below pi on the border: twice the vertices inside and those on the
// border are more than twice the characteristic. A loop of the border needs a vertex, too.
void Simplifier::count_components() {
  const Gluing& g = fine_.gluing;
  const auto component = joined_sets(g.number_of_vertices, [&](const auto& join) {
    for (std::uint32_t h = 0; h < g.origin.size(); ++h) join(g.origin[h], g.origin[g.next(h)]);
  });
  const auto loop = joined_sets(g.number_of_vertices, [&](const auto& join) {
    for (std::uint32_t h = 0; h < g.origin.size(); ++h)
      if (g.glue[h] == Gluing::none) join(g.origin[h], g.origin[g.next(h)]);
  });
  weight_.assign(vertices_.size(), 0);
  least_weight_ = weight_;
  left_on_loop_.assign(vertices_.size(), 0);
  for (std::uint32_t h = 0; h < g.origin.size(); ++h) {
    if (g.glue[h] == Gluing::none) vertices_[mesh_.vertices()[g.origin[h]]].is_on_border = true;
    // an edge between two faces has two sides
    least_weight_[component[g.origin[h]]] -=
        (g.glue[h] == Gluing::none ? 2 : 1) - (h % 3 == 0 ? 2 : 0);
  }
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
    vertices_[v].component = component[mesh_.number(v)];
    vertices_[v].loop = loop[mesh_.number(v)];
    least_weight_[vertices_[v].component] += 2;
    add_to_counts(v, 1);
  }
  for (std::ptrdiff_t& w : least_weight_) w = std::max<std::ptrdiff_t>(w, 0) + 1;
}

} // namespace CGAL::Intrinsic_triangulations::internal
