// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_SURFACE_TO_CUT_H
#define TEST_INTRINSIC_TRIANGULATIONS_SURFACE_TO_CUT_H

#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <cstdint>

/// A triangulation by a `Gluing_map` with its lengths.
template <class Triangulation>
CGAL::Intrinsic_triangulations::Surface_to_cut surface_to_cut(const Triangulation& t) {
  constexpr std::uint32_t none = CGAL::Intrinsic_triangulations::Gluing::none;
  CGAL::Intrinsic_triangulations::Surface_to_cut s;
  s.gluing.number_of_vertices = t.mesh().number_of_vertices();
  s.side.assign(t.mesh().number_of_halfedges(), none);
  for (const auto f : faces(t.mesh()))
    for (const auto h : t.mesh().sides(f)) {
      s.side[h.index] = static_cast<std::uint32_t>(s.length.size());
      s.gluing.origin.push_back(t.mesh().source(h).index);
      s.length.push_back(t.length(edge(h, t.mesh())));
    }
  s.gluing.glue.assign(s.length.size(), none);
  for (std::uint32_t h = 0; h < s.side.size(); ++h)
    if (s.side[h] != none) s.gluing.glue[s.side[h]] = s.side[h ^ 1U];
  return s;
}

#endif // TEST_INTRINSIC_TRIANGULATIONS_SURFACE_TO_CUT_H
