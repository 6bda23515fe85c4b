// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_APEX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_APEX_H

#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>

#include <array>
#include <cmath>
#include <type_traits>

/*!
\file
Triangles ijk in the plane, counterclockwise, from squared lengths and quadruple areas.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief returns p + i a, p = L_ij + L_ki - L_jk: the vector from i to k in the frame of the vector from i to j, times 2 |ij|.

Its argument is the angle at i.
*/
template <class FT>
Plane_vector<FT> scaled_corner(const FT& ij, const FT& jk, const FT& ki, const FT& area) {
  return {ij + ki - jk, area};
}

/*!
\brief returns where k is if i is at 0 and j at 1, (p + i a) / (2 L_ij).

Wherever i and j are, k is at z_i + (z_j - z_i) `apex`: field operations place triangle after triangle.
\pre `ij` is not zero
*/
template <class FT>
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

Each is computed for itself, and is as accurate as it is long: on needles differences of corners are not.
\pre `ij` is not zero
*/
inline Plane_sides planar_sides(double ij, double jk, double ki, double area) {
  const double l = std::sqrt(ij), two_l = 2 * l, height = area / two_l;
  return {{{l, 0},
           {-twice_inner_product(jk, ki, ij) / two_l, height},
           {-twice_inner_product(ij, jk, ki) / two_l, -height}}};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_APEX_H
