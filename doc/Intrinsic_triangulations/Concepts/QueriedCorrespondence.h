// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class QueriedCorrespondence CorrespondingTriangulation.h <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
\cgalConcept

The concept `QueriedCorrespondence` describes a correspondence that answers queries itself. A model of
\ref ::CurveCoordinates need not: \itc{Curve_queries} does it for all of these.

\cgalRefines{\ref ::IntrinsicCorrespondence}

\cgalHasModel{\itc{Signposts}}

\cgalHeading{Which operation needs what}

All queries, see \ref ::CorrespondingTriangulation, need both.

\cgalHeading{Invariants and complexity}

Those of the functions of \itc{Curve_queries}. The C++20 concept does not require the observer of
moves; the triangulation that owns the model does.
*/
class QueriedCorrespondence {
public:
  /// returns the triangulation that the intrinsic one started from.
  const CGAL::Intrinsic_triangulations::Input& input() const;
  /// returns an object with the functions of \itc{Curve_queries}, for queries about `t`.
  template <class Triangulation>
  unspecified_type queries(const Triangulation& t) const;
};
