// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_QUERIES_TRACE_CURVE_H
#define CGAL_INTRINSIC_GEODESICS_QUERIES_TRACE_CURVE_H

#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Edge_path.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_edge.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/measures.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is the path of a curve over the input.
*/
struct Traced_curve {
  /// `done`. With `Signposts` only: `not_traceable`, and all else is empty; or `inaccurate`: a
  /// vertex may be on the wrong side of the curve.
  Status status = Status::done;
  /// Its start, the points where it crosses or meets edges and vertices of the input, its joints,
  /// and its end: the start again if it is a loop.
  std::vector<Surface_point> points;
  /// Faces of the input: from point i to the next one the curve is straight in face i.
  std::vector<std::uint32_t> faces;
  /// Its length, in the units of the input; with exact traits to 1e-12 of it.
  double length = 0;
  /// An interval that contains its length; [0, infinity] without error bounds from the traits, see
  /// `length_enclosure()`.
  Interval_nt<> length_enclosure{0};
};

/// describes a point from the halfedge of a face that it lies in, or on the boundary of; there may
/// be several ways if the face is glued to itself. A point that is not there is returned as it is.
Surface_point seen_in_face(const Input& input, const Surface_point& p, std::uint32_t f);

namespace internal {

// Appends a curve to another, which ends where it starts.
void append(const Traced_curve& way, Traced_curve& all);

template <class Triangulation>
void append_edge(const Triangulation& t, typename Triangulation::halfedge_descriptor h,
                 Traced_curve& curve) {
  const Edge_path path = trace_edge(t, edge(h, t.mesh()));
  if (path.status != Status::done) curve.status = path.status;
  if (path.points.empty()) return;
  const auto& input = t.correspondence().input();
  const std::size_t n = path.points.size();
  const bool is_forward = t.numbers().halfedge(h) % 2 == 0;
  const auto point = [&](std::size_t i) -> const Surface_point& {
    return path.points[is_forward ? i : n - 1 - i].on_input;
  };
  if (curve.points.empty()) curve.points.push_back(point(0));
  for (std::size_t i = 1; i < n; ++i) {
    // a point is named in the face that the edge enters there
    curve.faces.push_back(input.face(point(is_forward ? i - 1 : i).halfedge));
    curve.points.push_back(point(i));
  }
  curve.length += t.length(edge(h, t.mesh()));
  curve.length_enclosure += length_enclosure(t, edge(h, t.mesh()));
}

} // namespace internal

/*!
\brief traces a curve of halfedges of the intrinsic triangulation over the input.
\tparam Triangulation a model of `CorrespondingTriangulation`
\param t the triangulation
\param halfedges the halfedges, as of `Curve_network::halfedges()`
\complexity see `trace_edge()`
*/
template <QueriedTriangulation Triangulation, std::ranges::input_range HalfedgeRange>
Traced_curve trace_curve(const Triangulation& t, const HalfedgeRange& halfedges) {
  Traced_curve curve;
  for (const typename Triangulation::halfedge_descriptor h : halfedges) {
    internal::append_edge(t, h, curve);
    if (curve.status == Status::not_traceable) return {curve.status, {}, {}, 0, {0}};
  }
  return curve;
}

/// returns where a point of the input is in space. \param points coordinates of the user's vertices
std::array<double, 3> point_in_space(const Input& input, const Surface_point& p,
                                     const std::vector<std::array<double, 3>>& points);

/// returns a geodesic that was traced over the input, see `trace_geodesic_on_input()`, as a curve.
/// Its length has no bounds.
Traced_curve traced_curve(const Input& input, const Geodesic& geodesic);

/*!
\brief returns the points of a curve in space, in the type of points of the user's mesh.
\param t the triangulation
\param curve the result of `trace_curve()`
\param mesh the mesh that `t` was built from; its faces may be polygons
\throws Invalid_input if the mesh is another one
\complexity linear
*/
template <NumberedTriangulation Triangulation, ReadableFaceGraph Mesh>
auto polyline(const Triangulation& t, const Traced_curve& curve, const Mesh& mesh) {
  const internal::Named_mesh_elements<Mesh> named(internal::kept_input(t), mesh);
  std::vector<decltype(named.point({}))> points;
  for (const Surface_point& p : curve.points) points.push_back(named.point(p));
  return points;
}

/*!
\brief returns the places of the points of a curve on the user's mesh, each in the face where the
curve goes on; the last one in the face where the curve ends.
\param t, curve, mesh see `polyline()`; faces of the mesh are triangles
\throws Invalid_input if the mesh is another one, or has polygons on the way
\complexity linear
*/
template <NumberedTriangulation Triangulation, ReadableFaceGraph Mesh>
std::vector<Face_location<Mesh>> face_locations(const Triangulation& t, const Traced_curve& curve,
                                                const Mesh& mesh) {
  const internal::Named_mesh_elements<Mesh> named(internal::kept_input(t), mesh);
  const Input& input = internal::kept_input(t);
  std::vector<Face_location<Mesh>> result;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const std::size_t piece = i < curve.faces.size() ? i : i - 1;
    result.push_back(named.on_mesh(seen_in_face(input, curve.points[i], curve.faces[piece])));
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_QUERIES_TRACE_CURVE_H
