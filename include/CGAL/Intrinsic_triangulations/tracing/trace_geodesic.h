// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRACING_TRACE_GEODESIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRACING_TRACE_GEODESIC_H

#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>
#include <CGAL/Intrinsic_triangulations/tracing/within_rounding.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

/*!
\file
The exponential map (§2.4.2 of the course): a geodesic from a point, in a direction, for a length.

A geodesic is straight inside faces and across edges. At an interior vertex it continues
straightest, with equal angles on both sides. It stops at the border, also at border vertices.

**Vertices.** A line hits a vertex if it leaves a face so close to it that rounding may have decided
the side (the distance is at most the error of the line, and at most 2^-30 of the side).
On a flat vertex this changes nothing beyond rounding. A line that starts within rounding of a
vertex starts there: it would seem to hit it sideways.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

/// Where a geodesic ended, and how.
struct Geodesic_end {
  Status status;       ///< whether the length was reached
  Surface_point point; ///< the end
  Plane_vector<double>
      direction; ///< unit vector along the geodesic, in the frame of `point.halfedge`
  double length; ///< length from start to end
  double error;  ///< first-order bound on the error of the end
};

/// Options of a geodesic.
struct Trace_options {
  /// Number of faces after which to give up: every trace ends.
  std::size_t maximum_faces = std::size_t{1} << 22U;
  /// Whether a line that meets a vertex up to rounding goes through it; otherwise it passes on one
  /// side.
  bool snaps_to_vertices = true;
};

// Whether the exit leads through a vertex up to rounding; `corner` becomes that corner of the face.
template <NumberedComplex Complex>
bool hits_vertex(const Geodesic_walk<Complex>& walk, typename Geodesic_walk<Complex>::Exit& e,
                 unsigned& corner) {
  const double length = walk.face().length[e.side];
  // however large the bound of the error gets, at most 2^-30 of the side counts as zero
  const double tolerance = std::min(walk.position_error(), 0x1p-30 * length);
  const bool is_at_source = e.target_weight <= e.source_weight;
  if (length * (is_at_source ? e.target_weight : e.source_weight) > tolerance) return false;
  e.target_weight = is_at_source ? 0 : 1;
  e.source_weight = 1 - e.target_weight;
  corner = (e.side + (is_at_source ? 0 : 1)) % 3;
  return true;
}

// End of a walk with a given length.
template <NumberedComplex Complex>
Geodesic_end finish_walk(const Complex& complex, Geodesic_walk<Complex> walk, double length,
                         const Trace_options& options, std::vector<Geodesic_crossing>& crossings) {
  length = std::max(0.0, length);
  const auto end = [&walk](Status status, const Surface_point& p, double travelled) {
    return Geodesic_end{status, p, walk.direction(), travelled, walk.position_error()};
  };
  if (walk.is_blocked())
    return end(length > 0 ? Status::border : Status::done, {walk.face().side[0], walk.weights()},
               0);
  for (std::size_t faces = 1;; ++faces) {
    typename Geodesic_walk<Complex>::Exit e = walk.exit();
    const double remaining = std::max(0.0, length - walk.travelled());
    if (remaining <= e.distance) {
      const Surface_point p = walk.point(e, remaining);
      walk.advance({e.side, e.source_weight, e.target_weight, remaining, e.slope});
      return end(Status::done, p, length);
    }
    if (faces >= options.maximum_faces) return end(Status::cap, walk.point(e, 0), walk.travelled());
    walk.advance(e);
    unsigned corner = 0;
    const bool is_at_vertex = options.snaps_to_vertices && hits_vertex(walk, e, corner);
    const std::uint32_t out = walk.halfedge(e);
    const Surface_point p = walk.point(e, e.distance);
    if (is_at_vertex ? !walk.pass_vertex(corner) : complex.is_border(out ^ 1U)) {
      const bool is_rounding = length - walk.travelled() <= walk.position_error();
      return end(is_rounding ? Status::done : Status::border, p,
                 is_rounding ? length : walk.travelled());
    }
    crossings.push_back({out, e.target_weight});
    if (!is_at_vertex) walk.cross(e);
  }
}

// Traces a geodesic from a point, in a direction in the frame of `start.halfedge`, over a model of
// `NumberedComplex` in its units. Appends the crossed edges to `crossings`; a geodesic through a
// vertex crosses the edge where it leaves the face, with parameter 0 or 1.
template <NumberedComplex Complex, class Units = void>
Geodesic_end trace_geodesic(const Complex& complex, const Surface_point& start,
                            const Plane_vector<double, Units>& direction, double length,
                            std::vector<Geodesic_crossing>& crossings,
                            const Trace_options& options = {}) {
  const Surface_point from = options.snaps_to_vertices ? within_rounding(complex, start) : start;
  return finish_walk(complex, Geodesic_walk<Complex>(complex, from, direction), length, options,
                     crossings);
}

extern template Geodesic_end finish_walk(const Input&, Geodesic_walk<Input>, double,
                                         const Trace_options&, std::vector<Geodesic_crossing>&);

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRACING_TRACE_GEODESIC_H
