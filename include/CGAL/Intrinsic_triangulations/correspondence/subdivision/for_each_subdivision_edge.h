// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_FOR_EACH_SUBDIVISION_EDGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_FOR_EACH_SUBDIVISION_EDGE_H

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/intrinsic_edge_polylines.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief visits each edge of a common subdivision once, in the order of its faces.

Of the two sides of an edge the one that leads to the greater vertex is visited. That would miss
edges of the border and loops: but these, and all others between vertices of the intrinsic
triangulation, are whole intrinsic edges, of which the first side is visited.
\tparam Visitor a function object with `operator()(std::uint32_t source, std::uint32_t target, const
  Common_subdivision::Side&)`
\param s the subdivision
\param visit is called with the ends of the edge and what lies along it
\pre `s` is the common subdivision of two triangulations
\complexity linear
*/
template <class Visitor>
void for_each_subdivision_edge(const Common_subdivision& s, Visitor visit) {
  std::vector<bool> visited(internal::intrinsic_edge_bound(s), false);
  for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
    const std::span<const std::uint32_t> face = s.face(f);
    const std::span<const Common_subdivision::Side> sides = s.sides(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::uint32_t source = face[k], target = face[k + 1 == face.size() ? 0 : k + 1];
      const std::uint32_t e = sides[k].intrinsic_edge;
      const bool is_whole =
          e != Common_subdivision::none && source < s.vertices.size() && target < s.vertices.size();
      if (is_whole ? visited[e] : source > target) continue;
      if (is_whole) visited[e] = true;
      visit(source, target, sides[k]);
    }
  }
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_FOR_EACH_SUBDIVISION_EDGE_H
