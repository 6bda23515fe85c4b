// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CUTS_CUT_OPEN_H
#define CGAL_INTRINSIC_GEODESICS_CUTS_CUT_OPEN_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a surface that was cut open along edges.

Faces, and sides of faces, keep their numbers. The sides of a cut edge are glued to nothing. Where
the cuts divide the faces at a vertex into several fans, each fan has a vertex of its own.
*/
struct Opened_surface {
  /// The surface. `gluing.origin` is the vertex at each corner.
  Gluing gluing;
  /// The vertex before the cut that each vertex is a copy of. A vertex before the cut is its own
  /// first copy; other copies have the numbers after.
  std::vector<std::uint32_t> original_vertex;
  /// The two sides of each cut edge: a side, and the entry that it had in `Gluing::glue`, which is
  /// marked if the gluing is along the direction of both.
  std::vector<std::array<std::uint32_t, 2>> seams;
  /// For each halfedge of the triangulation that was cut open, by its number, the side that it is;
  /// `Gluing::none` on the border. The vertex at the source of halfedge h is
  /// `gluing.origin[side[h]]`. Empty if a `Gluing` was cut open.
  std::vector<std::uint32_t> side{};
};

/*!
\brief cuts a surface open along edges.

A vertex with n cut edges becomes n vertices, one on the border n + 1; if one cut ends at a vertex
inside, it stays one vertex. A vertex where fans meet that share no edge is divided, too. The
surface need not be orientable.
\param g the surface
\param is_cut nonzero for each side to cut; one of the two sides of an edge suffices, and sides on
  the border change nothing
\return the surface cut open
\pre `validate(g)` does not throw
\throws Invalid_input if there is not one mark for each side
\complexity linear
*/
Opened_surface cut_open(const Gluing& g, const std::vector<char>& is_cut);

namespace internal {

// The connectivity of a mesh as a gluing: faces in the order of iteration, vertices by number.
// Sets `side` to the side that each halfedge is.
template <class Mesh, class Numbers>
Gluing numbered_gluing(const Mesh& mesh, const Numbers& number, std::vector<std::uint32_t>& side) {
  Gluing g;
  g.number_of_vertices = number.vertex_capacity(mesh);
  side.assign(2 * std::size_t{number.edge_capacity(mesh)}, Gluing::none);
  for (const auto f : faces(mesh)) {
    auto h = halfedge(f, mesh);
    for (unsigned k = 0; k < 3; ++k, h = next(h, mesh)) {
      side[number.halfedge(h)] = static_cast<std::uint32_t>(g.origin.size());
      g.origin.push_back(number.vertex(source(h, mesh)));
    }
  }
  g.glue.assign(g.origin.size(), Gluing::none);
  for (std::size_t h = 0; h < side.size(); ++h)
    if (side[h] != Gluing::none) g.glue[side[h]] = side[h ^ 1U];
  return g;
}

} // namespace internal

/*!
\brief cuts an intrinsic triangulation open along marked edges.
\tparam Triangulation a model of `NumberedTriangulation`
\tparam EdgeIsMarked a readable property map from its edges to `bool`, or to labels of which 0 is
  none: `Curve_network::edge_is_constrained_map()`, `Marked_edges`
\param t the triangulation
\param is_marked is true for the edges to cut
\return faces in the order of `faces(t.mesh())`, side 0 of a face is its halfedge; vertices before
  the cut have their numbers in `t`
\complexity linear
*/
template <NumberedTriangulation Triangulation, class EdgeIsMarked>
  requires requires(const EdgeIsMarked& map, typename Triangulation::edge_descriptor e) {
    { get(map, e) } -> std::convertible_to<bool>;
  }
Opened_surface cut_open(const Triangulation& t, const EdgeIsMarked& is_marked) {
  std::vector<std::uint32_t> side;
  const Gluing g = internal::numbered_gluing(t.mesh(), t.numbers(), side);
  std::vector<char> is_cut(g.origin.size(), 0);
  for (const auto e : edges(t.mesh()))
    if (static_cast<bool>(get(is_marked, e)))
      for (const std::uint32_t h : {2 * t.index(e), 2 * t.index(e) + 1})
        if (side[h] != Gluing::none) is_cut[side[h]] = 1;
  Opened_surface result = cut_open(g, is_cut);
  result.side = std::move(side);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_CUTS_CUT_OPEN_H
