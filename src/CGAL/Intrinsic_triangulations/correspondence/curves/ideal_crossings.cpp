// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/curves/ideal_crossings.h>
#include <CGAL/Intrinsic_triangulations/formulas/Development.h>
#include <CGAL/Intrinsic_triangulations/formulas/Penner_coordinates.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/metric/nearest_lengths.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

Ideal_strip::Ideal_strip(const Input& input)
    : input_(input), lambda_(nearest_lengths(input.metric(), input.mesh())) {}

void Ideal_strip::measure(std::span<const std::uint32_t> entered) {
  backwards_.clear();
  for (std::size_t n = entered.size(); n-- > 0;) backwards_.push_back(entered[n] ^ 1U);
  measure(entered, from_start_, length_);
  measure(backwards_, from_end_, length_);
}

void Ideal_strip::measure(std::span<const std::uint32_t> entered,
                          std::vector<std::array<double, 2>>& result, double& length) {
  strip_.start(entered.front());
  for (const std::uint32_t x : entered.subspan(1)) strip_.enter(input_, strip_.last(), x);
  const std::uint32_t to_start = input_.next(entered.front() ^ 1U);
  at_ = {lambda_[to_start / 2], lambda_[input_.next(to_start) / 2]};
  strip_.carry(at_, [this](const Development<>::Triangle& t, double from, double to) {
    const std::uint32_t next = input_.next(t.side);
    return lambda_at_apex(from, to, lambda_[t.side / 2], lambda_[next / 2],
                          lambda_[input_.next(next) / 2]);
  });
  result.clear();
  for (const Development<>::Triangle& t : strip_)
    result.push_back({at_[t.point[0]], at_[t.point[1]]});
  length = at_.back();
}

} // namespace CGAL::Intrinsic_triangulations::internal
