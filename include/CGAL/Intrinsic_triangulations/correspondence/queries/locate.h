// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_LOCATE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_LOCATE_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Input_locator.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Intrinsic_locator.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/signpost_location.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

/*!
\file
Points taken from one triangulation to the other, by whatever correspondence there is.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// product of complex numbers: turns and stretches
inline Planar_vector<double> turned(const Planar_vector<double>& v,
                                    const Planar_vector<double>& by) {
  return {v[0] * by[0] - v[1] * by[1], v[0] * by[1] + v[1] * by[0]};
}
inline Planar_vector<double> turned_back(const Planar_vector<double>& v,
                                         const Planar_vector<double>& by) {
  return turned(v, {by[0], -by[1]});
}

// A point of the other triangulation, and how vectors turn from the frame of the halfedge that it was given
// with to that of the halfedge it has there.
struct Mapped_point {
  Surface_point point;
  Planar_vector<double> turn;
};

template <class Triangulation>
std::optional<Mapped_point> map_to_input(const Triangulation& t, const Surface_point& p) {
  const auto& c = t.correspondence();
  if constexpr (Has_curves<Triangulation>) {
    const Located l = locate_by_curves(t, c, p.halfedge, p.weights);
    return Mapped_point{l.point, turned_back({1, 0}, l.direction)};
  } else {
    const Signpost_location l = find_on_input(t, c, p);
    if (!l.is_found) return std::nullopt;
    return Mapped_point{l.point, turned_back(l.found, l.given)};
  }
}

template <class Triangulation>
std::optional<Mapped_point> map_to_intrinsic(const Triangulation& t, const Surface_point& p) {
  const auto& c = t.correspondence();
  if constexpr (Has_curves<Triangulation>) {
    std::uint32_t base = p.halfedge;
    const std::optional<Walked> q =
        Intrinsic_locator<Triangulation, Correspondence_of<Triangulation>>(t, c).locate(p, base);
    if (!q) return std::nullopt;
    const Geodesic_face face(c.input(), p.halfedge);
    unsigned side = 0;
    while (face.side[side] != base) ++side;
    const Planar_vector<double> first = face.relative_to(side, {1, 0}); // seen from the base
    const double length = std::hypot(q->direction.x, q->direction.y);
    return Mapped_point{q->point,
                        turned_back(first, {q->direction.x / length, q->direction.y / length})};
  } else {
    const Signpost_location l = find_on_intrinsic(t, c, p);
    if (!l.is_found) return std::nullopt;
    return Mapped_point{l.point, turned_back(l.found, l.given)};
  }
}

} // namespace internal

/*!
\brief finds the point of the input at a point of the intrinsic triangulation.
\tparam Triangulation a model of `CorrespondingTriangulation`
\param t the triangulation
\param p a point of it
\return the point; nothing only if `Signposts` have lost the way by rounding
\complexity with curves, that of following a number of them logarithmic in the number of crossings of the
  face; with signposts, linear in the number of input edges between the point and a corner of its face
*/
template <internal::Queried_triangulation Triangulation>
std::optional<Surface_point> locate_on_input(const Triangulation& t, const Surface_point& p) {
  const std::optional<internal::Mapped_point> q = internal::map_to_input(t, p);
  return q ? std::optional(q->point) : std::nullopt;
}

/*!
\brief finds the point of the intrinsic triangulation at a point of the input.
\tparam Triangulation as for `locate_on_input()`
\param t the triangulation
\param p a point of its input
\return the point; nothing only if `Signposts` have lost the way by rounding
\complexity linear in the number of intrinsic edges that cross the longest side of the input face, and
  of those between it and the point
*/
template <internal::Queried_triangulation Triangulation>
std::optional<Surface_point> locate_on_intrinsic(const Triangulation& t, const Surface_point& p) {
  const std::optional<internal::Mapped_point> q = internal::map_to_intrinsic(t, p);
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
template <internal::Queried_triangulation Triangulation, class Mesh>
std::optional<Face_location<Mesh>>
locate_on_input(const Triangulation& t, const Face_location<typename Triangulation::Mesh>& p,
                const Mesh& mesh) {
  const std::optional<Surface_point> q = locate_on_input(t, surface_point(t, p));
  return q ? std::optional(face_location(t, *q, mesh)) : std::nullopt;
}

/*!
\brief finds the place on the intrinsic triangulation of a place on the user's mesh.

See `locate_on_input()`, which it undoes.
*/
template <internal::Queried_triangulation Triangulation, class Mesh>
std::optional<Face_location<typename Triangulation::Mesh>>
locate_on_intrinsic(const Triangulation& t, const Face_location<std::type_identity_t<Mesh>>& p,
                    const Mesh& mesh) {
  const std::optional<Surface_point> q = locate_on_intrinsic(t, surface_point(t, p, mesh));
  return q ? std::optional(face_location(t, *q)) : std::nullopt;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_LOCATE_H
