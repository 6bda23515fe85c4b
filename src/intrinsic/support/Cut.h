// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUPPORT_CUT_H
#define INTRINSIC_SUPPORT_CUT_H

#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace program {

/// How a mesh was cut open.
struct Cut {
  /// The vertex of the file that each vertex of the surface is a copy of; empty: it is not cut.
  std::vector<std::uint32_t> original_vertex;
  std::size_t edges = 0;                                         ///< number of edges that were cut
  double length = 0;                                             ///< of these edges in space
  std::vector<CGAL::Intrinsic_triangulations::Polyline> seams{}; ///< these edges in space

  bool is_cut() const { return !original_vertex.empty(); }
};

} // namespace program

#endif // INTRINSIC_SUPPORT_CUT_H
