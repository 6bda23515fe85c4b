// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Expression_steps.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>

#include <utility>

namespace CGAL::Intrinsic_triangulations {

Recorded_diamond_expression::Recorded_diamond_expression(Expression_steps&& steps,
                                                         Zero_meaning meaning)
    : steps_(std::move(steps)), meaning_(meaning) {
  constexpr Expression_degree l = Expression_degree::length(), a = Expression_degree::area();
  if (steps_.is_polynomial())
    degree_ = (*this)(Diamond_values<Expression_degree>{l, l, l, l, l, a, a});
}

} // namespace CGAL::Intrinsic_triangulations
