// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CURVES_SPLIT_CROSSED_EDGES_H
#define CGAL_INTRINSIC_GEODESICS_CURVES_SPLIT_CROSSED_EDGES_H

#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Every edge that a line crosses is split.
template <class Triangulation>
struct Split_crossed_edges {
  using Halfedges = std::vector<typename Triangulation::halfedge_descriptor>;
  static constexpr bool may_split = true;

  bool may_flip(std::uint32_t) const { return false; }
  Halfedges edges_along(const Halfedges& crossed) const { return crossed; } // there are none
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_CURVES_SPLIT_CROSSED_EDGES_H
