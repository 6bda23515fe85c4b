// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_shortest_path.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_to_target.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// The vertex that a point is named on, or `Gluing::none`.
std::uint32_t vertex_at(const Input& input, const Surface_point& p) {
  const unsigned corner = corner_of(p);
  return corner == 3 ? Gluing::none : input.source(sides_of_face(input, p.halfedge)[corner]);
}

// Whether both ends of a piece were so near to one vertex that rounding names them on it.
bool is_rounding(const Input& input, const Tangent_vector& from, std::uint32_t to, double length) {
  const std::array<double, 3> sides = Geodesic_face(input, from.point.halfedge).length;
  return to != Gluing::none && vertex_at(input, from.point) == to &&
         length <= 0x1p-36 * *std::max_element(sides.begin(), sides.end());
}

} // namespace

void append_piece(const Input& input, const Tangent_vector& from, const Surface_point& to,
                  std::vector<Strip_side>& strip, Traced_curve& curve) {
  const std::uint32_t vertex = vertex_at(input, to);
  const Geodesic_target target = vertex == Gluing::none ? Geodesic_target::at_point(input, to)
                                                        : Geodesic_target::at_vertex(vertex);
  const Plane_vector<double> v = scaled(from.vector, input.scale_exponent());
  const double length = std::hypot(v[0], v[1]);
  if (length == 0 || is_rounding(input, from, vertex, length)) return;
  const Geodesic_walk<Input> walk(input, from.point, v);
  const Geodesic_to_target line = trace_to_target(input, walk, target, length, strip);
  std::uint32_t face = input.face(walk.face().side[0]);
  if (!line.is_reached) curve.status = Status::inaccurate;
  for (const Strip_side& s : strip) {
    if (!line.is_reached) break;
    const double x = s.parameter(line.slope);
    curve.faces.push_back(input.face(s.halfedge));
    curve.points.push_back({s.halfedge ^ 1U, {x, 1 - x, 0}});
    face = input.face(s.halfedge ^ 1U);
  }
  curve.faces.push_back(face);
  curve.points.push_back(to);
}

} // namespace CGAL::Intrinsic_triangulations::internal
