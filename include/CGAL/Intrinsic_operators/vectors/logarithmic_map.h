// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_LOGARITHMIC_MAP_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_LOGARITHMIC_MAP_H

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_operators/vectors/Point_frames.h>
#include <CGAL/Intrinsic_triangulations/connectivity/parameters.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief takes a vector from the polar coordinates of a vertex, those of a `Tangent_field`, to the
face that it points into. If it points out of the surface, the nearer side of the border replaces
it.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\param v the vertex, which is not isolated
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
  double a = std::arg(z); // outward vectors turn to the nearer side of the border
  if (a < (is_on_border ? -full / 4 : 0.)) a += full;
  const double turn = a * all / (is_on_border ? full / 2 : full);
  return internal::at_start(
      Geodesic_walk<Intrinsic_view<Triangulation>>(view, Corner_direction{first, turn}),
      std::abs(z));
}

/*!
\brief follows a vector at a vertex straight over the surface, for its length (§2.4.2 of the
course): the exponential map, the inverse of logarithmic maps.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\param v the vertex, which is not isolated
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

namespace internal {

// The result of `to_frame` for the logarithm of each vertex, by its number. The visitor of the
// search is asked again and again.
template <class Triangulation, class NP, class To_frame>
std::vector<std::complex<double>> logarithms(const Point_frames<Triangulation>& frames,
                                             const Polyhedral_distance<Triangulation>& distance,
                                             const NP& np, const To_frame& to_frame) {
  expect_tangent_planes(frames.triangulation());
  auto stored_visitor = object_or<tags::visitor>(np, Polyhedral_distance_visitor());
  auto& observed = unwrapped(stored_visitor);
  std::vector<std::complex<double>> result(frames.size(), unknown_vector);
  std::size_t count = 0;
  for (const auto v : vertices(frames.triangulation().mesh())) {
    if (++count % 1024 == 0 &&
        !observed.progress(distance.number_of_windows(), distance.reached_distance()))
      break;
    const Tangent_vector x = distance.logarithm(v);
    if (std::isfinite(x.vector[0])) result[frames.number(v)] = to_frame(x);
  }
  return result;
}

} // namespace internal

/*!
\brief finds the logarithmic map of a vertex, without discretization: for each vertex the vector at
  `v` along the shortest path to it, as long as the path (see `exponential_map()`).

Lengths and directions are those of `Polyhedral_distance`, so the result does not depend on the
triangulation of the surface. In the plane it is the displacement. Shortest paths bend only at
vertices with more than a full turn of angle: all vertices behind such a vertex have its direction.
\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\param t the triangulation
\param v the vertex, which is not isolated
\param np named parameters of `Polyhedral_distance`: `maximum_distance(d)` finds the map near the
vertex only, and takes less time. The visitor is called while vectors are found, too; if it ends the
work, the others are NaN
\return by the numbers of a `Tangent_field`, vectors in the coordinates of `v`; NaN on other
components and beyond the maximum distance
\throws std::invalid_argument if the vertex is isolated, or the surface is that of a cloud of
  points, see `Point_cloud_vectors`
\complexity that of `Polyhedral_distance`, and linear in the number of edges that all shortest
  paths cross
*/
template <ConnectedTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
std::vector<std::complex<double>> logarithmic_map(const Triangulation& t,
                                                  typename Triangulation::vertex_descriptor v,
                                                  const NP& np = parameters::default_values()) {
  const internal::Point_frames<Triangulation> frames(t);
  const std::uint32_t i = frames.number(v);
  if (frames.is_isolated(v))
    throw std::invalid_argument("vertex " + std::to_string(i) +
                                " has no face, so that there are no vectors at it");
  return internal::logarithms(frames, Polyhedral_distance<Triangulation>(t, v, np), np,
                              [&](const Tangent_vector& x) {
                                return frames.to_field(i, frames.at_corner(x.point, x.vector));
                              });
}

/*!
\brief finds the logarithmic map of a point; see above.
\return vectors in the frame of `p.halfedge`; at a vertex, angles from the sides of its face are
  those on the surface
*/
template <ConnectedTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
std::vector<std::complex<double>> logarithmic_map(const Triangulation& t, const Surface_point& p,
                                                  const NP& np = parameters::default_values()) {
  const internal::Point_frames<Triangulation> frames(t);
  const bool is_at_vertex = internal::corner_of(p) < 3;
  return internal::logarithms(
      frames, Polyhedral_distance<Triangulation>(t, p, np), np, [&](const Tangent_vector& x) {
        return is_at_vertex ? frames.from_corner(p, frames.at_corner(x.point, x.vector))
                            : std::complex(x.vector[0], x.vector[1]);
      });
}

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(logarithmic_map)
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_LOGARITHMIC_MAP_H
