// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_PRISM_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_PRISM_H

#include <CGAL/Intrinsic_triangulations/exact/proofs/Question.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/Rung.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief proves that corners of an unfolded diamond are cocircular, or three of them collinear, where
the triangles are folded along parallel lines: over cylinders and prisms.

Nearly all ties that flips on CAD surfaces make over more than two faces are of this kind: cylinders
are made of rectangles there. Linear in the number of triangles, about a fifth of a microsecond
each.
*/
struct Prism_proof {
  /// Its rung.
  static constexpr Rung rung = Rung::prism;
  /// returns `zero`, or nothing.
  Answer operator()(const Question<Unfolded_diamond, Recorded_diamond_expression>& q) const;
};

/*!
\brief decides whether an expression over a cylinder or prism is zero, if all of its terms have one
degree.

The positions of corners are integers and sums of roots of integers there (see `Prism_proof`), which
takes no division: ten microseconds, where the field takes hundreds, whatever the number of
triangles.
*/
struct Prism_in_field_proof {
  /// Its rung.
  static constexpr Rung rung = Rung::prism_in_field;
  /// returns `zero`, `not_zero`, or nothing.
  Answer operator()(const Question<Unfolded_diamond, Recorded_diamond_expression>& q) const;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_PRISM_H
