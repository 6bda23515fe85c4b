// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_DOMAIN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_DOMAIN_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/signed_incidence.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// Kinds of surfaces that `make_domain()` makes of triangles.
enum class Domain_kind {
  automatic,         ///< the first of the others that the triangles allow
  manifold,          ///< the triangles themselves, oriented
  orientation_cover, ///< both sides of every triangle, glued where two triangles meet
  tufted_cover,      ///< both sides of every triangle, glued around every edge, without border
  closed ///< the first of `manifold`, `orientation_cover` and `tufted_cover` that has no border
};

/*!
\brief reports which surface was made of triangles, and why.
*/
struct Domain_report {
  /// The kind of the surface: never `automatic` or `closed`.
  Domain_kind kind = Domain_kind::manifold;
  /// The reason in words. It names the edge and its faces, by their numbers before polygons were
  /// triangulated.
  std::string reason;
  /// Number of sheets over each face: 2 for covers.
  std::uint32_t sheets = 1;
  /// Number of edges with more than two faces.
  std::size_t nonmanifold_edges = 0;
  /// Number of edges with two faces that run along the edge in the same direction, as they were
  /// given.
  std::size_t unoriented_edges = 0;
};

/*!
\brief holds what a triangulation can be built from, and a report of how it was made.
*/
struct Domain {
  Intrinsic_input input; ///< the surface, to be moved into an `Intrinsic_triangulation`
  Domain_report report;  ///< what it is, and why
};

/*!
\brief makes a surface of any triangles in space (§6.1 of the course).

Edges may have any number of faces, faces any orientation; faces may be repeated, vertices isolated.
Edges are matched by their end vertices.

- If every edge has at most two faces, and they can be oriented consistently, the surface is the
  triangles.
- If every edge has at most two faces, but the surface has only one side, as a Moebius strip, it is
  the orientation double cover: a front and a back of each face; two of them are glued where the
  faces meet.
- Else it is the tufted cover: around each edge, in the order of their angles, the side of each face
  that looks at the next face is glued to the side of that which looks back. A single face is glued
  to its own back. Angles that differ by less than 2^-30 count as equal, so that rounding of
  coordinates decides nothing: such faces follow each other in the order of their numbers. Repeated
  faces go around once more: if every face occurs r times, the Laplacian is r times as large.

Covers are oriented manifolds, so that all algorithms run on them unchanged. Covers split each
vertex into one per neighbourhood. Matrices still have one row per user's vertex
(`Intrinsic_triangulation::input_vertex()`) and are divided by the number of sheets, so that they
are those of the triangles. `delaunay_refine()` inserts all copies of a point together. The front
and the back of face `f` of the soup are faces `2f` and `2f + 1` by name. A tufted cover has no
border: with exact traits, no weight of its Delaunay Laplacian is negative.

The tufted cover of an oriented surface without border is two copies of it. The surface itself has
the same Laplacian and mass matrix and takes less than half of the time. `Domain_kind::closed`
therefore makes the simplest surface without border; its matrices are those of the tufted cover.

\param soup points and triangles, see `triangle_soup()` and `read_triangle_soup()`
\param kind the kind of surface
\param mollification treatment of degenerate faces
\throws Invalid_input naming the element if a face repeats a vertex or has one out of range, a
  coordinate is not finite, or if the triangles do not allow the kind: `manifold` needs edges of at
  most two faces that agree, `orientation_cover` edges of at most two faces
\complexity linear for edges with a bounded number of faces
*/
Domain make_domain(Triangle_soup soup, Domain_kind kind = Domain_kind::automatic,
                   Mollification mollification = Mollification::automatic);

/*!
\brief makes a surface of triangles that are already glued: orients it, or makes a cover of it.

See above. The edges are those of the gluing, which may have squared lengths in place of points.
`Intrinsic_input(mesh)` makes such an input from a mesh and triangulates its polygons.
\param input the glued triangles, oriented or not
\param kind the kind of surface
\throws Invalid_input naming the edge if `kind` is `manifold` and the surface has only one side
\complexity linear
*/
Domain make_domain(Intrinsic_input input, Domain_kind kind = Domain_kind::automatic);

/*!
\brief makes a surface of triangles with lengths, which need not lie in space.

See above. Edges are matched by their end vertices. Lengths alone do not determine the order of more
than two faces around an edge: the tufted cover takes that of their numbers.
\param number_of_vertices how many vertices there are
\param triangles their corners
\param lengths of the sides of each triangle, from each corner to the next
\param kind the kind of surface
\param mollification treatment of degenerate faces
\throws Invalid_input as for a soup; if there are more or fewer lengths than triangles;
  or naming a face with a side that differs in length from another side of its edge, or whose length
  is negative or not a number
\complexity linear
*/
Domain make_domain(std::uint32_t number_of_vertices,
                   const std::vector<std::array<std::uint32_t, 3>>& triangles,
                   const std::vector<std::array<double, 3>>& lengths,
                   Domain_kind kind = Domain_kind::automatic,
                   Mollification mollification = Mollification::automatic);

/*!
\brief makes a surface of triangles with lengths that are glued already.

See above. Sides may be glued whose ends are others, or the sides of one triangle.
\param mesh the glued triangles, oriented or not
\param lengths of the sides of each triangle, from each corner to the next
\param kind the kind of surface
\param mollification treatment of degenerate faces
\throws Invalid_input naming a face with a side that differs in length from the other side of its
  edge, or whose length is negative or not a number; or the edge if `kind` is `manifold` and the
  surface has only one side; and if there is not one triple of lengths for each triangle
\complexity linear
*/
Domain make_domain(Gluing_map mesh, const std::vector<std::array<double, 3>>& lengths,
                   Domain_kind kind = Domain_kind::automatic,
                   Mollification mollification = Mollification::automatic);

/*!
\brief makes a surface of signed incidence matrices and lengths: any number of faces may meet at an
edge, and edges may share their ends, or be loops.

Lengths alone do not determine the order of more than two faces around an edge: the tufted cover
takes the order of the entries of the edge's column in `Signed_incidence::edge_face`.
\param s the matrices
\param squared_lengths one per edge of `s`
\param kind the kind of surface
\param mollification treatment of degenerate faces
\throws Invalid_input as `gluing_from_incidence()`; if there are more or fewer lengths than edges;
  or naming an edge with more than two faces if the kind does not allow it
\complexity linear
*/
Domain make_domain(const Signed_incidence& s, std::vector<double> squared_lengths,
                   Domain_kind kind = Domain_kind::automatic,
                   Mollification mollification = Mollification::automatic);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_DOMAIN_H
