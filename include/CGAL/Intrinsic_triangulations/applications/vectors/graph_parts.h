// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_GRAPH_PARTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_GRAPH_PARTS_H

#include <CGAL/Intrinsic_triangulations/operators/Connection_graph.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// For each vertex, one that stands for all that it is connected with by edges of positive weight.
inline std::vector<std::size_t> graph_parts(const Connection_graph& graph) {
  std::vector<std::size_t> parent(graph.size);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&parent](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const Connection_edge& e : graph.edges)
    if (e.weight > 0)
      parent[root(static_cast<std::size_t>(e.source))] = root(static_cast<std::size_t>(e.target));
  for (std::size_t i = 0; i < graph.size; ++i) parent[i] = root(i);
  return parent;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_GRAPH_PARTS_H
