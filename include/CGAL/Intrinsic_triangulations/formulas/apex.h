// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_APEX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_APEX_H

#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>

#include <array>
#include <type_traits>

/*!
\file
Triangles ijk in the plane, counterclockwise, from squared lengths and quadruple areas; points in
them.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief returns p + i a, p = L_ij + L_ki - L_jk: the vector from i to k in the frame of the vector
from i to j, times 2 |ij|.

Its argument is the angle at i.
*/
template <RingNumber FT>
Plane_vector<FT> scaled_corner(const FT& ij, const FT& jk, const FT& ki, const FT& area) {
  return {ij + ki - jk, area};
}

/*!
\brief returns where k is if i is at 0 and j at 1, (p + i a) / (2 L_ij).

Wherever i and j are, k is at z_i + (z_j - z_i) `apex`: field operations place triangle after
triangle.
\pre `ij` is not zero
*/
template <FieldNumber FT>
Plane_vector<FT> apex(const FT& ij, const FT& jk, const FT& ki, const FT& area) {
  const Plane_vector<FT> corner = scaled_corner(ij, jk, ki, area);
  const FT twice = ij + ij;
  if constexpr (std::is_floating_point_v<FT>)
    return corner / twice;
  else // where a quotient takes longer than two products
    return FT(1) / twice * corner;
}

/// The sides i -> j, j -> k, k -> i as vectors of the plane.
using Plane_sides = std::array<Plane_vector<double>, 3>;

/*!
\brief returns the sides as vectors, with i -> j along the positive x-axis.

Each is computed for itself, and is as accurate as it is long: on needles differences of corners are
not.
\pre `ij` is not zero
*/
Plane_sides planar_sides(double ij, double jk, double ki, double area);

/*!
\brief computes the barycentric coordinates of a point in the triangle with corners a, b and c.

In a thin triangle the weight of c, a quotient of small heights above ab, is vague. So it is limited
such that no weight is negative and the weights reproduce the position of the point along ab, up to
rounding.
\param p the point; moved into the triangle if it is outside
\param a,b,c the corners; if c is not on the left of ab, the triangle has no area
\pre a and b differ
\return weights of a, b and c: not negative, their sum is 1
*/
std::array<double, 3> weights_in_triangle(const Plane_vector<double>& p,
                                          const Plane_vector<double>& a,
                                          const Plane_vector<double>& b,
                                          const Plane_vector<double>& c);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_APEX_H
