// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/Expression_steps.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

void Expression_steps::find_last_uses() {
  std::vector<char> is_used_later(steps_.size());
  const auto is_last = [&](std::uint32_t n) {
    return n >= values_ && !std::exchange(is_used_later[n - values_], 1);
  };
  is_last(result_);
  for (std::size_t i = steps_.size(); i-- > 0;) {
    Step& s = steps_[i];
    if (s.operation == Operation::constant) continue;
    s.is_last_of_a = is_last(s.a);
    if (s.operation != Operation::negation) s.is_last_of_b = is_last(s.b);
  }
}

} // namespace CGAL::Intrinsic_triangulations
