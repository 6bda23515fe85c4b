// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/distance/Corner_table.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

void Corner_table::find_fans() {
  std::vector<char> seen(corners.size(), 0);
  for (std::uint32_t c = 0; c < corners.size(); ++c) {
    if (seen[c] != 0 || corners[c].origin == Gluing::none) continue;
    std::uint32_t first = c;
    for (std::uint32_t r = turn_right(c); r != Gluing::none && r != c; r = turn_right(r)) first = r;
    if (first != c && turn_right(first) == c) first = c; // all around
    std::uint32_t g = first;
    do seen[g] = 1;
    while ((g = turn_left(g)) != Gluing::none && g != first);
    const std::uint32_t v = corners[c].origin;
    if (first_corner[v] == Gluing::none)
      first_corner[v] = first;
    else
      other_fans.emplace_back(v, first);
  }
  std::sort(other_fans.begin(), other_fans.end());
}

std::pair<double, double> corner_direction(double left, double right, double opposite,
                                           double quadruple_area) {
  const double x = left + right - opposite, y = quadruple_area, norm = std::sqrt(x * x + y * y);
  return norm > 0 ? std::pair(x / norm, y / norm) : std::pair(0.0, 1.0);
}

} // namespace CGAL::Intrinsic_triangulations::internal
