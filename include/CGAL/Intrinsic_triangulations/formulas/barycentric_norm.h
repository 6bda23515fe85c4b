// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_BARYCENTRIC_NORM_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_BARYCENTRIC_NORM_H

#include <CGAL/Intrinsic_triangulations/formulas/compensated_arithmetic.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>

#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>

#include <array>

/*!
\file
Inner product, norm and distance in barycentric coordinates, from squared lengths (Eq. 23, §2.3.7).

A vector is an array of three numbers that sum to zero, for i, j, k. Rounding leaves a sum: the
component at one end of the shortest side is then taken to be minus the sum of the others. Notation,
number types and the meaning of error bounds are those of `triangle_formulas.h`.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Half the sum over the sides of -L_ij (u_i v_j + u_j v_i): Eq. 23 polarised. Cancels on needles.
template <class FT>
FT inner_product_by_eq_23(const std::array<FT, 3>& L, const std::array<FT, 3>& u,
                          const std::array<FT, 3>& v) {
  const FT sum = L[0] * (u[0] * v[1] + u[1] * v[0]) + L[1] * (u[1] * v[2] + u[2] * v[1]) +
                 L[2] * (u[2] * v[0] + u[0] * v[2]);
  return -sum / FT(2);
}

// The shortest side, by its first vertex.
template <class FT>
unsigned shortest_side(const std::array<FT, 3>& L) {
  const unsigned s = is_less(L[1], L[0]) ? 1 : 0;
  return is_less(L[2], L[s]) ? 2 : s;
}

// 2<bc, u>, where u = u_c bc + u_d bd and b, c, d are vertices s, s + 1, s + 2.
template <class FT>
FT twice_inner_product_with_side(const std::array<FT, 3>& L, unsigned s,
                                 const std::array<FT, 3>& u) {
  const FT &bc = L[s], &cd = L[(s + 1) % 3], &db = L[(s + 2) % 3];
  const FT &u_c = u[(s + 1) % 3], &u_d = u[(s + 2) % 3];
  if constexpr (is_floating_point<FT>) {
    const Unevaluated_sum<FT> p = two_sum(db, -cd, bc);
    return difference_of_products(2 * bc, u_c, -p.high, u_d) + p.low * u_d;
  } else
    return FT(2) * bc * u_c + ((db - cd) + bc) * u_d;
}

} // namespace internal

/*!
\brief computes the inner product of two vectors in barycentric coordinates.

Exact types evaluate Eq. 23, polarised. Other types evaluate the sum of the products of components
along and across the shortest side bc, (<bc, u> <bc, v> + (2A)^2 u_d v_d) / L_bc with d opposite:
its terms are as small as the result on needles, where those of Eq. 23 are not.
\pre the triangle inequality
\return the value, with error at most 12 u |u| |v|, up to O(u^2)
*/
template <class FT>
FT barycentric_inner_product(const FT& L_ij, const FT& L_jk, const FT& L_ki,
                             const std::array<FT, 3>& u, const std::array<FT, 3>& v) {
  const std::array<FT, 3> L{L_ij, L_jk, L_ki};
  if constexpr (internal::is_rounded<FT>) {
    const unsigned s = internal::shortest_side(L);
    if (certainly(L[s] > FT(0))) {
      const unsigned d = (s + 2) % 3;
      const FT along = internal::twice_inner_product_with_side(L, s, u) *
                       internal::twice_inner_product_with_side(L, s, v);
      return (along + squared_quadruple_area(L_ij, L_jk, L_ki) * (u[d] * v[d])) / (FT(4) * L[s]);
    }
  }
  return internal::inner_product_by_eq_23(L, u, v);
}

/*!
\brief computes the squared norm of a vector in barycentric coordinates (Eq. 23).
\pre the triangle inequality
\return the value, with relative error at most 12 u, up to O(u^2)
*/
template <class FT>
FT barycentric_squared_norm(const FT& L_ij, const FT& L_jk, const FT& L_ki,
                            const std::array<FT, 3>& u) {
  return barycentric_inner_product(L_ij, L_jk, L_ki, u, u);
}

/// computes the norm of a vector in barycentric coordinates, see `barycentric_squared_norm()`.
template <class FT>
FT barycentric_norm(const FT& L_ij, const FT& L_jk, const FT& L_ki, const std::array<FT, 3>& u) {
  return CGAL::sqrt(barycentric_squared_norm(L_ij, L_jk, L_ki, u));
}

/// computes the squared distance of two points of a triangle, see `barycentric_squared_norm()`.
template <class FT>
FT barycentric_squared_distance(const FT& L_ij, const FT& L_jk, const FT& L_ki,
                                const std::array<FT, 3>& p, const std::array<FT, 3>& q) {
  return barycentric_squared_norm(L_ij, L_jk, L_ki,
                                  std::array<FT, 3>{p[0] - q[0], p[1] - q[1], p[2] - q[2]});
}

/// computes the distance of two points of a triangle, see `barycentric_squared_norm()`.
template <class FT>
FT barycentric_distance(const FT& L_ij, const FT& L_jk, const FT& L_ki, const std::array<FT, 3>& p,
                        const std::array<FT, 3>& q) {
  return CGAL::sqrt(barycentric_squared_distance(L_ij, L_jk, L_ki, p, q));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_BARYCENTRIC_NORM_H
