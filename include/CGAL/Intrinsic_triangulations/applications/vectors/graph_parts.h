// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_GRAPH_PARTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_GRAPH_PARTS_H

#include <CGAL/Intrinsic_triangulations/operators/Connection_graph.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/Disjoint_sets.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// For each vertex, one that stands for all that it is connected with by edges of positive weight.
inline std::vector<std::uint32_t> graph_parts(const Connection_graph& graph) {
  Disjoint_sets vertices(graph.size);
  for (const Connection_edge& e : graph.edges)
    if (e.weight > 0)
      vertices.join(static_cast<std::uint32_t>(e.source), static_cast<std::uint32_t>(e.target));
  return std::move(vertices).least();
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_GRAPH_PARTS_H
