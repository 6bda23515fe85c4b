// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_SUBDIVISION_EDGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_SUBDIVISION_EDGES_H

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/*!
\file
The edges of a common subdivision, and how they make up those of the intrinsic triangulation and of
the input.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Bound of the numbers of intrinsic edges that have sides.
std::size_t intrinsic_edge_bound(const Common_subdivision& s);

} // namespace internal

/*!
\brief visits each edge of a common subdivision once, in the order of its faces.

It visits the side of an edge that leads to the greater vertex. This would miss border edges and
loops; but these, and all others between vertices of the intrinsic triangulation, are whole
intrinsic edges: there it visits the first side.
\tparam Visitor a function object with `operator()(std::uint32_t source, std::uint32_t target, const
  Common_subdivision::Side&)`
\param s the subdivision
\param visit called with the ends of the edge and what lies along it
\pre `s` is the common subdivision of two triangulations
\complexity linear
*/
template <std::invocable<std::uint32_t, std::uint32_t, const Common_subdivision::Side&> Visitor>
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

/*!
\brief holds for each edge of one triangulation the vertices of a common subdivision along it, one
after another.
*/
struct Edge_polylines {
  /// For each number of an edge the index of its first vertex, and one entry more.
  std::vector<std::size_t> begin{0};
  /// The vertices; unused numbers have none.
  std::vector<std::uint32_t> vertices;

  /// returns the bound of the numbers of edges.
  std::size_t size() const { return begin.size() - 1; }
  /// returns the vertices along edge `e`; empty if there is no edge of this number.
  std::span<const std::uint32_t> operator[](std::size_t e) const {
    return {vertices.data() + begin[e], begin[e + 1] - begin[e]};
  }
};

/*!
\brief chains the vertices of a common subdivision along each intrinsic edge (§3.6 of the course).

An edge with crossings has the direction of their locations, from `vertices[0]` to `vertices[1]`;
one without runs from its smaller vertex to the greater one.
\param s the subdivision
\pre `s` is the common subdivision of two triangulations
\return the polylines; polylines of interior edges, and those of the border
\complexity linear if crossings are numbered along the edges, as `common_subdivision()` does
*/
Edge_polylines intrinsic_edge_polylines(const Common_subdivision& s);

/*!
\brief chains the vertices of a common subdivision along each edge of the input (§3.6 of the
course): crossings, and vertices that were inserted on it.

An edge with crossings has the direction of their locations; one without runs from its smaller end
to the greater one.
\param s the subdivision
\pre `s` is the common subdivision of two triangulations
\return the polylines, by the numbers that edges have in the input
\complexity linear, with a factor logarithmic in the number of crossings of a single edge
*/
Edge_polylines input_edge_polylines(const Common_subdivision& s);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_SUBDIVISION_EDGES_H
