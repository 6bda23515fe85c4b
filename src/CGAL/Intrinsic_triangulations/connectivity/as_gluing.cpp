// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

Gluing gluing_from_map(const Gluing_map& map) {
  if (map.has_garbage()) return gluing_from_map(gluing_map_from_face_graph(map));
  Gluing g;
  g.number_of_vertices = map.number_of_vertices();
  std::vector<std::uint32_t> corner(map.number_of_halfedges(), Gluing::none);
  for (std::uint32_t f = 0; f < map.number_of_faces(); ++f) {
    for (const Gluing_map::Halfedge h : map.sides({f})) {
      corner[h.index] = static_cast<std::uint32_t>(g.origin.size());
      g.origin.push_back(map.source(h).index);
    }
  }
  g.glue.assign(g.origin.size(), Gluing::none);
  for (std::uint32_t h = 0; h < map.number_of_halfedges(); ++h) {
    const std::uint32_t o = Gluing_map::opposite({h}).index;
    if (corner[h] == Gluing::none || corner[o] == Gluing::none) continue;
    g.glue[corner[h]] = map.is_reversed({h / 2}) ? Gluing::reversed(corner[o]) : corner[o];
  }
  return g;
}

} // namespace CGAL::Intrinsic_triangulations
