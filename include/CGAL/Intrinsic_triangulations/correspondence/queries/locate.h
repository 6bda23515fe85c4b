// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_LOCATE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_LOCATE_H

#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Curve_queries.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <optional>
#include <type_traits>

/*!
\file
Takes points from one triangulation to the other, by any correspondence.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief finds the point of the input at a point of the intrinsic triangulation.
\tparam Triangulation a model of `CorrespondingTriangulation`
\param t the triangulation
\param p a point of it
\return the point; nothing only if rounding misleads `Signposts`
\complexity with curves, linear in the number of crossings of the face, and that of following them;
with signposts, linear in the number of input edges between the point and a corner of its face
*/
template <QueriedTriangulation Triangulation>
std::optional<Surface_point> locate_on_input(const Triangulation& t, const Surface_point& p) {
  const std::optional<Mapped_point> q = internal::queries(t).on_input(p);
  return q ? std::optional(q->point) : std::nullopt;
}

/*!
\brief finds the point of the intrinsic triangulation at a point of the input.
\tparam Triangulation as for `locate_on_input()`
\param t the triangulation
\param p a point of its input
\return the point; nothing only if rounding misleads `Signposts`
\complexity linear in the number of intrinsic edges that cross the longest side of the input face,
  and of those between it and the point
*/
template <QueriedTriangulation Triangulation>
std::optional<Surface_point> locate_on_intrinsic(const Triangulation& t, const Surface_point& p) {
  const std::optional<Mapped_point> q = internal::queries(t).on_intrinsic(p);
  return q ? std::optional(q->point) : std::nullopt;
}

/*!
\brief finds the place on the user's mesh of a place on the intrinsic triangulation.
\tparam Mesh the type of the user's mesh
\param t the triangulation
\param p the place, on `t.mesh()`
\param mesh the mesh that `t` was built from
\return see the overload without mesh
\throws Invalid_input if the place is in a polygon, or the mesh is another one
*/
template <QueriedTriangulation Triangulation, ReadableFaceGraph Mesh>
std::optional<Face_location<Mesh>>
locate_on_input(const Triangulation& t, const Face_location<typename Triangulation::Mesh>& p,
                const Mesh& mesh) {
  const std::optional<Surface_point> q = locate_on_input(t, surface_point(t, p));
  return q ? std::optional(face_location(t, *q, mesh)) : std::nullopt;
}

/*!
\brief finds the place on the intrinsic triangulation of a place on the user's mesh.

This is the inverse of `locate_on_input()`.
*/
template <QueriedTriangulation Triangulation, ReadableFaceGraph Mesh>
std::optional<Face_location<typename Triangulation::Mesh>>
locate_on_intrinsic(const Triangulation& t, const Face_location<std::type_identity_t<Mesh>>& p,
                    const Mesh& mesh) {
  const std::optional<Surface_point> q = locate_on_intrinsic(t, surface_point(t, p, mesh));
  return q ? std::optional(face_location(t, *q)) : std::nullopt;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_LOCATE_H
