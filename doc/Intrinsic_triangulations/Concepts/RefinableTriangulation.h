// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class RefinableTriangulation concepts.h <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
\cgalConcept

The concept `RefinableTriangulation` describes a triangulation whose `Session` inserts, removes and
moves vertices, and whose predicates bound the shapes of faces.

\cgalRefines{\ref ::IntrinsicTriangulation\, \ref ::MeasuredTriangulation\, \ref
::NumberedTriangulation}

\cgalHasModel{\itc{Intrinsic_triangulation} with traits whose metric is a model of \ref ::RefinableMetric}

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| \itf{delaunay_refine}, \itf{adaptive_refine} | `Session::insert_vertex`, `Session::split_edge`, `Session::remove_vertex`, `sign` |
| \itf{insert_polyline} | `Session::insert_vertex`, `Session::split_edge` |
| \itf{odt_optimize} | `Session::split_edge`, `Session::reposition_vertex` |
| \itf{injective_harmonic_map} | `Session::split_edge` |

\cgalHeading{Invariants}

Vertices of the input stay. Elements that a move does not remove keep their numbers. A refused move
changes nothing but the direction of halfedges.

\cgalHeading{Complexity}

The cost is that of the arithmetic; removals also take time linear in the degree of the vertex.
*/
class RefinableTriangulation {
public:
  /// Vertex of the mesh.
  typedef unspecified_type vertex_descriptor;
  /// Halfedge of the mesh.
  typedef unspecified_type halfedge_descriptor;

  /// returns the sign of an expression in the values of faces; see \ref ::EuclideanMetric.
  template <class Expression>
  CGAL::Sign sign(std::span<const CGAL::Intrinsic_triangulations::Indexed_face> faces,
                  const Expression& expression) const;
  /// Also inserts, removes and moves vertices.
  class Session {
  public:
    /// What became of an insertion: a `Move_status status` and the new `vertex`.
    typedef unspecified_type Insertion;
    /// inserts a vertex in the face of a halfedge, given by its weights.
    Insertion insert_vertex(halfedge_descriptor h, const std::array<double, 3>& weights);
    /// inserts a vertex on an edge; the parameter is 0 at the source of `h`.
    Insertion split_edge(halfedge_descriptor h, double parameter);
    /// removes a vertex that was inserted.
    CGAL::Intrinsic_triangulations::Move_status remove_vertex(vertex_descriptor v);
    /// moves a vertex that was inserted.
    Insertion reposition_vertex(vertex_descriptor v, halfedge_descriptor h,
                                const std::array<double, 3>& weights);
  };
};
