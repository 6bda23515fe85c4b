// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_MIRRORED_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_MIRRORED_H

#include <CGAL/Intrinsic_triangulations/exact/proofs/Question.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/Rung.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief proves that the corners of an unfolded diamond are cocircular, if a reflection of some of its
triangles exchanges the ends of two opposite sides: then it is an isosceles trapezoid.

Ties on curved surfaces that are symmetric by a plane are of this kind, and those on covers, which
exchange their sheets. Their values may have as many square roots as triangles, too many for other
proofs. Linear in the number of triangles, times that at a corner.
*/
struct Mirrored_proof {
  /// Its rung.
  static constexpr Rung rung = Rung::mirrored;
  /// returns `zero`, or nothing.
  Answer operator()(const Question<Unfolded_diamond, Recorded_diamond_expression>& q) const;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_MIRRORED_H
