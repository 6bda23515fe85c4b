// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_EXPONENTIAL_MAP_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_EXPONENTIAL_MAP_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>
#include <CGAL/Intrinsic_triangulations/triangulation/NumberedTriangulation.h>

#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief takes a vector from the polar coordinates of a vertex, those of a `Tangent_field`, to the face that it points into; on the border, one
that points out of the surface to the side of the border that is nearer.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\param v the vertex, not an isolated one
\param z the vector
\complexity linear in the degree
*/
template <NumberedTriangulation Triangulation>
Tangent_vector tangent_vector(const Triangulation& t, typename Triangulation::vertex_descriptor v,
                              const std::complex<double>& z) {
  const Intrinsic_view<Triangulation> view(t);
  const std::uint32_t first = view.outgoing_halfedge(t.index(v));
  bool is_on_border = false;
  const double all = cone_angle(view, first, is_on_border), full = 2 * std::numbers::pi;
  double a = std::arg(z); // on the border, what points out belongs to the nearer side of it
  if (a < (is_on_border ? -full / 4 : 0.)) a += full;
  const double turn = a * all / (is_on_border ? full / 2 : full);
  return internal::at_start(
      Geodesic_walk<Intrinsic_view<Triangulation>>(view, Corner_direction{first, turn}),
      std::abs(z));
}

/*!
\brief follows a vector at a vertex straight over the surface, for its length (§2.4.2 of the course): the exponential map, which
logarithmic maps undo.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\param v the vertex, not an isolated one
\param z the vector, in the polar coordinates of the vertex and the units of the input
\return the geodesic, whose last point is the result
\complexity that of `trace_geodesic()`
*/
template <NumberedTriangulation Triangulation>
Geodesic exponential_map(const Triangulation& t, typename Triangulation::vertex_descriptor v,
                         const std::complex<double>& z) {
  const Tangent_vector start = tangent_vector(t, v, z == 0. ? 1 : z);
  return trace_geodesic(t, start.point, start.vector, std::abs(z));
}

/// follows a vector at a point, in the frame of its halfedge; see above.
template <NumberedTriangulation Triangulation>
Geodesic exponential_map(const Triangulation& t, const Surface_point& p,
                         const std::complex<double>& z) {
  const std::complex<double> direction = z == 0. ? 1 : z;
  return trace_geodesic(t, p, {direction.real(), direction.imag()}, std::abs(z));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_EXPONENTIAL_MAP_H
