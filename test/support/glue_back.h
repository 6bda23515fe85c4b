// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_GLUE_BACK_H
#define TEST_GLUE_BACK_H

#include <CGAL/Intrinsic_geodesics/cuts/cut_open.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <cstdint>

namespace cuts {

/// The surface before `cut_open()`.
inline CGAL::Intrinsic_triangulations::Gluing
glue_back(const CGAL::Intrinsic_triangulations::Opened_surface& s) {
  using CGAL::Intrinsic_triangulations::Gluing;
  Gluing g = s.gluing;
  for (std::uint32_t& v : g.origin) v = s.original_vertex[v];
  g.number_of_vertices = 0;
  while (g.number_of_vertices < s.original_vertex.size() &&
         s.original_vertex[g.number_of_vertices] == g.number_of_vertices)
    ++g.number_of_vertices;
  for (const auto& [h, entry] : s.seams) {
    const std::uint32_t p = Gluing::partner(entry);
    g.glue[h] = entry;
    g.glue[p] = Gluing::is_reversed(entry) ? Gluing::reversed(h) : h;
  }
  return g;
}

} // namespace cuts

#endif // TEST_GLUE_BACK_H
