// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/position_on_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

std::array<double, 3> corner_in_input_face(const Input& input, const Common_subdivision& s,
                                           std::uint32_t base, std::size_t c) {
  const std::uint32_t v = s.corner[c];
  Surface_point p{s.input_halfedge[c], {1, 0, 0}};
  if (v >= s.vertices.size()) {
    const double x = s.crossings[v - s.vertices.size()].on_input.parameter;
    p.weights = {1 - x, x, 0};
    if (p.halfedge % 2 != 0) std::swap(p.weights[0], p.weights[1]);
  } else if (s.vertices[v].kind == Subdivision_vertex_kind::inserted) {
    p.weights = s.vertices[v].on_input.weights;
    if (p.halfedge != s.vertices[v].input_halfedge) std::swap(p.weights[0], p.weights[1]);
  }
  return seen_from(input, p, base).weights;
}

} // namespace internal

std::array<double, 3> position(const Weighted_vertices& w,
                               std::span<const std::array<double, 3>> points) {
  std::array<double, 3> p{0, 0, 0};
  for (std::size_t i = 0; i < w.size; ++i)
    for (std::size_t c = 0; c < 3; ++c) p[c] += w.weights[i] * points[w.vertices[i]][c];
  return p;
}

std::vector<std::array<double, 3>> positions(const Common_subdivision& s,
                                             std::span<const std::array<double, 3>> points) {
  std::vector<std::array<double, 3>> result;
  result.reserve(s.number_of_vertices());
  for (std::size_t v = 0; v < s.number_of_vertices(); ++v)
    result.push_back(position(s.on_input(v), points));
  return result;
}

std::vector<std::array<double, 3>> positions(const Common_subdivision& s,
                                             std::span<const std::array<double, 3>> points,
                                             const Input& input) {
  std::vector<std::array<double, 3>> result = positions(s, points);
  if (input.planar_polygons().empty()) return result;
  for (std::size_t v = 0; v < s.number_of_vertices(); ++v) {
    if (s.kind(v) == Subdivision_vertex_kind::input) continue;
    const std::uint32_t h = v < s.vertices.size()
                                ? s.vertices[v].input_halfedge
                                : 2 * s.crossings[v - s.vertices.size()].on_input.edge;
    const Weighted_vertices w = s.on_input(v);
    result[v] = internal::position_on_face(input, input.face(input.is_border(h) ? h ^ 1U : h),
                                           std::span(w.vertices).first(w.size), w.weights,
                                           [&points](std::uint32_t u) { return points[u]; });
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
