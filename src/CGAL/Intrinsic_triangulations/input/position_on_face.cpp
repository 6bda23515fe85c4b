// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/input/position_on_face.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

std::vector<double> mean_value_weights(std::span<const std::array<double, 2>> polygon,
                                       const std::array<double, 2>& p) {
  const std::size_t n = polygon.size();
  std::vector<double> weights(n, 0);
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const double ax = polygon[i][0] - p[0], ay = polygon[i][1] - p[1], bx = polygon[j][0] - p[0],
                 by = polygon[j][1] - p[1];
    const double a = std::hypot(ax, ay), b = std::hypot(bx, by);
    // of unit vectors: products of lengths may overflow or vanish
    const double cross = (ax / a) * (by / b) - (ay / a) * (bx / b),
                 dot = (ax / a) * (bx / b) + (ay / a) * (by / b);
    // eight roundings: seven of products, whose sizes sum to 1 at most, and one of the difference
    if (a == 0 || b == 0 || (dot < 0 && std::abs(cross) <= 0x1p-50)) {
      weights.assign(n, 0); // on the side
      weights[i] = b / (a + b);
      weights[j] = a / (a + b);
      return weights;
    }
    // the tangent of half the angle, without cancellation
    const double tangent = dot < 0 ? (1 - dot) / cross : cross / (1 + dot);
    weights[i] += tangent / a;
    weights[j] += tangent / b;
    sum += tangent / a + tangent / b;
  }
  for (double& w : weights) w /= sum;
  return weights;
}

} // namespace CGAL::Intrinsic_triangulations
