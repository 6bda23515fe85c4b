// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class GeodesicTriangulation GeodesicTriangulation.h <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
\cgalConcept

The concept `GeodesicTriangulation` describes a triangulation in which algorithms can make curves
along edges geodesic: it compares angles at a vertex with pi, and takes flips back.

\cgalRefines{IntrinsicTriangulation, NumberedTriangulation}

\cgalHasModel{\itc{Intrinsic_triangulation}}

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| \itc{Curve_network}, \itf{curve_labels} | `length`, numbers |
| \itc{Edge_path_finder} | numbers and values of \ref ::NumberedTriangulation |
| \itf{shorten_curves} | `flip_status`, `flip_convex_edge`, `compare_angle_to_pi`; with a \itc{Flip_log} also `before_flip` |
| \itf{is_geodesic} | `compare_angle_to_pi` |
| \itc{Flip_log} | `before_flip`, `undo_flip` |

\cgalHeading{Complexity}

Flips take the time of those of \ref ::IntrinsicTriangulation. A comparison of an angle usually
takes time linear in the number of its faces.
*/
class GeodesicTriangulation {
public:
  /// returns the length of an edge, in the units of the input.
  double length(edge_descriptor e) const;

  /// Makes moves.
  class Session {
  public:
    /// What is needed to take a flip back.
    typedef unspecified_type Before_flip;
    /// compares the angle at the target of `h` from `h` to `g`, on the left of `h`, with pi.
    /// \pre no border is in between
    Comparison_result compare_angle_to_pi(halfedge_descriptor h, halfedge_descriptor g) const;
    /// tells whether an edge can be flipped, and if not, why: `done` means that it can.
    Move_status flip_status(halfedge_descriptor h) const;
    /// flips an edge. \pre `flip_status(h)` is `done`
    Move_status flip_convex_edge(halfedge_descriptor h);
    /// returns what a flip of an edge will replace.
    Before_flip before_flip(halfedge_descriptor h) const;
    /// takes back the flip of `h`, the last move; must not throw.
    /// \pre `before` is what `before_flip(h)` returned before it
    void undo_flip(halfedge_descriptor h, Before_flip before) noexcept;
  };
};
