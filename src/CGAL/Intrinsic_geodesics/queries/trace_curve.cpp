// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

Surface_point seen_in_face(const Input& input, const Surface_point& p, std::uint32_t f) {
  const std::uint32_t base = input.halfedge_of_face(f);
  if (input.face(p.halfedge) == f) return seen_from(input, p, base);
  std::uint32_t h = p.halfedge;
  for (std::size_t k = 0; k < 3; ++k, h = input.next(h)) {
    const double x = p.weights[(k + 1) % 3];
    if (p.weights[(k + 2) % 3] == 0 && !input.is_border(h ^ 1U) && input.face(h ^ 1U) == f)
      return seen_from(input, {h ^ 1U, {x, 1 - x, 0}}, base);
  }
  for (std::size_t k = 0; k < 3; ++k, h = input.next(h))
    if (p.weights[k] == 1)
      for (std::uint32_t g = base, n = 0; n < 3; ++n, g = input.next(g))
        if (input.names().row(input.source(g)) == input.names().row(input.source(h)))
          return seen_from(input, {g, {1, 0, 0}}, base); // or a copy of it, on a cover
  return p;
}

std::array<double, 3> point_in_space(const Input& input, const Surface_point& p,
                                     const std::vector<std::array<double, 3>>& points) {
  return internal::combination_of_corners(input, p, [&](std::uint32_t v) { return points[v]; });
}

Traced_curve traced_curve(const Input& input, const Geodesic& geodesic) {
  Traced_curve curve;
  curve.status = geodesic.status;
  curve.points = geodesic.points;
  // a point is named in the face before it
  for (std::size_t i = 1; i < geodesic.points.size(); ++i)
    curve.faces.push_back(input.face(geodesic.points[i].halfedge));
  curve.length = geodesic.length;
  curve.length_enclosure = {0, std::numeric_limits<double>::infinity()};
  return curve;
}

void internal::append(const Traced_curve& way, Traced_curve& all) {
  if (way.points.empty()) return;
  all.points.insert(all.points.end(), way.points.begin() + (all.points.empty() ? 0 : 1),
                    way.points.end());
  all.faces.insert(all.faces.end(), way.faces.begin(), way.faces.end());
  all.length += way.length;
  all.length_enclosure += way.length_enclosure;
}

} // namespace CGAL::Intrinsic_triangulations
