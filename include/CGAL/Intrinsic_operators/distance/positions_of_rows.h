// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_DISTANCE_POSITIONS_OF_ROWS_H
#define CGAL_INTRINSIC_OPERATORS_DISTANCE_POSITIONS_OF_ROWS_H

#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The positions of the rows' vertices in space, in scaled units; not finite where unknown.
template <NumberedTriangulation Triangulation>
std::vector<std::array<double, 3>> positions_of_rows(const Triangulation& t) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::array<double, 3>> result(t.number_of_vertices(), {unknown, unknown, unknown});
  const Input_metric& metric = t.input().metric();
  const auto& points = metric.points();
  if (points.empty()) return {};
  for (std::uint32_t f = 0; f < metric.number_of_faces(); ++f)
    if (metric.has_excess(f)) return {}; // faces are not flat in space: chords do not bound
  for (const typename Triangulation::vertex_descriptor v : vertices(t.mesh())) {
    const std::uint32_t i = t.index(v);
    if (!t.is_inserted(v)) {
      if (i < points.size()) result[t.input_vertex(v)] = points[i];
      continue;
    }
    if constexpr (requires { t.places()->location(i); })
      if (const auto* places = t.places(); places != nullptr) {
        const Surface_point& p = places->location(i);
        std::array<double, 3> x{0, 0, 0};
        std::uint32_t h = p.halfedge;
        for (std::size_t k = 0; k < 3; ++k, h = places->input().next(h))
          for (std::size_t c = 0; c < 3; ++c)
            x[c] += p.weights[k] * points[places->input().source(h)][c];
        result[t.input_vertex(v)] = x;
      }
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_DISTANCE_POSITIONS_OF_ROWS_H
