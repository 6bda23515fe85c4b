// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CUTS_CUT_TO_DISK_H
#define CGAL_INTRINSIC_GEODESICS_CUTS_CUT_TO_DISK_H

#include <CGAL/Intrinsic_geodesics/cuts/cut_open.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/*!
\file
Short cuts that make disks of surfaces, by a tree and a cotree (Eppstein, Dynamic generators of
topologically embedded graphs, 2003; Erickson and Whittlesey, Greedy optimal homotopy and homology
generators, 2005): a tree of shortest paths from a root, and, in the graph of faces, a spanning tree
over the other edges that prefers those whose loop through the root is long. Each remaining edge
closes a loop. Paths and loops together cut the surface to a disk, and the loops are the shortest
system of loops through the root.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds a surface of triangles with lengths, as arrays by the sides of faces, for
`cut_to_disk()` and for layouts.
*/
struct Surface_to_cut {
  /// The surface, orientable or not, of any number of components.
  Gluing gluing;
  /// The length of each side.
  std::vector<double> length;
  /// Nonzero for each side that must not be cut; one of two sides suffices. Empty: there is none.
  std::vector<char> is_kept{};
  /// Each side as a vector in a frame of its triangle, for layouts: needles lose their shape if it
  /// is computed from rounded lengths, as that would be. Empty: it is.
  std::vector<std::array<double, 2>> vector{};
  /// For each halfedge of the triangulation that it was made of, by its number, the side that it
  /// is; `Gluing::none` on the border. Empty: it was not made of one.
  std::vector<std::uint32_t> side{};

  /// returns a side of an edge of that triangulation. \pre `side` is not empty
  std::uint32_t side_of_edge(std::uint32_t edge) const {
    return side[2 * edge] == Gluing::none ? side[2 * edge + 1] : side[2 * edge];
  }
};

/*!
\brief finds a short cut that makes a disk of each component of a surface.

The cut passes through all borders and given vertices, along edges, and nothing dangles. It starts
from the tree of shortest paths that has all borders and given vertices as roots, and from trees
with one more root each; the shortest cut is kept. (Which cut is the shortest of all is an NP-hard
question.) A disk with a border and without given vertices needs no cut. A closed sphere needs two
vertices: if there are less, vertices far from each other are chosen, so that the cut has two edges
at least.

Where a surface has vertices at which fans of faces meet without a common edge, the fans are taken
apart, as `cut_open()` does.
\param s the surface
\param through vertices that the cut passes through, any number of them; each once or more
\param roots the number of further roots to try; without a border and given vertices it tries one
  at least
\return nonzero for both sides of each edge to cut, which `cut_open()` takes
\throws Invalid_input if sizes disagree, a length is negative or not finite, a vertex does not exist
  or has no face, or sides that must not be cut surround a vertex or the like
\pre `validate(s.gluing)` does not throw
\complexity n log n for each root
*/
std::vector<char> cut_to_disk(const Surface_to_cut& s, std::span<const std::uint32_t> through = {},
                              std::size_t roots = 8);

/*!
\brief finds loops that generate the homology of a surface: 2 g + b - 1 of each component of genus g
  with b borders, 2 g of a closed one.

They are independent, and generate also the fundamental group. All loops of a component are those
of one tree of shortest paths, without the way that a loop goes out and back; of several trees the
one with the shortest loops is kept. A nonorientable closed surface has as many loops as homology
has dimensions over Z/2.
\param s the surface; all its edges may be used
\param roots how many roots are tried, at least one
\return for each loop its sides in order, one of the two of each edge, marked by
  `Gluing::reversed()` where the loop runs from the end of the side to its start
\throws Invalid_input as `cut_to_disk()` does
\pre `validate(s.gluing)` does not throw
\complexity n log n for each root, and linear in the size of the result
*/
std::vector<std::vector<std::uint32_t>> homology_generators(const Surface_to_cut& s,
                                                            std::size_t roots = 8);

