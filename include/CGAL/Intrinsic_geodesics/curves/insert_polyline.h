// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CURVES_INSERT_POLYLINE_H
#define CGAL_INTRINSIC_GEODESICS_CURVES_INSERT_POLYLINE_H

#include <CGAL/Intrinsic_geodesics/curves/Line_inserter.h>
#include <CGAL/Intrinsic_geodesics/curves/insert_point.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/points_in_one_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a path of edges through inserted vertices, the segments of a polyline.
\tparam Triangulation the type of the triangulation
*/
template <RefinableTriangulation Triangulation>
struct Inserted_polyline {
  /// `done`, or the reason why a vertex was not inserted; `border`: a line leads beyond it;
  /// `not_traceable`: by rounding, a line misses its end.
  Move_status status = Move_status::done;
  /// The halfedges, in order; if the status is not `done`, as far as the path goes.
  std::vector<typename Triangulation::halfedge_descriptor> halfedges;
  /// The vertex at each given point.
  std::vector<typename Triangulation::vertex_descriptor> vertices;
};

namespace internal {

// A vector from a point of the input, where vertex v is, as a direction from that vertex.
template <class Triangulation>
std::optional<Corner_direction> direction_at_vertex(const Triangulation& t, std::uint32_t v,
                                                    const Tangent_vector& vector) {
  const std::optional<Tangent_vector> here = tangent_to_intrinsic(t, vector);
  if (!here) return std::nullopt;
  const Accurate_view<Triangulation> view(t);
  const Geodesic_face face(view, here->point.halfedge);
  const auto& w = here->point.weights;
  std::optional<unsigned> k;
  for (unsigned i = 0; i < 3; ++i)
    if (view.source(face.side[i]) == v && (!k || w[i] > w[*k])) k = i;
  if (!k) return std::nullopt; // rounding, in a face that is tiny
  const Unscaled_vector d = face.relative_to(*k, here->vector);
  double angle = std::atan2(d[1], d[0]); // from the side of the corner that is nearer
  const double full = 2 * std::numbers::pi, corner = angle_at_source(view, face.side[*k]);
  if (angle < 0 && angle + full - corner < -angle) angle += full;
  return Corner_direction{face.side[*k], angle};
}

} // namespace internal

/*!
\brief turns a polyline on the input into a path of edges of the triangulation.

It finds or inserts vertices at the points, and inserts one wherever a segment crosses an edge, also
that of an earlier segment: the polyline may cross itself and any edge again. It passes a point
again if the coordinates are the same. The path goes through vertices that a segment meets up to
rounding. It changes halfedges of earlier paths that it crosses: insert all before you add them to a
`Curve_network`. The triangulation rounds each new vertex, so a path in exact arithmetic bends a
little.
\tparam Triangulation a model of `RefinableTriangulation` and of `CorrespondingTriangulation`
\param t the triangulation
\param points points of the input; `surface_point()` finds those of the user's mesh. Consecutive
points share a face: the polyline has a point on each edge of the input that it crosses, as those of
`trace_geodesic_on_input()` do
\return the path, and the vertices at the points. If an insertion fails, earlier vertices stay
\throws Invalid_input if two consecutive points have no common face; then nothing is inserted
\complexity that of `insert_point()` for each point, linear in the number of crossings, and that of
the insertions
*/
template <RefinableTriangulation Triangulation>
Inserted_polyline<Triangulation> insert_polyline(Triangulation& t,
                                                 const std::vector<Surface_point>& points) {
  const auto& input = t.correspondence().input();
  std::vector<std::pair<Surface_point, Surface_point>> segments;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto in_common = points_in_one_face(input, points[i], points[i + 1]);
    if (!in_common)
      throw Invalid_input(Element_kind::none, 0,
                          "points " + std::to_string(i) + " and " + std::to_string(i + 1) +
                              " of a polyline are in no common face of the input; add the points "
                              "where it crosses edges");
    segments.push_back(*in_common);
  }
  Inserted_polyline<Triangulation> result;
  for (const Surface_point& p : points) {
    const Vertex_at_point<Triangulation> v = insert_point(t, p);
    result.status = v.status;
    if (v.status != Move_status::done) return result;
    result.vertices.push_back(v.vertex);
  }
  internal::Line_inserter<Triangulation> inserter(t);
  for (std::size_t i = 0; i < segments.size() && result.status == Move_status::done; ++i) {
    if (result.vertices[i] == result.vertices[i + 1]) continue;
    const auto& [p, q] = segments[i];
    const Unscaled_vector v = vector_between(input, p, q);
    const auto d = internal::direction_at_vertex(t, t.index(result.vertices[i]), {p, v});
    const double length = std::ldexp(std::hypot(v[0], v[1]), input.scale_exponent());
    result.status =
        d ? inserter.go(*d, length, t.index(result.vertices[i + 1])) : Move_status::not_traceable;
  }
  result.halfedges = inserter.paths().halfedges(t);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_CURVES_INSERT_POLYLINE_H
