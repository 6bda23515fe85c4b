// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CORNER_COORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CORNER_COORDINATES_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

/*!
\file
Normal coordinates of curves in one or two triangles (§3.5.1 of the course): integers only.
*/

namespace CGAL::Intrinsic_triangulations {

/// Number of crossings of curves with an edge; -1 for an edge along which a curve runs.
using Normal_coordinate = std::int32_t;

/// Greatest number of crossings of one edge: sums of a few of them do not overflow.
inline constexpr Normal_coordinate maximal_normal_coordinate = Normal_coordinate{1} << 27;

/// returns the number of crossings, n^+ in the course.
inline Normal_coordinate crossings(Normal_coordinate n) { return std::max(n, 0); }
/// returns the number of curves that run along the edge, n^- in the course.
inline Normal_coordinate parallels(Normal_coordinate n) { return std::max(-n, 0); }

/*!
\brief tells how curves run in a face: corner 0 is the source of side 0, side `k` runs from corner
`k` to the next one.
*/
struct Corner_coordinates {
  /// Number of curves that cut off each corner, c in the course.
  std::array<Normal_coordinate, 3> cutting;
  /// Number of curves that emanate from each corner and cross the opposite side, e in the course.
  std::array<Normal_coordinate, 3> emanating;
};

/*!
\brief computes how curves run in a face from the normal coordinates of its sides, Eq. 9 and 10 of the
course.
*/
inline Corner_coordinates corner_coordinates(const std::array<Normal_coordinate, 3>& normal) {
  const std::array<Normal_coordinate, 3> n{crossings(normal[0]), crossings(normal[1]),
                                           crossings(normal[2])};
  Corner_coordinates c;
  for (std::size_t k = 0; k < 3; ++k) // side k + 1 is opposite corner k
    c.emanating[k] = std::max(0, n[(k + 1) % 3] - n[k] - n[(k + 2) % 3]);
  for (std::size_t k = 0; k < 3; ++k)
    c.cutting[k] = (std::max(0, n[k] + n[(k + 2) % 3] - n[(k + 1) % 3]) - c.emanating[(k + 1) % 3] -
                    c.emanating[(k + 2) % 3]) /
                   2;
  return c;
}

/*!
\brief computes the normal coordinate of the edge km that a flip of ij makes, Eq. 13 of the course.
\param ij normal coordinate of the flipped edge
\param f how curves run in the left face, with corners i, j, k
\param g how curves run in the right face, with corners j, i, m
*/
inline Normal_coordinate flipped_normal_coordinate(Normal_coordinate ij,
                                                   const Corner_coordinates& f,
                                                   const Corner_coordinates& g) {
  const Normal_coordinate twice = std::abs(g.cutting[0] - f.cutting[1]) +
                                  std::abs(g.cutting[1] - f.cutting[0]) - g.emanating[2] -
                                  f.emanating[2];
  return f.cutting[2] + g.cutting[2] + twice / 2 + f.emanating[0] + f.emanating[1] +
         g.emanating[0] + g.emanating[1] + parallels(ij);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CORNER_COORDINATES_H
