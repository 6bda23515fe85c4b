// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_RECORDED_EXPRESSION_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_RECORDED_EXPRESSION_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/formulas/Expression_degree.h>
#include <CGAL/Intrinsic_triangulations/formulas/Expression_steps.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>

#include <cstdint>
#include <stdexcept>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Expression_steps*& Recorded_number::recording() {
  thread_local Expression_steps* steps = nullptr;
  return steps;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::uint32_t
Recorded_number::add(Operation operation, std::uint32_t a, std::uint32_t b, double x) {
  if (recording() == nullptr)
    throw std::logic_error("numbers of an expression are made while it is recorded: it has no "
                           "static numbers");
  return recording()->add(operation, a, b, x);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Recorded_diamond_expression::Recorded_diamond_expression(Expression_steps&& steps,
                                                         Zero_meaning meaning)
    : steps_(std::move(steps)), meaning_(meaning) {
  constexpr Expression_degree l = Expression_degree::length(), a = Expression_degree::area();
  if (steps_.is_polynomial())
    degree_ = (*this)(Diamond_values<Expression_degree>{l, l, l, l, l, a, a});
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_RECORDED_EXPRESSION_IMPL_H
