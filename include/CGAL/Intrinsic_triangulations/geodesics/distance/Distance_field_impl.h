// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_DISTANCE_DISTANCE_FIELD_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_DISTANCE_DISTANCE_FIELD_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/geodesics/distance/Distance_field.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace CGAL::Intrinsic_triangulations::internal {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::span<const std::uint32_t>
Distance_field::sources_in_face(std::uint32_t face) const {
  const auto face_of = [this](std::uint32_t s) { return face_sources[s].side / 3; };
  const auto first = std::partition_point(sources_by_face.begin(), sources_by_face.end(),
                                          [&](std::uint32_t s) { return face_of(s) < face; });
  auto last = first;
  while (last != sources_by_face.end() && face_of(*last) == face) ++last;
  return {first, last};
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Plane_vector<double>
Distance_field::turned_to(std::uint32_t side, Plane_vector<double> p, std::uint32_t from) const {
  while (from != side) {
    const std::uint32_t n = Corner_table::next(from);
    // seen in the mirror, and turned about the target, where n starts
    const Plane_vector<double> back =
        turned({table.corners[from].length - p.x, p.y}, table.corners[n]);
    p = {back.x, -back.y};
    from = n;
  }
  return p;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Point_in_face
Distance_field::point(std::uint32_t side, const std::array<double, 3>& weights) const {
  const Window_face face(table, side);
  return {side,
          {weights[1] * face.base.length + weights[2] * face.apex.x, weights[2] * face.apex.y},
          weights};
}

// Through the windows of a side.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE void
Distance_field::look_through(std::uint32_t side, Plane_vector<double> p,
                             Distance_and_arrival& best) const {
  const double length = table.corners[side].length;
  windows.for_each(side, [&](const Stored_windows::Record& w) {
    const double distance = offset(w.source) + planar_distance(w.image, p);
    if (!(distance < best.distance)) return;
    const double crossing = w.image.x + (p.x - w.image.x) * (-w.image.y / (p.y - w.image.y));
    const double tolerance = window_angle_tolerance * length;
    if (crossing < Stored_windows::place(w.begin, length) - tolerance ||
        crossing > Stored_windows::place(w.end, length) + tolerance)
      return;
    best = {distance, {w.image, side, w.source, Arrival::Kind::straight}};
  });
}

// By way of the vertex where a side starts.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE void
Distance_field::go_to_corner(std::uint32_t side, Plane_vector<double> p,
                             Distance_and_arrival& best) const {
  const std::uint32_t v = table.corners[side].origin;
  const double distance = vertices[v].distance + planar_distance(p, {0, 0});
  if (distance < best.distance) best = {distance, {{0, 0}, side, v, Arrival::Kind::straight}};
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Distance_and_arrival
Distance_field::at(const Point_in_face& p) const {
  Distance_and_arrival best;
  const std::uint32_t face = p.side / 3;
  for (const std::uint32_t s : sources_in_face(face)) {
    const Point_in_face& source = face_sources[s];
    const Plane_vector<double> q = turned_to(p.side, source.point, source.side);
    const double distance = planar_distance(q, p.point);
    const auto number = static_cast<std::uint32_t>(vertices.size() + s);
    if (distance < best.distance) best = {distance, {q, p.side, number, Arrival::Kind::straight}};
  }
  for (std::uint32_t side = 3 * face; side < 3 * face + 3; ++side) {
    const Plane_vector<double> q = turned_to(side, p.point, p.side);
    go_to_corner(side, q, best);
    look_through(side, q, best);
  }
  return best;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_DISTANCE_DISTANCE_FIELD_IMPL_H
