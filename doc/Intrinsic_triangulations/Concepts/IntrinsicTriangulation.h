// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class IntrinsicTriangulation concepts.h <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
\cgalConcept

The concept `IntrinsicTriangulation` describes what algorithms need to flip edges of a
triangulation: its mesh, numbers for its edges, predicates in a `Const_session` and flips in a
`Session`.

The concept requires no lengths. So models may store none, may triangulate hyperbolic surfaces, or
may define Delaunay edges in another way.

\cgalHasModel{\itc{Intrinsic_triangulation}\, \itc{Integer_only_triangulation}}

\cgalHeading{Types}

`Mesh`, `Metric`, `halfedge_descriptor`, `edge_descriptor`, `Const_session` and `Session`, below.

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| \itf{flip_to_delaunay} | `mesh`, `index`, `Metric::is_exact`, `Session::is_locally_delaunay`, `Session::flip_non_delaunay_edge`, `Session::suspended` |
| \itf{is_delaunay} | `mesh`, `Const_session::is_locally_delaunay` |
| \itf{check_delaunay} | `mesh`, `Const_session::delaunay_sign` |
| \itf{certify_delaunay} | an \itc{Integer_only_triangulation}, or an \itc{Intrinsic_triangulation} that is a model of \ref ::CorrespondingTriangulation |
| measures and operators | \ref ::MeasuredTriangulation, which requires no flips |
| refinement | \ref ::RefinableTriangulation |
| queries, common subdivisions | \ref ::CorrespondingTriangulation |

\cgalHeading{Invariants}

- The mesh is a valid Delta-complex.
- Flips change neither the set of its elements nor their numbers.
- An edge with the same face on both sides, or with one face, counts as locally Delaunay.

\cgalHeading{Complexity}

All functions take constant time, if the arithmetic does.
*/
class IntrinsicTriangulation {
public:
  /// The connectivity: the part of \ref ::MutableDeltaComplex that reads.
  typedef unspecified_type Mesh;
  /// Has a constant `static bool is_exact`: whether predicates are exact.
  typedef unspecified_type Metric;
  /// Halfedge of the mesh.
  typedef unspecified_type halfedge_descriptor;
  /// Edge of the mesh.
  typedef unspecified_type edge_descriptor;

  /// Decides predicates; constructed from a const reference to the triangulation.
  class Const_session {
  public:
    /// tells whether the angles opposite an edge sum to at most pi.
    bool is_locally_delaunay(halfedge_descriptor h) const;
    /*!
    \brief returns the sign of pi minus the angles opposite an edge.
    \pre the edge has two different faces
    */
    CGAL::Sign delaunay_sign(halfedge_descriptor h) const;
    /// calls `f` in the default floating point environment and returns what it returns.
    template <class Function>
    auto suspended(Function f) const;
  };

  /// Decides predicates, as `Const_session` does, and makes flips; constructed from a reference to
  /// the triangulation.
  class Session : public Const_session {
  public:
    /*!
    \brief flips an edge; `h` turns clockwise. Returns `done`, or why the arithmetic refused.
    \pre `!is_locally_delaunay(h)`
    */
    CGAL::Intrinsic_triangulations::Move_status flip_non_delaunay_edge(halfedge_descriptor h);
  };

  /// returns the connectivity.
  const Mesh& mesh() const;
  /// returns the number of an edge: from 0, dense, unchanged by flips.
  std::uint32_t index(edge_descriptor e) const;
};
