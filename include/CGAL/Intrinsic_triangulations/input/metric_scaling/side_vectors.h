// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_SIDE_VECTORS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_SIDE_VECTORS_H

#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>

#include <array>
#include <cmath>

/*!
\file
The sides of triangles as vectors of the plane, whatever lengths there are. They sum to zero only up to rounding.
*/

namespace CGAL::Intrinsic_triangulations {

/// The sides i -> j, j -> k, k -> i as vectors of space.
using Space_sides = std::array<std::array<double, 3>, 3>;

/*!
\brief computes the sides of a triangle from its squared lengths.

Where `ij` has length zero, `jk` lies on the x-axis. Lengths that violate the triangle inequality give a
triangle without area.
\return the vectors; each coordinate has an error of a few u times the length of its side
*/
inline Plane_sides planar_sides(double L_ij, double L_jk, double L_ki) {
  if (L_ij == 0) return {{{0, 0}, {std::sqrt(L_jk), 0}, {-std::sqrt(L_ki), 0}}};
  const double squared_area = squared_quadruple_area(L_ij, L_jk, L_ki);
  return planar_sides(L_ij, L_jk, L_ki, squared_area > 0 ? std::sqrt(squared_area) : 0);
}

/*!
\brief computes the sides of a triangle in space, from its sides as vectors of space.

Where `ij` has length zero, `jk` lies on the x-axis. Without area k has height zero.
\param s the vectors i -> j, j -> k, k -> i
\return the vectors; each coordinate has an error of a few u times the length of its side
*/
inline Plane_sides planar_sides(const Space_sides& s) {
  const auto length = [](const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); };
  const double l = length(s[0]);
  if (l == 0) return {{{0, 0}, {length(s[1]), 0}, {-length(s[2]), 0}}};
  const std::array<double, 3> x{s[0][0] / l, s[0][1] / l, s[0][2] / l};
  const auto along = [&x](const std::array<double, 3>& v) {
    return x[0] * v[0] + x[1] * v[1] + x[2] * v[2];
  };
  const auto across = [&x](const std::array<double, 3>& v) {
    return std::hypot(x[1] * v[2] - x[2] * v[1], x[2] * v[0] - x[0] * v[2],
                      x[0] * v[1] - x[1] * v[0]);
  };
  return {{{l, 0}, {along(s[1]), across(s[1])}, {along(s[2]), -across(s[2])}}};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_SIDE_VECTORS_H
