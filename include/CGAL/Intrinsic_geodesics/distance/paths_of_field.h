// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_PATHS_OF_FIELD_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_PATHS_OF_FIELD_H

#include <CGAL/Intrinsic_geodesics/distance/Distance_field.h>
#include <CGAL/Intrinsic_geodesics/distance/Searched_surface.h>
#include <CGAL/Intrinsic_geodesics/distance/Shortest_path.h>
#include <CGAL/Intrinsic_geodesics/distance/trace_back.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// The shortest path to a vertex by number, or to a point in a face, that a search has found.
template <class Triangulation, class Place>
Shortest_path path_to(const Searched_surface<Triangulation>& surface, const Distance_field& field,
                      const Place& place, double length) {
  if (!std::isfinite(length)) return {Status::stalled, {}, false, length};
  const Traced_back path = trace_back(field, place);
  Shortest_path result{path.status, {}, false, length};
  result.is_on_input = surface.has_faces();
  for (const Path_place& p : path.places) result.points.push_back(surface.point(p));
  std::reverse(result.points.begin(), result.points.end());
  return result;
}

// The vector along it at the source, as long as the path.
template <class Triangulation, class Place>
Tangent_vector departure_to(const Searched_surface<Triangulation>& surface,
                            const Distance_field& field, const Place& to, double length) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const Tangent_vector none{{Gluing::none, {unknown, unknown, unknown}}, {unknown, unknown}};
  if (!std::isfinite(length)) return none;
  const Traced_back path = trace_back(field, to);
  if (path.status != Status::done || path.places.empty()) return none;
  const Path_place& place = path.places.back();
  const Plane_vector<double>& d = path.departure;
  const double norm = std::hypot(d.x, d.y), scale = norm > 0 ? length / norm : 0;
  if (norm == 0 && length > 0) return none; // from another copy of the source
  return {surface.point(place), {scale * d.x, scale * d.y}};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_PATHS_OF_FIELD_H
