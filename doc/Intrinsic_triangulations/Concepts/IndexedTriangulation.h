// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class IndexedTriangulation concepts.h <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
\cgalConcept

The concept `IndexedTriangulation` describes a triangulation that finds its elements by numbers, and
whose input names its elements. It has any metric.

\cgalHasModel{\itc{Intrinsic_triangulation}}

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| \itf{edge_crossings}, \itf{weighted_vertices} | `index`, `numbers`, `input` |
| \itf{common_subdivision}, \itf{ideal_crossing_parameters} with an ideal hyperbolic metric | also `input_vertex` |
| \itf{delaunay_tessellation} | `index`, `numbers`, `input`; also what \itf{check_delaunay} needs of \ref ::IntrinsicTriangulation |

\cgalHeading{Invariants}

Halfedges `2e` and `2e + 1` are the sides of edge `e`.

\cgalHeading{Complexity}

Constant time for everything.
*/
class IndexedTriangulation {
public:
  /// The connectivity: the part of \ref ::MutableDeltaComplex that reads.
  typedef unspecified_type Mesh;
  /// Vertex of the mesh.
  typedef unspecified_type vertex_descriptor;
  /// Halfedge of the mesh.
  typedef unspecified_type halfedge_descriptor;
  /// Edge of the mesh.
  typedef unspecified_type edge_descriptor;
  /// Face of the mesh.
  typedef unspecified_type face_descriptor;

  /// returns the connectivity.
  const Mesh& mesh() const;
  /// returns the number of a vertex.
  std::uint32_t index(vertex_descriptor v) const;
  /// returns the number of an edge.
  std::uint32_t index(edge_descriptor e) const;
  /// returns the number of a face.
  std::uint32_t index(face_descriptor f) const;
  /// returns the row of a vertex in matrices: its number in the user's mesh, or one that follows
  /// those.
  std::uint32_t input_vertex(vertex_descriptor v) const;
  /// returns the number of vertices, which is that of rows.
  std::uint32_t number_of_vertices() const;
  /// returns what defines the surface that the triangulation was built from, for the names of its
  /// elements.
  const CGAL::Intrinsic_triangulations::Input_definition& input() const;
  /// tells whether a vertex was inserted.
  bool is_inserted(vertex_descriptor v) const;
  /// returns the numbers of elements, by `vertex(v)`, `halfedge(h)`, `face(f)`; the elements with
  /// given numbers, by `vertex_at(i)`, `halfedge_at(i)`, `face_at(i)`; and bounds:
  /// `vertex_capacity(mesh)`, `edge_capacity(mesh)`, `face_capacity(mesh)`.
  unspecified_type numbers() const;
};
