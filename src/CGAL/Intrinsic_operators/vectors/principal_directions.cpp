// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/vectors/principal_directions.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent_field.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/scaling.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

using Points = std::vector<std::array<double, 3>>;

// the position of the source of a halfedge
Eigen::Vector3d at(const Input& input, const Points& points, std::uint32_t h) {
  const std::array<double, 3>& p = points[input.source(h)];
  return {p[0], p[1], p[2]};
}

// The angle between the normals of the faces at an edge, positive where the surface is convex,
// times the length of the edge.
double bending(const Input& input, const Points& points, std::uint32_t h) {
  const Eigen::Vector3d i = at(input, points, h), j = at(input, points, h ^ 1U),
                        k = at(input, points, input.next(input.next(h))),
                        m = at(input, points, input.next(input.next(h ^ 1U)));
  const Eigen::Vector3d e = j - i, normal = e.cross(k - i), other = (m - i).cross(e);
  const double length = e.norm();
  if (!(length > 0)) return 0;
  return std::atan2(e.dot(normal.cross(other)) / length, normal.dot(other)) * length;
}

// the area of the face of a halfedge
double face_area(const Input& input, const Points& points, std::uint32_t h) {
  const Eigen::Vector3d i = at(input, points, h), j = at(input, points, input.next(h)),
                        k = at(input, points, input.next(input.next(h)));
  return (j - i).cross(k - i).norm() / 2;
}

} // namespace

Tangent_field curvature_directions(const Input& input, const Points& of_user) {
  const Vertex_frames frames = input_frames(input);
  const Power_of_two to_scale(input.scale_exponent()); // products of four lengths neither overflow
  Points points = of_user;                             // nor vanish
  for (std::array<double, 3>& p : points)
    for (double& x : p) x = to_scale(x);
  std::vector<double> areas(input.number_of_vertices(), 0);
  Tangent_field squares(input.number_of_vertices(), 0);
  for (std::uint32_t h = 0; h < input.number_of_halfedges(); ++h) {
    if (input.is_border(h)) continue;
    const std::uint32_t v = input.names().vertices.user(input.source(h));
    areas[v] += face_area(input, points, h) / 3;
    if (input.is_border(h ^ 1U)) continue;
    squares[v] -= bending(input, points, h) / 4 * std::polar(1., 2 * frames.polar_angle(h));
  }
  for (std::size_t i = 0; i < squares.size(); ++i)
    squares[i] = areas[i] > 0 ? std::polar(to_scale(std::abs(squares[i]) / areas[i]),
                                           std::arg(squares[i]) / 2)
                              : 0;
  return squares;
}

} // namespace CGAL::Intrinsic_triangulations::internal
