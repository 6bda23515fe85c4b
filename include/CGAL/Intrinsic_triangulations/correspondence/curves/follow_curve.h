// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_FOLLOW_CURVE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_FOLLOW_CURVE_H

#include <CGAL/Intrinsic_triangulations/correspondence/curves/corner_coordinates.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

/*!
\file
Curves that normal coordinates describe, followed from face to face (§3.5.1 of the course): integers
only.
*/

namespace CGAL::Intrinsic_triangulations {

/// The place where a curve leaves a face.
struct Curve_crossing {
  std::uint32_t halfedge;     ///< the halfedge of that face
  Normal_coordinate position; ///< number of curves that cross it nearer to its source
};

/// The start or the end of a curve at the source of a halfedge, in the face of it.
struct Curve_end {
  std::uint32_t halfedge;  ///< the first side of the corner, counterclockwise
  Normal_coordinate index; ///< number of curves that emanate from the corner nearer to that side
};

/// returns the sides of the face of `h`, from `h` on.
template <class Complex>
std::array<std::uint32_t, 3> sides_of_face(const Complex& complex, std::uint32_t h) {
  const std::uint32_t n = complex.next(h);
  return {h, n, complex.next(n)};
}

/*!
\brief tells how curves run in the face of `h`, whose source is corner 0.
\tparam Complex `Intrinsic_view`
\tparam Coordinates has a function `normal_coordinate(edge)`
*/
template <class Complex, class Coordinates>
Corner_coordinates corner_coordinates(const Complex& complex, const Coordinates& coordinates,
                                      std::uint32_t h) {
  const std::array<std::uint32_t, 3> s = sides_of_face(complex, h);
  return corner_coordinates({coordinates.normal_coordinate(s[0] / 2),
                             coordinates.normal_coordinate(s[1] / 2),
                             coordinates.normal_coordinate(s[2] / 2)});
}

/// returns where a curve that starts from a corner leaves the face. \pre such a curve exists
template <class Complex, class Coordinates>
Curve_crossing first_crossing(const Complex& complex, const Coordinates& coordinates,
                              const Curve_end& start) {
  const Corner_coordinates c = corner_coordinates(complex, coordinates, start.halfedge);
  return {complex.next(start.halfedge), c.cutting[1] + start.index};
}

/*!
\brief follows a curve from where it leaves a face to its end.
\param complex the intrinsic triangulation
\param coordinates the normal coordinates
\param crossing where the curve leaves a face
\param visit called for each `Curve_crossing`, from `crossing` on
\return the end, seen as the start of the curve that runs back
\complexity linear in the number of crossings
*/
template <class Complex, class Coordinates, class Visit>
Curve_end follow_curve(const Complex& complex, const Coordinates& coordinates,
                       Curve_crossing crossing, Visit visit) {
  for (;;) {
    visit(crossing);
    const std::uint32_t h = crossing.halfedge ^ 1U; // enters its face
    const Normal_coordinate n = coordinates.normal_coordinate(h / 2);
    const Normal_coordinate from_source = n - 1 - crossing.position;
    const Corner_coordinates c = corner_coordinates(complex, coordinates, h);
    const std::uint32_t next = complex.next(h), last = complex.next(next);
    if (from_source < c.cutting[0]) // around the source
      crossing = {last, coordinates.normal_coordinate(last / 2) - 1 - from_source};
    else if (from_source < c.cutting[0] + c.emanating[2]) // to the apex
      return {last, from_source - c.cutting[0]};
    else // around the target
      crossing = {next, crossing.position};
  }
}

/// Curves that leave a face side by side.
struct Curve_bundle {
  std::uint32_t halfedge; ///< the halfedge of that face
  Normal_coordinate
      position;             ///< number of curves that cross it nearer to its source than the first
  Normal_coordinate count;  ///< number of curves
  Normal_coordinate number; ///< number of the first one, counted where following began
};

/*!
\brief follows curves that leave a face side by side to their ends. As long as they run side by side, they
take one step together.
\param complex the intrinsic triangulation
\param coordinates the normal coordinates
\param bundle the curves
\param stack memory to use
\param visit called with the number of each curve and its `Curve_end`, see `follow_curve()`
\complexity linear in the number of steps, at most that of all crossings
*/
template <class Complex, class Coordinates, class Visit>
void follow_curves(const Complex& complex, const Coordinates& coordinates, Curve_bundle bundle,
                   std::vector<Curve_bundle>& stack, Visit visit) {
  stack.assign(1, bundle);
  while (!stack.empty()) {
    Curve_bundle b = stack.back();
    stack.pop_back();
    while (b.count > 0) {
      const std::uint32_t h = b.halfedge ^ 1U; // enters its face
      const Corner_coordinates c = corner_coordinates(complex, coordinates, h);
      const std::uint32_t next = complex.next(h), last = complex.next(next);
      const Normal_coordinate n = coordinates.normal_coordinate(h / 2), end = b.position + b.count;
      // from the target of h on: curves about the target, to the apex, about the source
      const Normal_coordinate to_source = n - c.cutting[0], to_apex = to_source - c.emanating[2];
      const auto about_target = std::max(0, std::min(end, to_apex) - b.position);
      const auto about_source = std::max(0, end - std::max(b.position, to_source));
      for (Normal_coordinate i = about_target; i < b.count - about_source; ++i)
        visit(b.number + i, Curve_end{last, to_source - 1 - (b.position + i)});
      if (about_source > 0) {
        const Normal_coordinate skipped = b.count - about_source;
        stack.push_back({last, b.position + skipped + coordinates.normal_coordinate(last / 2) - n,
                         about_source, b.number + skipped});
      }
      b = {next, b.position, about_target, b.number};
    }
  }
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_FOLLOW_CURVE_H
