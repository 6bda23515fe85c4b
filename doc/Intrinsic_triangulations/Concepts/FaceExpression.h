// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class FaceExpression Recorded_expression.h <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
\cgalConcept

The concept `FaceExpression` describes a formula in the values of some faces, three squared lengths
and the quadruple area of each. A query of several triangles, such as on which side of a line a
vertex is, is the sign of one.

\cgalRefines{CopyConstructible}

\cgalHasModel{\itc{Recorded_face_expression}}

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| `sign()` of faces of a metric with intervals | the call with `Interval_nt<false>` |
| `sign()` of faces of an exact metric | also the call with \itc{Recorded_number} |

\cgalHeading{Invariants}

Those of \ref ::DiamondExpression. The number of faces is that of the call to `sign()`.

\cgalHeading{Complexity}

Linear in the number of faces.
*/
class FaceExpression {
public:
  /// evaluates the formula. \tparam FT a model of \ref ::FieldNumber
  template <class FT>
  FT operator()(std::span<const CGAL::Intrinsic_triangulations::Face_values<FT>> faces) const;
};
