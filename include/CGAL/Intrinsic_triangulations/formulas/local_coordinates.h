// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_LOCAL_COORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_LOCAL_COORDINATES_H

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/compensated_arithmetic.h>
#include <CGAL/Intrinsic_triangulations/formulas/corner_angles.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <array>

/*!
\file
Coordinates of a triangle in the plane and in space, and the way from them to barycentric ones.

Points and vectors in barycentric coordinates are arrays of three numbers, for i, j, k; those of a
point sum to one, those of a vector to zero. Notation, number types and the meaning of error bounds
are those of `triangle_formulas.h`. See §2.3.7 and Eqs. 24 to 26 of the course.
*/

namespace CGAL::Intrinsic_triangulations {

/// Point or vector in the plane.
template <class FT>
using Planar_vector = std::array<FT, 2>;

/// Positions of i, j, k in the plane, counterclockwise.
template <class FT>
using Planar_triangle = std::array<Planar_vector<FT>, 3>;

/*!
\brief lays out a triangle in the plane: i at the origin, j on the positive x-axis, k above.

k is at (p_i / (2 l_ij), a / (2 l_ij)): Eq. 25, and in place of Eq. 26 its value without square root,
cancellation or case distinction. A needle keeps its shape best if its shortest side is `ij`.
\param a the quadruple area
\pre `L_ij > 0`
\return the positions; each coordinate has the relative error of `a` or `twice_inner_product()`, and
  3 u
*/
template <class FT>
Planar_triangle<FT> planar_layout(const FT& L_ij, const FT& L_jk, const FT& L_ki, const FT& a) {
  CGAL_precondition(L_ij > FT(0));
  const FT l = CGAL::sqrt(L_ij);
  const FT two_l = l + l;
  return {{{FT(0), FT(0)}, {l, FT(0)}, {twice_inner_product(L_ij, L_jk, L_ki) / two_l, a / two_l}}};
}

/*!
\brief lays out a triangle given by lengths, in the same position.
\pre `satisfies_triangle_inequality()`, `l_ij > 0`
*/
template <class FT>
Planar_triangle<FT> planar_layout_from_lengths(const FT& l_ij, const FT& l_jk, const FT& l_ki) {
  CGAL_precondition(l_ij > FT(0));
  const FT two_l = l_ij + l_ij;
  return {{{FT(0), FT(0)},
           {l_ij, FT(0)},
           {twice_inner_product_from_lengths(l_ij, l_jk, l_ki) / two_l,
            quadruple_area_from_lengths(l_ij, l_jk, l_ki) / two_l}}};
}

/*!
\brief lays out both triangles at an edge: i at the origin, j on the positive x-axis, k above, m
below.
\pre `d.ij > 0`
\return the positions of i, j, k, m, as accurate as those of `planar_layout()`
*/
template <class FT>
std::array<Planar_vector<FT>, 4> planar_layout(const Diamond_values<FT>& d) {
  const Planar_triangle<FT> f = planar_layout(d.ij, d.jk, d.ki, d.area_f);
  const FT two_l = f[1][0] + f[1][0];
  return {{f[0], f[1], f[2], {twice_inner_product(d.ij, d.mj, d.im) / two_l, -d.area_g / two_l}}};
}

/*!
\brief lays out a triangle in space, one vertex on each axis.

i is at (d_i, 0, 0), j at (0, d_j, 0), k at (0, 0, d_k), with d_i = sqrt(p_i / 2): the diagonal of
the matrix D that takes barycentric coordinates to space. Obtuse triangles have no such position.
\pre no angle exceeds a right one
\return d_i, d_j, d_k, with relative error at most 2 u + O(u^2) L / d^2
*/
template <class FT>
std::array<FT, 3> axis_layout(const FT& L_ij, const FT& L_jk, const FT& L_ki) {
  const FT p_i = twice_inner_product(L_ij, L_jk, L_ki);
  const FT p_j = twice_inner_product(L_jk, L_ki, L_ij);
  const FT p_k = twice_inner_product(L_ki, L_ij, L_jk);
  CGAL_precondition(p_i >= FT(0));
  CGAL_precondition(p_j >= FT(0));
  CGAL_precondition(p_k >= FT(0));
  return {CGAL::sqrt(FT(p_i / FT(2))), CGAL::sqrt(FT(p_j / FT(2))), CGAL::sqrt(FT(p_k / FT(2)))};
}

/// takes a point or vector from barycentric coordinates to those of `axis_layout()`, x = D b.
template <class FT>
std::array<FT, 3> axis_coordinates(const std::array<FT, 3>& layout, const std::array<FT, 3>& b) {
  return {layout[0] * b[0], layout[1] * b[1], layout[2] * b[2]};
}

/*!
\brief takes a point or vector from the coordinates of `axis_layout()` to barycentric ones, b =
D^-1 x.
\pre all angles are acute, so that D is regular
*/
template <class FT>
std::array<FT, 3> barycentric_from_axis_coordinates(const std::array<FT, 3>& layout,
                                                    const std::array<FT, 3>& x) {
  CGAL_precondition(layout[0] != FT(0));
  CGAL_precondition(layout[1] != FT(0));
  CGAL_precondition(layout[2] != FT(0));
  return {x[0] / layout[0], x[1] / layout[1], x[2] / layout[2]};
}

namespace internal {

// (q - p) x (r - p)
template <class FT>
FT planar_cross(const std::array<FT, 2>& p, const std::array<FT, 2>& q,
                const std::array<FT, 2>& r) {
  return difference_of_products(difference(q[0], p[0]), difference(r[1], p[1]),
                                difference(q[1], p[1]), difference(r[0], p[0]));
}

// (q - p) x v
template <class FT>
FT planar_cross_with_vector(const std::array<FT, 2>& p, const std::array<FT, 2>& q,
                            const std::array<FT, 2>& v) {
  const FT zero(0);
  return difference_of_products(difference(q[0], p[0]), Unevaluated_sum<FT>{v[1], zero},
                                difference(q[1], p[1]), Unevaluated_sum<FT>{v[0], zero});
}

} // namespace internal

/*!
\brief computes barycentric coordinates of a point of the plane as ratios of areas.

b_k = (f_j - f_i) x (p - f_i) / 2A and so on. Floating point types keep the rounding errors of
differences and products, so that each coordinate is accurate for itself on needles and caps.
\pre the triangle has an area
\return the coordinates, which sum to one up to their errors: each has relative error at most 7 u,
  up to O(u^2) times the product of its sides over its area
*/
template <class FT>
std::array<FT, 3> barycentric_coordinates_of_point(const Planar_triangle<FT>& f,
                                                   const Planar_vector<FT>& p) {
  const FT area = internal::planar_cross(f[0], f[1], f[2]);
  CGAL_precondition(area != FT(0));
  return {internal::planar_cross(f[1], f[2], p) / area,
          internal::planar_cross(f[2], f[0], p) / area,
          internal::planar_cross(f[0], f[1], p) / area};
}

/*!
\brief computes barycentric coordinates of a vector of the plane, w_k = (f_j - f_i) x v / 2A and so
on.
\pre the triangle has an area
\return the coordinates, which sum to zero up to their errors, as for
  `barycentric_coordinates_of_point()`
*/
template <class FT>
std::array<FT, 3> barycentric_coordinates_of_vector(const Planar_triangle<FT>& f,
                                                    const Planar_vector<FT>& v) {
  const FT area = internal::planar_cross(f[0], f[1], f[2]);
  CGAL_precondition(area != FT(0));
  return {internal::planar_cross_with_vector(f[1], f[2], v) / area,
          internal::planar_cross_with_vector(f[2], f[0], v) / area,
          internal::planar_cross_with_vector(f[0], f[1], v) / area};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_LOCAL_COORDINATES_H
