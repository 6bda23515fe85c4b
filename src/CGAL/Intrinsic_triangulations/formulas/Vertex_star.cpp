// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <array>
#include <optional>

namespace CGAL::Intrinsic_triangulations {

std::optional<std::array<double, 3>> representable_weights(const std::array<double, 3>& weights) {
  const double sum = weights[0] + weights[1] + weights[2];
  // weights that were rounded to single precision, by 2^-25 each, pass
  if (!(std::abs(sum - 1) <= 0x1p-20)) return std::nullopt;
  const auto rounded = [](double x) { return std::floor(x * 0x1p52) * 0x1p-52; };
  std::array<double, 3> w{0, rounded(weights[1]), rounded(weights[2])};
  w[0] = weights[0] == 0 ? 0 : 1 - w[1] - w[2]; // exact: all are multiples of 2^-52 up to 1
  if (weights[0] == 0) w[1] = 1 - w[2];
  int positive = 0;
  for (const double x : w) {
    if (!(x >= 0)) return std::nullopt;
    positive += x > 0 ? 1 : 0;
  }
  return positive >= 2 ? std::optional(w) : std::nullopt;
}

} // namespace CGAL::Intrinsic_triangulations
