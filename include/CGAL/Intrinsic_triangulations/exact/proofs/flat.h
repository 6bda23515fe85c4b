// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_FLAT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_FLAT_H

#include <CGAL/Intrinsic_triangulations/exact/proofs/Question.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/Rung.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Interval_nt.h>

#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief tells whether an input face lies in the plane of another one in space, in the same
orientation, exactly.
\param input the input, from points in space
\param f a face with area
\param g another face; its corners except the one in slot `slot` lie in the plane of `f`
\param slot the slot of that corner
*/
bool are_coplanar(const Input_metric& input, std::uint32_t f, std::uint32_t g, std::uint32_t slot);

/// encloses the values of a diamond that lies in one plane in space.
Diamond_values<Interval_nt<false>> values_in_space(const Input_metric& input,
                                                   const Flat_diamond& diamond);

/*!
\brief decides signs of expressions in a diamond that lies in one plane in space, if they are linear
in the areas.

There all corners have coordinates that are multiples of a power of two, and all areas share one
square root as a factor, so that no field extension is needed. On CAD surfaces nearly all flips are
of this kind.
*/
struct Flat_proof {
  /// Its rung.
  static constexpr Rung rung = Rung::flat;
  /// returns the sign.
  Answer operator()(const Question<Flat_diamond, Recorded_diamond_expression>& q) const;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_FLAT_H
