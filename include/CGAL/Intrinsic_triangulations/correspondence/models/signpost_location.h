// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_SIGNPOST_LOCATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_SIGNPOST_LOCATION_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/tangent_frames.h>
#include <CGAL/Intrinsic_triangulations/tracing/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

/*!
\file
Points and vectors taken from the intrinsic triangulation to the input and back by signposts: along the
geodesic from a corner of the face, which has the same direction and length on both (§3.4.3).
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a point on the other triangulation, and how vectors there are turned.
*/
struct Signpost_location {
  /// Whether the geodesic from a corner had its full length: it may leave the surface by rounding.
  bool is_found = false;
  /// The point.
  Surface_point point;
  /// Bound of the first order on its error, without that of the signpost.
  double error = 0;
  /// Direction of the geodesic at the point where it was given, in the frame of the halfedge there.
  Planar_vector<double> given{1, 0};
  /// Direction of the geodesic at `point`, in the frame of `point.halfedge`.
  Planar_vector<double> found{1, 0};

  /// takes a tangent vector from the frame where the point was given to that of `point.halfedge`.
  Planar_vector<double> transfer(const Planar_vector<double>& v) const {
    const double along = planar_dot(given, v), left = planar_cross(given, v);
    return {found[0] * along - found[1] * left, found[1] * along + found[0] * left};
  }
};

namespace internal {

/// The geodesic from a corner of a face to a point of it.
struct Corner_geodesic {
  unsigned corner;                 // of the face
  double length;                   // to the point
  double angle;                    // from the side that starts at the corner
  Planar_vector<double> direction; // in the frame of the face
};

// The geodesics from the corners of a face to a point, the shortest first.
inline std::array<Corner_geodesic, 3> corner_geodesics(const Geodesic_face& face,
                                                       const std::array<double, 3>& weights) {
  std::array<Corner_geodesic, 3> result;
  for (unsigned k = 0; k < 3; ++k) {
    const Planar_vector<double> back = face.to_corner(weights, k);
    const Planar_vector<double> v{0 - back[0], 0 - back[1]};
    const Planar_vector<double> relative = face.relative_to(k, v);
    const double length = std::hypot(v[0], v[1]);
    result[k] = {k, length, std::atan2(std::max(0.0, relative[1]), relative[0]),
                 length > 0 ? Planar_vector<double>{v[0] / length, v[1] / length}
                            : Planar_vector<double>{1, 0}};
  }
  std::sort(result.begin(), result.end(),
            [](const Corner_geodesic& a, const Corner_geodesic& b) { return a.length < b.length; });
  return result;
}

// Traces from the corners in turn until one succeeds; `walk` starts from a corner.
template <class Complex, class Start>
Signpost_location locate_from_corners(const Complex& complex, const Geodesic_face& face,
                                      const std::array<double, 3>& weights, Start start) {
  Signpost_location result;
  std::vector<Geodesic_crossing> crossings;
  for (const Corner_geodesic& g : corner_geodesics(face, weights)) {
    Geodesic_walk<Complex> walk = start(face.side[g.corner], g.angle);
    if (walk.is_blocked() && g.length > 0) continue;
    crossings.clear();
    const Geodesic_end end =
        finish_walk(complex, walk, g.length, {std::size_t{1} << 22U, false}, crossings);
    if (end.status != Status::done) continue;
    return {true, end.point, end.error, g.direction, end.direction};
  }
  return result;
}

// Finds the point of the input at a point of the intrinsic triangulation, along the geodesic from the nearest
// corner of its face that works.
template <class Triangulation, class Signposts>
Signpost_location find_on_input(const Triangulation& t, const Signposts& signposts,
                                const Surface_point& p) {
  const Intrinsic_view<Triangulation> view(t);
  return locate_from_corners(
      signposts.input(), Geodesic_face(view, p.halfedge), p.weights,
      [&](std::uint32_t h, double angle) { return signposts.walk(h, angle); });
}

// Finds the point of the intrinsic triangulation at a point of the input, likewise.
template <class Triangulation, class Signposts>
Signpost_location find_on_intrinsic(const Triangulation& t, const Signposts& signposts,
                                    const Surface_point& p) {
  const Intrinsic_view<Triangulation> view(t);
  return locate_from_corners(view, Geodesic_face(signposts.input(), p.halfedge), p.weights,
                             [&](std::uint32_t h, double angle) {
                               return Geodesic_walk<Intrinsic_view<Triangulation>>(
                                   view, signposts.intrinsic_direction(view, h, angle));
                             });
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_SIGNPOST_LOCATION_H
