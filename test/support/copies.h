// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_COPIES_H
#define TEST_INTRINSIC_TRIANGULATIONS_COPIES_H

#include <boost/graph/graph_traits.hpp>

// Copies of vertices.

namespace copies {

template <class Triangulation>
bool is_isolated(const Triangulation& t, typename Triangulation::vertex_descriptor v) {
  return halfedge(v, t.mesh()) ==
         boost::graph_traits<typename Triangulation::Mesh>::null_halfedge();
}

} // namespace copies

#endif // TEST_INTRINSIC_TRIANGULATIONS_COPIES_H
