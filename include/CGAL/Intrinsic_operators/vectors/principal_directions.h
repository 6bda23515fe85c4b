// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_PRINCIPAL_DIRECTIONS_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_PRINCIPAL_DIRECTIONS_H

#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent_field.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The angle between the normals of the faces at an edge, positive where the surface is convex,
// times the length of the edge.
template <class Place>
double bending(const Input& input, std::uint32_t h, const Place& at) {
  const Eigen::Vector3d i = at(h), j = at(h ^ 1U), k = at(input.next(input.next(h))),
                        m = at(input.next(input.next(h ^ 1U)));
  const Eigen::Vector3d e = j - i, normal = e.cross(k - i), other = (m - i).cross(e);
  const double length = e.norm();
  if (!(length > 0)) return 0;
  return std::atan2(e.dot(normal.cross(other)) / length, normal.dot(other)) * length;
}

// \param at the position in space of the source of a halfedge of the input
template <class Triangulation, class Place>
Tangent_field principal_directions_at(const Triangulation& t, const Place& at) {
  const Input& input = kept_input(t);
  const Vertex_frames frames = input_frames(input);
  std::vector<double> areas(input.number_of_vertices(), 0);
  Tangent_field squares(input.number_of_vertices(), 0);
  for (std::uint32_t h = 0; h < input.number_of_halfedges(); ++h) {
    if (input.is_border(h)) continue;
    const std::uint32_t v = input.names().vertices.user(input.source(h));
    areas[v] += (at(input.next(h)) - at(h)).cross(at(input.next(input.next(h))) - at(h)).norm() / 6;
    if (input.is_border(h ^ 1U)) continue;
    squares[v] -= bending(input, h, at) / 4 * std::polar(1., 2 * frames.polar_angle(h));
  }
  for (std::size_t i = 0; i < squares.size(); ++i)
    squares[i] =
        areas[i] > 0 ? std::polar(std::abs(squares[i]) / areas[i], std::arg(squares[i]) / 2) : 0;
  Tangent_field result = tangent_field_to_intrinsic(t, squares);
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
    const auto p = Mesh_adaptor<Mesh>::coordinates(point_in_space(
        t,
        Surface_point{input.is_border(h) ? h ^ 1U : h,
                      {input.is_border(h) ? 0. : 1., input.is_border(h) ? 1. : 0., 0}},
        mesh));
    return Eigen::Vector3d(p[0], p[1], p[2]);
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
  return internal::principal_directions_at(t, [&](std::uint32_t h) {
    const std::array<double, 3>& p = points[input.names().row(input.source(h))];
    return Eigen::Vector3d(p[0], p[1], p[2]);
  });
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_PRINCIPAL_DIRECTIONS_H
