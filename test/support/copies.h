// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_COPIES_H
#define TEST_INTRINSIC_TRIANGULATIONS_COPIES_H

#include <boost/graph/graph_traits.hpp>

#include <cstdint>
#include <vector>

// Copies of vertices.

namespace copies_test {

template <class Triangulation>
bool is_isolated(const Triangulation& t, typename Triangulation::vertex_descriptor v) {
  return halfedge(v, t.mesh()) ==
         boost::graph_traits<typename Triangulation::Mesh>::null_halfedge();
}

/// The vertices over one row.
template <class Triangulation>
std::vector<typename Triangulation::vertex_descriptor> of_row(const Triangulation& t,
                                                              std::uint32_t row) {
  std::vector<typename Triangulation::vertex_descriptor> result;
  for (const auto v : vertices(t.mesh()))
    if (t.input_vertex(v) == row) result.push_back(v);
  return result;
}

} // namespace copies_test

#endif // TEST_INTRINSIC_TRIANGULATIONS_COPIES_H
