// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_WEIGHTS_ABOVE_SIDE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_WEIGHTS_ABOVE_SIDE_H

#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>

#include <algorithm>
#include <array>
#include <cstdint>

/*!
\file
Points in a triangle that stands on a side from 0 to 1.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief returns where the third corner of the face of `h` is if the ends of `h` are at 0 and 1.
\tparam Complex a model of `NumberedComplex`
\pre `h` has a face, and a length
*/
template <class Complex>
Plane_vector<double> apex_above_side(const Complex& complex, std::uint32_t h) {
  const auto [ij, jk, ki] = squared_lengths_of_face(complex, h);
  return apex(ij, jk, ki, complex.quadruple_area(complex.face(h)));
}

/*!
\brief computes the barycentric coordinates of a point in a triangle with corners 0, 1 and `apex`.

In a thin triangle the weight of the apex, a quotient of small heights, is vague. So it only counts as far
as it lets the weights reproduce where the point is along the side, up to rounding.
\param p the point; moved into the triangle if it is outside
\param apex the third corner; with `y` zero or less, the triangle has no area
\return weights of 0, of 1 and of the apex: not negative, their sum is 1
*/
inline std::array<double, 3> weights_above_side(const Plane_vector<double>& p,
                                                const Plane_vector<double>& apex) {
  double least = 0, most = 1; // of the apex
  // Weights of 1 and 0 are not negative: k apex.x <= p.x and k (1 - apex.x) <= 1 - p.x. Where k gives way
  // the point moves up or down by apex.y, else it moves along the side by the slope: the less the better.
  const auto restrict_to = [&](double slope, double bound) {
    if (slope > apex.y) most = std::min(most, bound / slope);
    if (slope < -apex.y) least = std::max(least, bound / slope);
  };
  restrict_to(apex.x, p.x);
  restrict_to(1 - apex.x, 1 - p.x);
  most = std::max(most, 0.0);
  least = std::min(least, most);
  const double k = apex.y > 0 ? std::clamp(p.y / apex.y, least, most) : least;
  const double j = std::clamp(p.x - k * apex.x, 0.0, 1 - k);
  return {1 - k - j, j, k};
}

/// computes the same in a triangle with corners a, b, c. \pre a and b differ
inline std::array<double, 3> weights_in_triangle(const Plane_vector<double>& p,
                                                 const Plane_vector<double>& a,
                                                 const Plane_vector<double>& b,
                                                 const Plane_vector<double>& c) {
  const Plane_vector<double> side = b - a;
  const auto seen = [&](const Plane_vector<double>& q) {
    return conjugate(side) * (q - a) / dot(side, side);
  };
  return weights_above_side(seen(p), seen(c));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_WEIGHTS_ABOVE_SIDE_H
