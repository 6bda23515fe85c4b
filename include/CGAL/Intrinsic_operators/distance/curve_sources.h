// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_DISTANCE_CURVE_SOURCES_H
#define CGAL_INTRINSIC_OPERATORS_DISTANCE_CURVE_SOURCES_H

#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_operators/distance/distance_sources.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/points_in_one_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/within_rounding.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/*!
\file
Makes sources of distances of curves over the user's mesh.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief divides a curve over the input into sources, each through faces of the triangulation.
\tparam Triangulation a model of `CorrespondingTriangulation`, by curves
\param t the triangulation
\param curve the curve, such as `Found_curve::way`
\return a polyline for each straight piece; pieces of length zero are left out
\complexity that of `trace_geodesic()` for each piece
*/
template <QueriedTriangulation Triangulation>
std::vector<Polyline_source> polyline_sources(const Triangulation& t, const Traced_curve& curve) {
  const Input& input = t.input();
  std::vector<Polyline_source> pieces;
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    const auto in_face = [&](std::size_t k) {
      return internal::within_rounding(input, seen_in_face(input, curve.points[k], curve.faces[i]));
    };
    const Surface_point p = in_face(i), q = in_face(i + 1);
    const Unscaled_vector along = vector_between(input, p, q);
    const double length = std::hypot(along[0], along[1]);
    if (!(length > 0)) continue;
    const Tangent_vector start = tangent_to_intrinsic(t, {p, along}).value();
    pieces.push_back({trace_geodesic(t, start.point, start.vector, length).points});
  }
  return pieces;
}

/// returns the halfedges of a curve as sources: a border halfedge by the face on its other side.
/// \complexity linear
template <NumberedTriangulation Triangulation, std::ranges::input_range HalfedgeRange>
std::vector<Polyline_source> edge_sources(const Triangulation& t, const HalfedgeRange& curve) {
  std::vector<Polyline_source> pieces;
  for (const auto h : curve) {
    const std::uint32_t k = t.numbers().halfedge(h);
    if (face(h, t.mesh()) == boost::graph_traits<typename Triangulation::Mesh>::null_face())
      pieces.push_back({{{k ^ 1U, {0, 1, 0}}, {k ^ 1U, {1, 0, 0}}}});
    else
      pieces.push_back({{{k, {1, 0, 0}}, {k, {0, 1, 0}}}});
  }
  return pieces;
}

/*!
\brief returns the curve through places, each in one face with the next one, where it is straight.
\param t the triangulation
\param places the places, normalized
\return the curve over the input, without its length
\throws Invalid_input naming two places that are not in one face, or a vertex that was inserted
\complexity the product of the degrees of consecutive places
*/
template <QueriedTriangulation Triangulation>
Traced_curve curve_through(const Triangulation& t, const std::vector<Place>& places) {
  const Input& input = t.input();
  Place_finder<Triangulation> find(t);
  Traced_curve curve;
  for (const Place& p : places) {
    Surface_point q = p.is_vertex() ? Surface_point{} : point_on_input(input, p);
    if (p.is_vertex()) {
      const auto v = find.vertex(p.vertex);
      if (t.is_inserted(v))
        throw Invalid_input::about(
            Element_kind::vertex, p.vertex,
            " was inserted; between points in faces give the point where it is");
      const std::uint32_t h = input.outgoing_halfedge(t.index(v));
      q = {input.is_border(h) ? input.next(h ^ 1U) : h, {1, 0, 0}};
    }
    if (!curve.points.empty()) {
      const auto in_common = points_in_one_face(input, curve.points.back(), q);
      const std::size_t i = curve.faces.size();
      if (!in_common)
        throw Invalid_input(Element_kind::none, 0,
                            "points " + std::to_string(i) + " and " + std::to_string(i + 1) +
                                " are not in one face; give points between them, or a curve "
                                "through faces");
      curve.faces.push_back(input.face(in_common->first.halfedge));
    }
    curve.points.push_back(q);
  }
  return curve;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_DISTANCE_CURVE_SOURCES_H
