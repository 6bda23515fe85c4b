// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRACING_WITHIN_ROUNDING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRACING_WITHIN_ROUNDING_H

#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// A point within rounding of a corner or a side of its face, at it.
// \param nearness how far it may be away, as a part of the longest side
// \param least smaller weights count as zero, however large the face is
// \pre the halfedge of the point has a face
template <NumberedComplex Complex>
Surface_point within_rounding(const Complex& complex, const Surface_point& p,
                              double nearness = 0x1p-40, double least = 0) {
  const Geodesic_face face(complex, p.halfedge);
  const double area = complex.quadruple_area(complex.face(p.halfedge)),
               tolerance = nearness * *std::max_element(face.length.begin(), face.length.end());
  double nearest = std::numeric_limits<double>::infinity();
  Surface_point result = p;
  for (unsigned k = 0; k < 3; ++k) {
    const unsigned last = (k + 1) % 3, apex = (k + 2) % 3;
    const Plane_vector<double> to_corner = face.to_corner(p.weights, k);
    if (std::hypot(to_corner[0], to_corner[1]) <= tolerance ||
        (p.weights[last] < least && p.weights[apex] < least)) {
      result.weights = {0, 0, 0};
      result.weights[k] = 1;
      return result;
    }
    const double length = face.length[k], away = p.weights[apex] * area / (2 * length);
    const bool is_near = away < tolerance || p.weights[apex] < least;
    if (!is_near || !(away < nearest)) continue;
    nearest = away;
    const double x = std::clamp(-dot(to_corner, face.edge[k]) / (length * length), 0., 1.);
    result.weights[k] = 1 - x;
    result.weights[last] = x;
    result.weights[apex] = 0;
  }
  const bool is_on_side = std::count(p.weights.begin(), p.weights.end(), 0.) > 0; // exactly
  return is_on_side ? p : result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRACING_WITHIN_ROUNDING_H
