// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_WEIGHTED_VERTICES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_WEIGHTED_VERTICES_H

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief returns the vertices of a point of the input, in the numbers that they have for the user.

With `position()` it tells where points that functions such as `locate_on_input()` and
`trace_geodesic()` return are in space.
\param t the triangulation
\param p a point of the input, not of the intrinsic triangulation
*/
template <class Triangulation>
Weighted_vertices weighted_vertices(const Triangulation& t, const Surface_point& p) {
  const Input& input = t.input();
  const auto user_vertex = [&t](std::uint32_t v) { return t.input().names().vertices.user(v); };
  const std::uint32_t next = input.next(p.halfedge);
  return {3,
          {user_vertex(input.source(p.halfedge)), user_vertex(input.target(p.halfedge)),
           user_vertex(input.target(next))},
          p.weights};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_WEIGHTED_VERTICES_H
