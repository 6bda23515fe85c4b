// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Edge_path.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signpost_queries.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/follow_signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/signpost_coordinates.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_to_target.h>
#include <CGAL/Intrinsic_triangulations/tracing/tangent_frames.h>
#include <CGAL/Intrinsic_triangulations/tracing/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>

namespace CGAL::Intrinsic_triangulations::internal {

std::array<Corner_geodesic, 3> corner_geodesics(const Geodesic_face& face,
                                                const std::array<double, 3>& weights) {
  std::array<Corner_geodesic, 3> result;
  for (unsigned k = 0; k < 3; ++k) {
    const Plane_vector<double> back = face.to_corner(weights, k), v{0 - back[0], 0 - back[1]};
    const Plane_vector<double> relative = face.relative_to(k, v);
    const double length = std::hypot(v[0], v[1]);
    result[k] = {k, length, std::atan2(std::max(0.0, relative[1]), relative[0]),
                 length > 0 ? Plane_vector<double>{v[0] / length, v[1] / length}
                            : Plane_vector<double>{1, 0}};
  }
  std::sort(result.begin(), result.end(),
            [](const Corner_geodesic& a, const Corner_geodesic& b) { return a.length < b.length; });
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
