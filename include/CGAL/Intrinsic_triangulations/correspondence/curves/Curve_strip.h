// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CURVE_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CURVE_STRIP_H

#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/formulas/Development.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is the strip of faces that a curve passes from the corner where it starts.
*/
struct Curve_strip {
  /// The faces; the curve starts at point 0, and ends at the last point.
  Development<> faces;
  /// The corner in which it ends, as the start of the way back.
  Curve_end end;

  /*!
  \brief follows a curve.
  \param complex the intrinsic triangulation
  \param coordinates its normal coordinates
  \param start where the curve starts; it crosses the face there
  */
  template <class Complex, class Coordinates>
  Curve_strip(const Complex& complex, const Coordinates& coordinates, const Curve_end& start) {
    faces.start(start.halfedge);
    end = follow_curve(
        complex, coordinates, first_crossing(complex, coordinates, start),
        [&](const Curve_crossing& c) { faces.enter(complex, faces.last(), c.halfedge ^ 1U); });
  }

  /// returns the positions of all points, with the first side of the first face from 0 to 1.
  template <class Complex>
  std::vector<Plane_vector<double>> develop(const Complex& complex) const {
    std::vector<Plane_vector<double>> z;
    faces.develop(z, approximate_values(complex));
    return z;
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CURVE_STRIP_H
