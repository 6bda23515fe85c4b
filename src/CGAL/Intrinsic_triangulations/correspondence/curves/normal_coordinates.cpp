// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/formulas/Development.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>

#include <array>

namespace CGAL::Intrinsic_triangulations {

std::array<Normal_coordinate, 3> inserted_normal_coordinates(const Corner_coordinates& c,
                                                             const Face_region& r) {
  std::array<Normal_coordinate, 3> n = r.cutting;
  for (unsigned k = 0; k < 3; ++k) {
    const Normal_coordinate on = r.is_on_curve && r.corner == k && r.fan_corner != k ? 1 : 0;
    const Normal_coordinate beyond = c.cutting[k] - r.cutting[k] - on;
    n[(k + 1) % 3] += beyond;
    n[(k + 2) % 3] += beyond;
  }
  if (r.fan_corner == 3) return n;
  const unsigned k = r.fan_corner;
  const Normal_coordinate on = r.is_on_curve && r.corner == k ? 1 : 0;
  n[(k + 1) % 3] += r.right_of_fan;
  n[(k + 2) % 3] += c.emanating[k] - r.right_of_fan - on;
  if (on != 0) n[k] = -1;
  return n;
}

bool has_region(const Corner_coordinates& c, const std::array<Normal_coordinate, 3>& normal,
                bool is_on_curve) {
  Face_region middle;
  middle.cutting = c.cutting;
  const unsigned fan = middle.fan_corner = c.fan_corner();
  const auto is = [&](const Face_region& r) { return inserted_normal_coordinates(c, r) == normal; };
  for (unsigned k = 0; k < 3; ++k) { // beyond an arc about corner k, or on one
    if (normal[k] < 0 || normal[k] >= c.cutting[k]) continue;
    Face_region r = middle;
    r.cutting[k] = normal[k];
    if (fan < 3) r.right_of_fan = k == (fan + 1) % 3 ? 0 : c.emanating[fan];
    r.is_on_curve = is_on_curve;
    r.corner = k;
    if (is(r)) return true;
  }
  if (fan == 3) return !is_on_curve && is(middle);
  const unsigned next = (fan + 1) % 3;
  middle.right_of_fan = normal[next] - c.cutting[next];
  middle.is_on_curve = is_on_curve;
  middle.corner = fan;
  return middle.right_of_fan >= 0 &&
         middle.right_of_fan + (is_on_curve ? 1 : 0) <= c.emanating[fan] && is(middle);
}

bool can_do_without_vertex(std::array<Normal_coordinate, 3> sides,
                           const std::array<Normal_coordinate, 3>& to, bool is_on_curve) {
  // curves that start from no corner meet two sides each
  const auto is_even_or_fan = [&sides](const Corner_coordinates& c) {
    const Normal_coordinate sum = crossings(sides[0]) + crossings(sides[1]) + crossings(sides[2]);
    return sum % 2 == 0 || c.emanating[0] + c.emanating[1] + c.emanating[2] > 0;
  };
  for (unsigned k = 0; k < 3; ++k) {
    const unsigned next = (k + 1) % 3, last = (k + 2) % 3;
    if (to[k] >= 0 || to[next] >= 0) continue;
    if (sides[k] != 0) return false;
    sides[k] = -1;
    const Corner_coordinates c = corner_coordinates(sides);
    return is_even_or_fan(c) && to[last] == c.cutting[last] + c.emanating[k] + c.emanating[next];
  }
  const Corner_coordinates c = corner_coordinates(sides);
  return is_even_or_fan(c) && has_region(c, to, is_on_curve);
}

} // namespace CGAL::Intrinsic_triangulations
