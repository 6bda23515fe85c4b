// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_SINGLE_SOURCE_LAST_PIECE_FINDER_H
#define CGAL_INTRINSIC_GEODESICS_SINGLE_SOURCE_LAST_PIECE_FINDER_H

#include <CGAL/Intrinsic_geodesics/distance/Distance_field.h>
#include <CGAL/Intrinsic_geodesics/distance/Path_tracer.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

// The last straight piece of the shortest path to a vertex. Its directions are angles from the
// first corner of a vertex, as the field has it: flips do not change them.
struct Last_piece {
  std::uint32_t from = Gluing::none; // the vertex where it begins
  double departure = 0;              // its direction there
  double arrival = 0;                // the direction back, where it ends
  double length = 0;
};

// Finds the last pieces of shortest paths.
class Last_piece_finder {
public:
  explicit Last_piece_finder(const Distance_field& field) : field_(field), tracer_(field) {}

  // `from` is `Gluing::none` if there is no path, or the path begins at the vertex
  Last_piece operator()(std::uint32_t v) {
    const Arrival& a = field_.vertices[v].arrival;
    if (a.kind != Arrival::Kind::straight || tracer_.trace(v, 1) != Status::done) return {};
    const std::uint32_t start = tracer_.places().back().side;
    const Plane_vector<double> d = tracer_.departure(),
                               back = field_.turned_to(a.corner(), a.image, a.side);
    return {field_.table.corners[start].origin, direction(start, d), direction(a.corner(), back),
            std::hypot(d.x, d.y)};
  }

private:
  // Of a vector in the frame of a corner. Not meant for a corner in another fan of a vertex that is
  // not manifold, but it ends there, too.
  double direction(std::uint32_t corner, Plane_vector<double> d) const {
    const Corner_table& table = field_.table;
    double angle = std::atan2(std::max(d.y, 0.0), d.x);
    const std::uint32_t first = table.first_corner[table.corners[corner].origin];
    for (std::uint32_t c = first; c != corner && c != Gluing::none;) {
      angle += std::atan2(table.corners[c].sine, table.corners[c].cosine);
      c = table.turn_left(c);
      if (c == first) break;
    }
    return angle;
  }

  const Distance_field& field_;
  Path_tracer tracer_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_SINGLE_SOURCE_LAST_PIECE_FINDER_H
