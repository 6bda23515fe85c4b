// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class SignpostDirections follow_signposts.h <CGAL/Intrinsic_triangulations/correspondence/models/follow_signposts.h>
\cgalConcept

The concept `SignpostDirections` describes a correspondence that stores the directions in which
intrinsic halfedges leave their sources on the input: halfedges are traced as geodesics.

\cgalRefines{\ref ::IntrinsicCorrespondence}

\cgalHasModel{\itc{Signposts}}

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| \itf{trace_edges} | `input`, `target`, `walk` |
| \itf{integer_coordinates} | all |

\cgalHeading{Invariants}

- A geodesic that `walk()` starts meets the target of the halfedge at the halfedge's length, up to
  rounding. A model that breaks this is found out: its halfedges have no path.

\cgalHeading{Complexity}

Constant time for all functions.

The C++20 concept does not require the observer of moves; the triangulation that owns the model does.
*/
class SignpostDirections {
public:
  /// returns the triangulation that the intrinsic one started from.
  const CGAL::Intrinsic_triangulations::Input& input() const;
  /// returns the same, to share it.
  std::shared_ptr<const CGAL::Intrinsic_triangulations::Input> shared_input() const;
  /// tells whether a vertex was inserted.
  bool is_inserted(std::uint32_t vertex) const;
  /// returns where an inserted vertex is on the input.
  const CGAL::Intrinsic_triangulations::Surface_point&
  location(std::uint32_t inserted_vertex) const;
  /// returns a vertex as the end of geodesics on the input.
  CGAL::Intrinsic_triangulations::Geodesic_target target(std::uint32_t vertex) const;
  /// starts an intrinsic halfedge on the input, turned counterclockwise by an angle. Walks are in
  /// scaled units, and no part of the interface for users.
  CGAL::Intrinsic_triangulations::internal::Geodesic_walk<CGAL::Intrinsic_triangulations::Input>
  walk(std::uint32_t halfedge, double turn = 0) const;
};
