// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_FACE_REGION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_FACE_REGION_H

#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>

#include <array>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief names one of the regions into which curves cut a face, or a curve between two of them.

Corners and sides are those of `Corner_coordinates`.
*/
struct Face_region {
  /// Number of curves that cut off each corner from the region.
  std::array<Normal_coordinate, 3> cutting{0, 0, 0};
  /// Number of curves emanating from a corner that have the region on their left.
  Normal_coordinate right_of_fan = 0;
  /// The corner from which curves emanate, or 3.
  unsigned fan_corner = 3;
  /// Whether the point is on a curve: curve `cutting[corner]` about `corner`, or if `corner` is
  /// `fan_corner` emanating curve `right_of_fan`.
  bool is_on_curve = false;
  /// The corner of that curve.
  unsigned corner = 3;
};

/*!
\brief returns the normal coordinates of the edges from the corners of a face to a new vertex in a
region of it: -1 if the edge runs along a curve.
*/
inline std::array<Normal_coordinate, 3> inserted_normal_coordinates(const Corner_coordinates& c,
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

/*!
\brief tells whether the edges to a vertex in a face are crossed as they are if the vertex is in one of
the regions of the face: then the face can do without it.
\param c how curves run in the face without the vertex
\param normal normal coordinates of the edges from the corners to the vertex
\param is_on_curve whether the vertex is on a curve
*/
inline bool has_region(const Corner_coordinates& c, const std::array<Normal_coordinate, 3>& normal,
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

/*!
\brief tells whether a vertex of degree three lies in a region of the face around it, or on a curve along a side of that.
\param sides normal coordinates of the sides of the face
\param to normal coordinates of the edges from its corners to the vertex
\param is_on_curve whether the vertex is on a curve
*/
inline bool can_do_without_vertex(std::array<Normal_coordinate, 3> sides,
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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_FACE_REGION_H
