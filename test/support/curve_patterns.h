// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_CURVE_PATTERNS_H
#define TEST_INTRINSIC_TRIANGULATIONS_CURVE_PATTERNS_H

#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>

namespace curve_patterns {

using CGAL::Intrinsic_triangulations::Corner_coordinates;

/// All ways in which curves can run in a face, with up to `n` curves of each kind: about each
/// corner, and from one corner without curves about it.
template <class Function>
void for_each_pattern(int n, Function f) {
  for (int a = 0; a <= n; ++a)
    for (int b = 0; b <= n; ++b)
      for (int c = 0; c <= n; ++c) {
        f(Corner_coordinates{{a, b, c}, {0, 0, 0}});
        for (unsigned k = 0; k < 3; ++k) {
          Corner_coordinates p{{a, b, c}, {0, 0, 0}};
          if (p.cutting[k] != 0) continue;
          for (p.emanating[k] = 1; p.emanating[k] <= n; ++p.emanating[k]) f(p);
        }
      }
}

} // namespace curve_patterns

#endif // TEST_INTRINSIC_TRIANGULATIONS_CURVE_PATTERNS_H
