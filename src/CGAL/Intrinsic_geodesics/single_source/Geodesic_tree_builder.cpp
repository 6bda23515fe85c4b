// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/distance/Distance_field.h>
#include <CGAL/Intrinsic_geodesics/distance/trace_back.h>
#include <CGAL/Intrinsic_geodesics/single_source/Geodesic_tree_builder.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

// The direction of a vector in the frame of a corner. It also ends for a corner in another fan of a
// nonmanifold vertex, but is meaningless there.
static double direction_at_vertex(const Corner_table& table, std::uint32_t corner,
                                  Plane_vector<double> d) {
  double angle = std::atan2(std::max(d.y, 0.0), d.x);
  const std::uint32_t first = table.first_corner[table.corners[corner].origin];
  for (std::uint32_t c = first; c != corner && c != Gluing::none;) {
    angle += std::atan2(table.corners[c].sine, table.corners[c].cosine);
    c = table.turn_left(c);
    if (c == first) break;
  }
  return angle;
}

Last_piece last_piece(const Distance_field& field, std::uint32_t v) {
  const Arrival& a = field.vertices[v].arrival;
  if (a.kind != Arrival::Kind::straight) return {};
  const Traced_back path = trace_back(field, v, 1);
  if (path.status != Status::done) return {};
  const std::uint32_t start = path.places.back().side;
  const Plane_vector<double>& d = path.departure;
  return {
      field.table.corners[start].origin, direction_at_vertex(field.table, start, d),
      direction_at_vertex(field.table, a.corner(), field.turned_to(a.corner(), a.image, a.side)),
      std::hypot(d.x, d.y)};
}

} // namespace CGAL::Intrinsic_triangulations::internal
