// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRACING_POINTS_IN_ONE_FACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRACING_POINTS_IN_ONE_FACE_H

#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// All descriptions of a point, one per face that it is in.
template <class Complex>
std::vector<Surface_point> descriptions(const Complex& complex, const Surface_point& p) {
  std::vector<Surface_point> result{p};
  const unsigned zeros = static_cast<unsigned>(std::count(p.weights.begin(), p.weights.end(), 0.0));
  std::uint32_t h = p.halfedge;
  for (unsigned k = 0; k < 3; ++k, h = complex.next(h)) {
    if (zeros == 1 && p.weights[(k + 2) % 3] == 0 && !complex.is_border(h ^ 1U))
      result.push_back({h ^ 1U, {p.weights[(k + 1) % 3], p.weights[k], 0}});
    if (zeros != 2 || p.weights[k] == 0) continue;
    std::uint32_t g = h; // about the vertex: counterclockwise, then from the border on
    while (!complex.is_border(g = next_around_source(complex, g)) && g != h) result.push_back({g});
    if (g == h) break;
    for (g = h; !complex.is_border(g ^ 1U);) result.push_back({g = complex.next(g ^ 1U)});
  }
  return result;
}

} // namespace internal

/*!
\brief finds a face that has two points, which a straight line then joins.

A point on an edge is in two faces, and one at a vertex in all faces about it: any of them may have
the other point.
\tparam Complex a model of `NumberedComplex`
\param complex the surface
\param p a point of it
\param q another one
\return both points, described from one halfedge of a face; nothing if no face has both
\complexity the product of the numbers of faces that have the points
*/
template <NumberedComplex Complex>
std::optional<std::pair<Surface_point, Surface_point>>
points_in_one_face(const Complex& complex, const Surface_point& p, const Surface_point& q) {
  const std::vector<Surface_point> of_q = internal::descriptions(complex, q);
  for (const Surface_point& a : internal::descriptions(complex, p))
    for (const Surface_point& b : of_q)
      if (complex.face(a.halfedge) == complex.face(b.halfedge))
        return std::pair(a, seen_from(complex, b, a.halfedge));
  return {};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRACING_POINTS_IN_ONE_FACE_H
