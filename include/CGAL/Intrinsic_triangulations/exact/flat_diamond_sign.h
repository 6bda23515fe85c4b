// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_FLAT_DIAMOND_SIGN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_FLAT_DIAMOND_SIGN_H

#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flat_diamond.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>

#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief tells whether an input face lies in the plane of another one in space, in the same orientation, exactly.
\param input the input, from points in space
\param f a face with area
\param g another face, of which the corners but the one in slot `slot` lie in the plane of `f`
\param slot the slot of that corner
*/
bool are_coplanar(const Input_metric& input, std::uint32_t f, std::uint32_t g, std::uint32_t slot);

/*!
\brief returns the sign of an expression in the values of a diamond that lies in one plane in space, exactly.

There all corners have coordinates that are multiples of a power of two, and areas have one square root as a factor:
no field is extended.
\param input the input, from points in space
\param diamond the diamond
\param expression the expression
\param better set to intervals that contain the values
\param statistics counts how the sign was decided
\pre the expression is linear in the areas, see `Expression_degree`
*/
Sign flat_diamond_sign(const Input_metric& input, const Flat_diamond& diamond,
                       const Recorded_diamond_expression& expression,
                       Diamond_values<Interval_nt<false>>& better,
                       Predicate_statistics& statistics);

/// returns a diamond of which all triangles lie in one plane in space.
Flat_diamond flat_diamond(const Input_metric& input, const Unfolded_diamond& diamond);

} // namespace CGAL::Intrinsic_triangulations

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/exact/flat_diamond_sign_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_FLAT_DIAMOND_SIGN_H
