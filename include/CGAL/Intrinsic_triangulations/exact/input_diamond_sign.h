// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_INPUT_DIAMOND_SIGN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_INPUT_DIAMOND_SIGN_H

#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/enum.h>

#include <optional>

/*!
\file
Signs of expressions in two faces of the input, decided exactly in integers of fixed size. Most ties
on real meshes are of this kind: quadrilaterals of CAD surfaces that were cut along a diagonal.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief decides the sign of an expression in the values of a diamond of two input faces, exactly.
\param input the input
\param diamond the faces
\param expression the expression
\return the sign; nothing if the expression is not linear in the areas (see
  `Expression_degree::is_linear_in_areas()`), or coordinates spread over more than 122 bits
\complexity constant, about a tenth of a microsecond
*/
std::optional<Sign> input_diamond_sign(const Input_metric& input, const Input_diamond& diamond,
                                       const Recorded_diamond_expression& expression);

} // namespace CGAL::Intrinsic_triangulations

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/exact/input_diamond_sign_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_INPUT_DIAMOND_SIGN_H
