// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_PRINCIPAL_DIRECTIONS_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_PRINCIPAL_DIRECTIONS_H

#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent_field.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The directions in the frames of the vertices of an input.
// \param points a point per vertex of the input
Tangent_field curvature_directions(const Input& input,
                                   const std::vector<std::array<double, 3>>& points);

// The same on the triangulation, zero at inserted vertices.
// \param at the position in space of the source of a halfedge of the input
template <class Triangulation, class Place>
Tangent_field principal_directions_at(const Triangulation& t, const Place& at) {
  const Input& input = kept_input(t);
  std::vector<std::array<double, 3>> points(input.number_of_vertices());
  for (std::uint32_t h = 0; h < input.number_of_halfedges(); ++h) points[input.source(h)] = at(h);
  Tangent_field result = tangent_field_to_intrinsic(t, curvature_directions(input, points));
  std::fill(result.begin() + input.number_of_vertices(), result.end(), 0);
  return result;
}

} // namespace internal

/*!
\brief finds the directions of greatest curvature of the user's mesh, as a guide for fields of lines
or crosses.

The curvature of a neighbourhood is the sum over its edges of the angle between their faces
(Cohen-Steiner and Morvan 2003); directions are orthogonal to convex edges.
\tparam Triangulation a model of `CorrespondingTriangulation`, measured
\tparam Mesh the type of the user's mesh
\param t the triangulation
\param mesh the mesh that `t` was built from, its faces triangles
\return a vector at each vertex in the coordinates of `t`, one of two opposite ones, as long as half
  the difference of the principal curvatures, in 1 / length; zero at inserted vertices, where fields
  interpolate
\throws Invalid_input if the mesh is another one
\complexity linear, and that of `tangent_field_to_intrinsic()`
*/
template <QueriedTriangulation Triangulation, ReadableFaceGraph Mesh>
Tangent_field principal_directions(const Triangulation& t, const Mesh& mesh) {
  const Input& input = internal::kept_input(t);
  return internal::principal_directions_at(t, [&](std::uint32_t h) {
    return Mesh_adaptor<Mesh>::coordinates(point_in_space(
        t,
        Surface_point{input.is_border(h) ? h ^ 1U : h,
                      {input.is_border(h) ? 0. : 1., input.is_border(h) ? 1. : 0., 0}},
        mesh));
  });
}

/*!
\brief finds them from the points of the user's vertices, without a mesh; see above.
\param t the triangulation
\param points a point per row of the input
\throws std::invalid_argument if there are fewer points
*/
template <QueriedTriangulation Triangulation>
Tangent_field principal_directions(const Triangulation& t,
                                   const std::vector<std::array<double, 3>>& points) {
  const Input& input = internal::kept_input(t);
  if (points.size() < input.number_of_rows())
    throw std::invalid_argument("there must be a point per vertex of the input, " +
                                std::to_string(input.number_of_rows()) + ", not " +
                                std::to_string(points.size()));
  return internal::principal_directions_at(
      t, [&](std::uint32_t h) { return points[input.names().row(input.source(h))]; });
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_PRINCIPAL_DIRECTIONS_H
