// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>

#include <boost/graph/graph_traits.hpp>

#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// One end of a side of a face. Turning from the end of one side to that of the next visits the
// faces around a vertex. This also works if gluings reverse the orientation and border halfedges do
// not have a successor.
struct Side_end {
  Gluing_map::Halfedge side;
  bool at_target;

  // the end of the other side of the face at the same corner
  Side_end across_corner(const Gluing_map& m) const {
    return at_target ? Side_end{m.next(side), false} : Side_end{m.next(m.next(side)), true};
  }
  // the same end of the same edge, seen from the face on the other side
  Side_end across_edge(const Gluing_map& m) const {
    return {Gluing_map::opposite(side), at_target == m.is_reversed({side.index / 2})};
  }
  bool is_on_border(const Gluing_map& m) const {
    return m.face(Gluing_map::opposite(side)).index == Gluing::none;
  }
};

// marks the corners met by turning from `end` until the border or a marked corner; a corner is
// named by the halfedge that starts there
static void mark_umbrella(const Gluing_map& m, Side_end end, std::vector<char>& marked) {
  while (!end.is_on_border(m)) {
    const Side_end entered = end.across_edge(m), left = entered.across_corner(m);
    char& mark = marked[entered.at_target ? left.side.index : entered.side.index];
    if (mark != 0) return;
    mark = 1;
    end = left;
  }
}

std::vector<std::uint32_t> umbrellas_of_vertices(const Gluing_map& m) {
  std::vector<std::uint32_t> count(m.number_of_vertices(), 0);
  std::vector<char> marked(m.number_of_halfedges(), 0);
  for (std::uint32_t h = 0; h < m.number_of_halfedges(); ++h) {
    if (marked[h] != 0 || m.face({h}).index == Gluing::none) continue;
    marked[h] = 1;
    ++count[m.source({h}).index];
    mark_umbrella(m, {{h}, false}, marked);
    mark_umbrella(m, Side_end{{h}, false}.across_corner(m), marked);
  }
  return count;
}

std::vector<std::uint32_t> border_of_loops(const Gluing_map& m) {
  std::vector<std::uint32_t> loops;
  std::vector<char> marked(m.number_of_edges(), 0);
  for (std::uint32_t h = 0; h < m.number_of_halfedges(); ++h) {
    if (m.face({h}).index != Gluing::none || marked[h / 2] != 0) continue;
    loops.push_back(h);
    Side_end end{Gluing_map::opposite({h}), true};
    while (marked[end.side.index / 2] == 0) {
      marked[end.side.index / 2] = 1;
      Side_end turned = end.across_corner(m);
      while (!turned.is_on_border(m)) turned = turned.across_edge(m).across_corner(m);
      end = {turned.side, !turned.at_target}; // walk along the border edge to its other end
    }
  }
  return loops;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
