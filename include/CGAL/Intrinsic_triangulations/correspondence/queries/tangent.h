// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TANGENT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TANGENT_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Curve_queries.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cstdint>
#include <optional>

/*!
\file
Takes tangent vectors from one triangulation to the other, by any correspondence.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a tangent vector at a point of a triangulation.

At a vertex, it points into the face of its frame, or its angle from the side of the face that
starts there is measured around the vertex.
*/
struct Tangent_vector {
  Surface_point point;    ///< the point
  Unscaled_vector vector; ///< in the frame of `point.halfedge`: along it, and to the left of it
};

namespace internal {

// The corner of a face that a point is at; 3: it is at none.
inline unsigned corner_of(const Surface_point& p) {
  for (unsigned k = 0; k < 3; ++k)
    if (p.weights[(k + 1) % 3] == 0 && p.weights[(k + 2) % 3] == 0) return k;
  return 3;
}

// The vector where a walk starts in the direction that it goes.
template <class Walk>
Tangent_vector at_start(const Walk& walk, double length, double turn = 0) {
  const Plane_vector<double>& d = walk.direction();
  const double c = length * std::cos(turn), s = length * std::sin(turn);
  return {{walk.face().side[0], walk.weights()}, {d[0] * c - d[1] * s, d[0] * s + d[1] * c}};
}

// Takes a vector from a point of `complex`: in a face as `map` says, at a corner by a walk from a
// side of the face, `walk(h, turn)`. A walk that is blocked starts along the side, and the vector
// is turned.
template <class Complex, class Map, class Walk>
std::optional<Tangent_vector> take_tangent(const Complex& complex, const Tangent_vector& v,
                                           const Map& map, const Walk& walk) {
  const unsigned corner = corner_of(v.point);
  if (corner == 3) {
    const std::optional<Mapped_point> p = map(v.point);
    if (!p) return std::nullopt;
    return Tangent_vector{p->point, p->transfer(v.vector)};
  }
  const Geodesic_face face(complex, v.point.halfedge);
  const Unscaled_vector r = face.relative_to(corner, v.vector);
  const double length = std::hypot(r[0], r[1]), angle = std::atan2(r[1], r[0]);
  const auto turned = walk(face.side[corner], angle);
  if (turned && !turned->is_blocked()) return at_start(*turned, length);
  const auto straight = walk(face.side[corner], 0);
  if (!straight) return std::nullopt;
  return at_start(*straight, length, angle);
}

} // namespace internal

/*!
\brief takes a tangent vector at a point of the intrinsic triangulation to the input.

Angles at vertices are those on the surface, not scaled. A vector that points out of the surface at
the border is given in the frame of a face beside it.
\tparam Triangulation a model of `CorrespondingTriangulation`
\param t the triangulation
\param v the vector
\return the vector at its place on the input; nothing only if rounding misleads `Signposts`
\complexity that of `locate_on_input()`; at a vertex, that of `trace_edge()`, and linear in its
degree
*/
template <QueriedTriangulation Triangulation>
std::optional<Tangent_vector> tangent_to_input(const Triangulation& t, const Tangent_vector& v) {
  const auto queries = internal::queries(t);
  return internal::take_tangent(
      Intrinsic_view<Triangulation>(t), v,
      [&](const Surface_point& p) { return queries.on_input(p); },
      [&](std::uint32_t h, double turn) { return std::optional(queries.walk_on_input(h, turn)); });
}

/*!
\brief takes a tangent vector at a point of the input to the intrinsic triangulation.

See `tangent_to_input()`.
\param t the triangulation
\param v the vector
\return the vector at its place on the intrinsic triangulation; nothing only if rounding misleads
  `Signposts`
\complexity that of `locate_on_intrinsic()`; at a vertex, linear in its degree
*/
template <QueriedTriangulation Triangulation>
std::optional<Tangent_vector> tangent_to_intrinsic(const Triangulation& t,
                                                   const Tangent_vector& v) {
  using Walk = internal::Geodesic_walk<Intrinsic_view<Triangulation>>;
  const Intrinsic_view<Triangulation> view(t);
  const auto queries = internal::queries(t);
  return internal::take_tangent(
      t.correspondence().input(), v,
      [&](const Surface_point& p) { return queries.on_intrinsic(p); },
      [&](std::uint32_t h, double turn) {
        const auto direction = queries.direction_on_intrinsic(h, turn);
        return direction ? std::optional(Walk(view, *direction)) : std::nullopt;
      });
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TANGENT_H
