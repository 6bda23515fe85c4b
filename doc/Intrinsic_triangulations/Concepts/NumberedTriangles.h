// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class NumberedTriangles concepts.h <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
\cgalConcept

The concept `NumberedTriangles` describes triangles that are read by the numbers of their sides.
Halfedges `2e` and `2e + 1` are the sides of edge `e`. Integers can be followed from face to face by
that alone.

\cgalHasModel{all models of \ref ::NumberedComplex}

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| \itf{sides_of_face}, \itf{corner_coordinates}, \itf{follow_curve}, \itf{follow_curves} | all |

\cgalHeading{Complexity}

Constant time.
*/
class NumberedTriangles {
public:
  /// returns the halfedge after `h` in its face.
  std::uint32_t next(std::uint32_t h) const;
};
