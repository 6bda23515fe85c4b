// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_EXPRESSION_STEPS_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_EXPRESSION_STEPS_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/formulas/Expression_steps.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Expression_steps::Expression_steps(std::uint32_t number_of_values) : values_(number_of_values) {
  steps_.reserve(12); // those of two faces have no more
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::uint32_t
Expression_steps::add(Operation operation, std::uint32_t a, std::uint32_t b, double constant) {
  steps_.push_back({operation, a, b, false, false, constant});
  return values_ + static_cast<std::uint32_t>(steps_.size()) - 1;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Expression_steps::finish(std::uint32_t result) {
  result_ = result;
  if (steps_.size() > few_steps) find_last_uses();
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE bool Expression_steps::is_polynomial() const {
  for (const Step& s : steps_)
    if (s.operation == Operation::constant || s.operation == Operation::quotient) return false;
  return true;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Expression_steps::find_last_uses() {
  std::vector<char> is_used_later(steps_.size());
  const auto is_last = [&](std::uint32_t n) {
    return n >= values_ && !std::exchange(is_used_later[n - values_], 1);
  };
  is_last(result_);
  for (auto s = steps_.rbegin(); s != steps_.rend(); ++s) {
    if (s->operation == Operation::constant) continue;
    s->is_last_of_a = is_last(s->a);
    if (s->operation != Operation::negation) s->is_last_of_b = is_last(s->b);
  }
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_EXPRESSION_STEPS_IMPL_H