namespace internal {

// A mesh by sides of faces, with the length of each edge by its number.
template <class Mesh, class Numbers, class Length>
Surface_to_cut surface_to_cut(const Mesh& mesh, const Numbers& number, const Length& length) {
  Surface_to_cut s;
  s.gluing = numbered_gluing(mesh, number, s.side);
  s.length.resize(s.gluing.origin.size());
  for (std::uint32_t h = 0; h < s.side.size(); ++h)
    if (s.side[h] != Gluing::none) s.length[s.side[h]] = length(h / 2);
  return s;
}

// A triangulation, with its lengths in scaled units.
template <class Triangulation>
Surface_to_cut surface_to_cut(const Triangulation& t) {
  return surface_to_cut(t.mesh(), t.numbers(), [&t](std::uint32_t e) {
    return std::sqrt(t.metric().approximate_squared_length(e));
  });
}

// A cut of its sides as marks of edges.
template <class Triangulation>
Marked_edges<Triangulation> marks_of_cut(const Triangulation& t, const Surface_to_cut& s,
                                         const std::vector<char>& is_cut) {
  Marked_edges<Triangulation> result(t);
  for (const typename Triangulation::edge_descriptor e : edges(t.mesh()))
    if (is_cut[s.side_of_edge(t.index(e))] != 0) put(result, e, true);
  return result;
}

} // namespace internal

/*!
\brief finds a short cut along edges that makes a disk of each component of a triangulated surface;
see the overload for arrays.

`cut_open()` opens the surface there, and `flip_to_geodesic_cut()` makes the cut geodesic.
\tparam Triangulation a model of `NumberedTriangulation`
\tparam VertexRange a range of its vertices
\param t the triangulation; of a cover, the cover is cut
\param through vertices that the cut passes through
\param np optional named parameters:
  - `edge_is_constrained_map(m)`: edges that must not be cut, such as diagonals of polygons.
    Default: none.
  - `maximum_rounds(n)`: how many roots are tried. Default: 8.
\return marks of the edges to cut
\throws Invalid_input see the overload for arrays
*/
template <NumberedTriangulation Triangulation, std::ranges::input_range VertexRange,
          NamedParameters NP = parameters::Parameters<>>
  requires std::convertible_to < std::ranges::range_value_t<VertexRange>,
typename Triangulation::vertex_descriptor >
    Marked_edges<Triangulation> cut_to_disk(const Triangulation& t, const VertexRange& through,
                                            const NP& np = parameters::default_values()) {
  using Edge = typename Triangulation::edge_descriptor;
  internal::expect_names<internal::tags::edge_is_constrained_map, internal::tags::maximum_rounds>(
      np);
  std::vector<std::uint32_t> vertices;
  Surface_to_cut s = internal::surface_to_cut(t);
  for (const typename Triangulation::vertex_descriptor v : through)
    vertices.push_back(t.numbers().vertex(v));
  const auto kept = internal::constrained_map<Edge>(np);
  s.is_kept.assign(s.length.size(), 0);
  for (const Edge e : edges(t.mesh()))
    if (get(kept, e)) s.is_kept[s.side_of_edge(t.index(e))] = 1;
  return internal::marks_of_cut(
      t, s,
      cut_to_disk(s, vertices,
                  internal::value_or<internal::tags::maximum_rounds>(np, std::size_t{8})));
}

/// finds a short cut that makes a disk of each component of a triangulated surface; see above.
template <NumberedTriangulation Triangulation>
Marked_edges<Triangulation> cut_to_disk(const Triangulation& t) {
  return cut_to_disk(t, std::vector<typename Triangulation::vertex_descriptor>());
}

/*!
\brief finds loops along edges that generate the homology of a triangulated surface; see the
overload for arrays.

Loops of one triangulation meet; to shorten one to a geodesic, add it alone to a `Curve_network`.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\param np optional named parameters:
  - `maximum_rounds(n)`: how many roots are tried. Default: 8.
\return the halfedges of each loop, which `Curve_network::add_loop()` takes
\throws Invalid_input see the overload for arrays
*/
template <NumberedTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
std::vector<std::vector<typename Triangulation::halfedge_descriptor>>
homology_generators(const Triangulation& t, const NP& np = parameters::default_values()) {
  internal::expect_names<internal::tags::maximum_rounds>(np);
  const Surface_to_cut s = internal::surface_to_cut(t);
  std::vector<std::uint32_t> halfedge(s.length.size());
  for (std::uint32_t h = 0; h < s.side.size(); ++h)
    if (s.side[h] != Gluing::none) halfedge[s.side[h]] = h;
  std::vector<std::vector<typename Triangulation::halfedge_descriptor>> result;
  for (const std::vector<std::uint32_t>& loop : homology_generators(
           s, internal::value_or<internal::tags::maximum_rounds>(np, std::size_t{8}))) {
    result.emplace_back();
    for (const std::uint32_t entry : loop) {
      const std::uint32_t h = halfedge[Gluing::partner(entry)];
      result.back().push_back(t.numbers().halfedge_at(Gluing::is_reversed(entry) ? h ^ 1U : h));
    }
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_CUTS_CUT_TO_DISK_H
