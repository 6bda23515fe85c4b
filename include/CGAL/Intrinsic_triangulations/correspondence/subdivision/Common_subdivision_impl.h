// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_COMMON_SUBDIVISION_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_COMMON_SUBDIVISION_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/position_on_face.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::array<double, 3>
position(const Weighted_vertices& w, std::span<const std::array<double, 3>> points) {
  std::array<double, 3> p{0, 0, 0};
  for (std::size_t i = 0; i < w.size; ++i)
    for (std::size_t c = 0; c < 3; ++c) p[c] += w.weights[i] * points[w.vertices[i]][c];
  return p;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::vector<std::array<double, 3>>
positions(const Common_subdivision& s, std::span<const std::array<double, 3>> points) {
  std::vector<std::array<double, 3>> result;
  result.reserve(s.number_of_vertices());
  for (std::size_t v = 0; v < s.number_of_vertices(); ++v)
    result.push_back(position(s.on_input(v), points));
  return result;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::vector<std::array<double, 3>>
positions(const Common_subdivision& s, std::span<const std::array<double, 3>> points,
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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_COMMON_SUBDIVISION_IMPL_H
