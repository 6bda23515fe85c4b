// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class NormalCoordinates normal_coordinates.h <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
\cgalConcept

The concept `NormalCoordinates` describes curves on triangles by the number of curves that cross
each edge (§3.5.1 of the course).

\cgalHasModel{all models of \ref ::CurveCoordinates}

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| \itf{corner_coordinates}, \itf{first_crossing}, \itf{follow_curve}, \itf{follow_curves} | all |

\cgalHeading{Invariants}

The first two of \ref ::CurveCoordinates.

\cgalHeading{Complexity}

Constant time.
*/
class NormalCoordinates {
public:
  /// returns how many curves cross an edge; -1 if one runs along it.
  CGAL::Intrinsic_triangulations::Normal_coordinate normal_coordinate(std::uint32_t edge) const;
};
