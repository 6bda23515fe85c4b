// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class IntegerCorrespondence Vertex_places.h <CGAL/Intrinsic_triangulations/correspondence/models/Vertex_places.h>
\cgalConcept

The concept `IntegerCorrespondence` describes a correspondence that has integer coordinates. An exact
metric uses these in place of its own, and a file without exact values stores them.

\cgalRefines{\ref ::IntrinsicCorrespondence}

\cgalHasModel{\itc{Integer_coordinates}\, \itc{Explicit_crossings}}

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| `places()`, \itf{write_intrinsic_triangulation}, moves and predicates of exact traits | `integer_coordinates`, if the model has it |
| \itf{certify_delaunay} of an ideal triangulation | `integer_coordinates` |

\cgalHeading{Invariants}

The coordinates observe all moves: `before()` and `after()` of the model call theirs.

\cgalHeading{Complexity}

Constant time. The C++20 concept does not require the observer of moves; the triangulation that owns
the model does.
*/
class IntegerCorrespondence {
public:
  /// returns the coordinates.
  const CGAL::Intrinsic_triangulations::Integer_coordinates& integer_coordinates() const;
};
