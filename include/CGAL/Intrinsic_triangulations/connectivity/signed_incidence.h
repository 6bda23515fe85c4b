// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_SIGNED_INCIDENCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_SIGNED_INCIDENCE_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is an entry of a sparse matrix: `sign` at `row`, `column`.
*/
struct Incidence_entry {
  /// Row.
  std::uint32_t row = 0;
  /// Column.
  std::uint32_t column = 0;
  /// +1 or -1.
  int sign = 0;

  /// compares entries.
  friend bool operator==(const Incidence_entry&, const Incidence_entry&) = default;
};

/*!
\brief holds the signed incidence matrices of a triangulated surface (§2.2 of the course) as lists
of entries.

Entries at the same place are kept apart, never summed. A loop has both +1 and -1 at its vertex, and
an edge along which a face is glued to itself has two entries in the row of that face: sums would be
zero, and the complex lost. A sparse matrix library that sums entries gives the boundary operators.
*/
struct Signed_incidence {
  /// Number of vertices, isolated ones included.
  std::uint32_t number_of_vertices = 0;
  /// Number of edges.
  std::uint32_t number_of_edges = 0;
  /// Number of faces.
  std::uint32_t number_of_faces = 0;
  /// One row per edge, one column per vertex: -1 where the edge starts, +1 where it ends.
  std::vector<Incidence_entry> vertex_edge;
  /// One row per face, one column per edge, +1 where the face runs along the edge, -1 where against
  /// it. The entries of a row are in cyclic order around the face. Where more than two faces meet
  /// at an edge, the entries of its column are in cyclic order around the edge.
  std::vector<Incidence_entry> edge_face;
};

/*!
\brief lists the signed incidences of a mesh.

Edge `e` starts at the source of its halfedge. Elements are numbered in the order of iteration.
\tparam Mesh a model of `MutableDeltaComplex`; a `Gluing_map` need not be oriented
\param mesh the mesh
\pre the mesh has the invariants of the concept
\complexity linear
*/
template <ReadableFaceGraph Mesh>
Signed_incidence incidence(const Mesh& mesh) {
  const internal::As_gluing_map read(mesh);
  const Gluing_map& m = *read;
  Signed_incidence s{m.number_of_vertices(), m.number_of_edges(), m.number_of_faces(), {}, {}};
  s.vertex_edge.reserve(2 * std::size_t{s.number_of_edges});
  s.edge_face.reserve(3 * std::size_t{s.number_of_faces});
  for (std::uint32_t e = 0; e < s.number_of_edges; ++e) {
    s.vertex_edge.push_back({e, m.source({2 * e}).index, -1});
    s.vertex_edge.push_back({e, m.target({2 * e}).index, +1});
  }
  for (std::uint32_t f = 0; f < s.number_of_faces; ++f) {
    for (const Gluing_map::Halfedge h : m.sides({f})) {
      const bool along = h.index % 2 == 0 || m.is_reversed({h.index / 2});
      s.edge_face.push_back({f, h.index / 2, along ? +1 : -1});
    }
  }
  return s;
}

/*!
\brief builds a gluing from signed incidence matrices.

The entries may come in any order. Sides of a face that are not in cyclic order are put in order by
their end vertices; if all three sides are loops at one vertex, the order of the entries in the row
counts. Two sides with the same sign at their edge are glued along their direction (see
`Gluing::reversed()`).
\param s the matrices
\param edge_of_halfedge is set to the edge that each halfedge `3f + k` of the result comes from: a
  `Gluing_map` numbers edges anew
\throws Invalid_input naming the edge that does not have one start, one end and one or two faces
  (`make_domain()` takes more), or the face that does not have three sides that run around it
\complexity linear
*/
Gluing gluing_from_incidence(const Signed_incidence& s,
                             std::vector<std::uint32_t>& edge_of_halfedge);

/*!
\brief builds a gluing from signed incidence matrices: see the overload with `edge_of_halfedge`.
*/
Gluing gluing_from_incidence(const Signed_incidence& s);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_SIGNED_INCIDENCE_H
