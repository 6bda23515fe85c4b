// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_IDEAL_TRIANGULATIONS_H
#define TEST_INTRINSIC_TRIANGULATIONS_IDEAL_TRIANGULATIONS_H

#include "properties.h"

#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

// Changes of ideal hyperbolic triangulations.

namespace ideal {

/// Positive factors over the given powers of two, up and down.
inline std::vector<double> random_factors(std::size_t n, int powers, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> power(-powers, powers);
  std::vector<double> result(n);
  for (double& w : result) w = std::exp2(power(random));
  return result;
}

/// Flips any edges between two faces: all of them can be flipped.
template <class T>
void flip_at_random(T& t, std::size_t flips, unsigned seed) {
  std::mt19937 random(seed);
  for (std::size_t n = 0; n < flips; ++n) {
    const auto inner = properties::flippable_by_connectivity(t);
    if (inner.empty()) return;
    ASSERT_EQ(t.flip_edge(inner[random() % inner.size()]),
              CGAL::Intrinsic_triangulations::Move_status::done);
  }
}

} // namespace ideal

#endif // TEST_INTRINSIC_TRIANGULATIONS_IDEAL_TRIANGULATIONS_H
