// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_DIAMOND_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_DIAMOND_H

#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>

#include <boost/config.hpp>

#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

/*!
\file
The two faces at an edge, and the formulas of a flip.

The diamond of halfedge `ij` has face `f = ijk` on its left and `g = jim` on its right. Everything
is a field expression in squared lengths `L` and quadruple areas `a = 4A`: no square root, no
trigonometry. With

    p_k = L_ij + L_ki - L_jk = 2<ij, ik>,      p_m = L_ij + L_im - L_mj = 2<ij, im>,
    q_f = L_jk + L_ki - L_ij,                  q_g = L_im + L_mj - L_ij,

the cotangent of the angle at k is q_f / a_f, so that the angles opposite `ij` sum to at most pi iff
q_f a_g + q_g a_f >= 0. These follow from the law of cosines and 2<Ju, v> = a.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief indexes the edges and faces of the diamond of halfedge ij.
*/
struct Diamond {
  std::uint32_t ij; ///< the edge
  std::uint32_t jk; ///< next side of the left face
  std::uint32_t ki; ///< last side of the left face
  std::uint32_t im; ///< next side of the right face
  std::uint32_t mj; ///< last side of the right face
  std::uint32_t f;  ///< the left face, ijk
  std::uint32_t g;  ///< the right face, jim
};

/*!
\brief holds the squared lengths and quadruple areas of a diamond.
\tparam FT a model of `RingNumber`
*/
template <RingNumber FT>
struct Diamond_values {
  FT ij;     ///< squared length of the edge
  FT jk;     ///< squared length of jk
  FT ki;     ///< squared length of ki
  FT im;     ///< squared length of im
  FT mj;     ///< squared length of mj
  FT area_f; ///< quadruple area of the left face
  FT area_g; ///< quadruple area of the right face
};

/*!
\brief holds the new values of a flip.

The flipped edge runs from `k` to `m`, with `mj` and `jk` on the left and `ki` and `im` on the
right, which is how `CGAL::Euler::flip_edge()` turns a halfedge.
\tparam FT a model of `RingNumber`
*/
template <RingNumber FT>
struct Flipped_values {
  FT km;     ///< squared length of the new edge
  FT area_f; ///< quadruple area of the left face, kmj
  FT area_g; ///< quadruple area of the right face, mki
};

/*!
\brief returns q_f = L_jk + L_ki - L_ij, the cotangent at `k` times the quadruple area.
*/
template <RingNumber FT>
constexpr FT left_cotangent_numerator(const Diamond_values<FT>& d) {
  return d.jk + d.ki - d.ij;
}

/*!
\brief returns q_g = L_im + L_mj - L_ij, the cotangent at `m` times the quadruple area.
*/
template <RingNumber FT>
constexpr FT right_cotangent_numerator(const Diamond_values<FT>& d) {
  return d.im + d.mj - d.ij;
}

/// returns the numerators of both cotangents opposite an edge, from stored squared lengths.
template <RingNumber FT>
BOOST_FORCEINLINE std::pair<FT, FT> cotangent_numerators(const std::vector<FT>& lengths,
                                                         const Diamond& d) {
  const FT& ij = lengths[d.ij];
  return {lengths[d.jk] + lengths[d.ki] - ij, lengths[d.im] + lengths[d.mj] - ij};
}

/*!
\brief evaluates to a value that is positive iff the angles opposite the edge sum to less than pi,
zero iff to pi (the four vertices are cocircular), negative iff to more.

The value is a_f a_g (cot k + cot m).
*/
struct Delaunay_expression {
  /// evaluates the expression
  template <class FT>
  constexpr FT operator()(const Diamond_values<FT>& d) const {
    return left_cotangent_numerator(d) * d.area_g + right_cotangent_numerator(d) * d.area_f;
  }
};

/*!
\brief returns (cot k + cot m) / 2, the weight of the edge. \pre the areas are not zero
*/
template <FieldNumber FT>
FT cotangent_weight(const Diamond_values<FT>& d) {
  const FT product = d.area_f * d.area_g;
  return Delaunay_expression()(d) / (product + product);
}

/*!
\brief evaluates to a value that is positive iff the diamond is strictly convex at `i`.

The value is 2 L_ij times the quadruple area of the face `mki` that a flip would make.
*/
struct Convexity_at_source_expression {
  /// evaluates the expression. \param d the diamond \param times a functor that multiplies a number
  /// by an area
  template <class FT, std::invocable<const FT&, const FT&> Times = std::multiplies<>>
  constexpr FT operator()(const Diamond_values<FT>& d, const Times& times = {}) const {
    return times(FT(d.ij + d.im - d.mj), d.area_f) + times(FT(d.ij + d.ki - d.jk), d.area_g);
  }
};

/*!
\brief evaluates to a value that is positive iff the diamond is strictly convex at `j`.

The value is 2 L_ij times the quadruple area of the face `kmj` that a flip would make.
*/
struct Convexity_at_target_expression {
  /// evaluates the expression. \param d the diamond \param times a functor that multiplies a number
  /// by an area
  template <class FT, std::invocable<const FT&, const FT&> Times = std::multiplies<>>
  constexpr FT operator()(const Diamond_values<FT>& d, const Times& times = {}) const {
    return times(FT(d.ij + d.mj - d.im), d.area_f) + times(FT(d.ij + d.jk - d.ki), d.area_g);
  }
};

/*!
\brief evaluates to the quadruple area of the face on the left of an edge.
*/
struct Left_area_expression {
  /// evaluates the expression
  template <class FT>
  constexpr FT operator()(const Diamond_values<FT>& d) const {
    return d.area_f;
  }
};

/*!
\brief evaluates to a value with the sign of the cosine of the angle at `i` in the face on the right
of an edge.
*/
struct Right_cosine_expression {
  /// evaluates the expression
  template <class FT>
  constexpr FT operator()(const Diamond_values<FT>& d) const {
    return d.ij + d.im - d.mj;
  }
};

/*!
\brief computes the new squared length and quadruple areas of a flip.

L_km = ((p_k - p_m)^2 + (a_f + a_g)^2) / (4 L_ij): with ij on an axis, the feet of k and m are (p_k
- p_m) / (2 l_ij) apart, their heights (a_f + a_g) / (2 l_ij). A sum of squares loses nothing to
cancellation on slivers, unlike L_ki + L_im - (p_k p_m - a_f a_g) / (2 L_ij). The areas are as in
`Convexity_at_source_expression` and `Convexity_at_target_expression`.
\pre the diamond is strictly convex, `d.ij` is not zero
*/
template <FieldNumber FT>
Flipped_values<FT> flipped(const Diamond_values<FT>& d) {
  const FT x = (d.ki - d.jk) + (d.mj - d.im); // p_k - p_m, rounded alike from either side
  const FT y = d.area_f + d.area_g;
  const FT twice = d.ij + d.ij;
  const FT quarter = FT(1) / (twice + twice);
  const FT half = quarter + quarter;
  return {(x * x + y * y) * quarter, Convexity_at_target_expression()(d) * half,
          Convexity_at_source_expression()(d) * half};
}

namespace internal {

/*
p + i a, see `scaled_corner()`, from values that are rounded.

The values are redundant: c = a^2 - H is zero, where H = 4 L_ij L_ki - p^2. Rounding leaves a small
c, and flips that are computed with it make it grow exponentially. So c is removed. Among all
changes of the values that do so to first order, these have the least sum of squared relative
changes:

    da = -g a^3,   dL_e = g q_e L_e^2,   q_e = dH / (2 dL_e),
    g = c / (2 (a^4 + sum of q_e^2 L_e^2)).

The shape of the triangle decides whether its lengths or its area give way. The change of L_ij is
left out, as the triangle on the other side has another one.
*/
template <std::floating_point FT>
Plane_vector<FT> consistent_corner(const FT& ij, const FT& jk, const FT& ki, const FT& area) {
  const FT x = ki - jk, p = ij + x, square = area * area;
  const FT c = square - (4 * ij * ki - p * p);
  const FT u_ki = (ij - x) * ki, u_jk = p * jk, u_ij = (ki + jk - ij) * ij;
  const FT norm = square * square + u_ki * u_ki + u_jk * u_jk + u_ij * u_ij;
  if (!(norm > std::numeric_limits<FT>::min())) return {p, area};
  const FT g = c / (2 * norm);
  return {p + (g * ki * u_ki - g * jk * u_jk), area - g * square * area};
}

} // namespace internal

/*!
\brief computes `flipped()` from rounded values so that errors do not grow from flip to flip.
\pre see `flipped()`
*/
template <std::floating_point FT>
Flipped_values<FT> flipped_consistently(const Diamond_values<FT>& d) {
  const Plane_vector<FT> k = internal::consistent_corner(d.ij, d.jk, d.ki, d.area_f);
  const Plane_vector<FT> m = internal::consistent_corner(d.ij, d.mj, d.im, d.area_g);
  const FT x = k.x - m.x, y = k.y + m.y, twice = 2 * d.ij, half = 1 / twice;
  return {(x * x + y * y) / (2 * twice), ((twice - m.x) * k.y + (twice - k.x) * m.y) * half,
          (m.x * k.y + k.x * m.y) * half};
}

/*!
\brief bounds the error of the areas of `flipped()` for values with relative errors below `e`: the
exact area may have any sign if the computed one is not larger.

Either area is a sum of two products (p a) / (2 L_ij), where p adds three lengths and a is the area
of a face. When p is small, the error of the lengths remains: `e` times their sum.
\tparam FT a floating point type
*/
template <std::floating_point FT>
FT flipped_area_error(const Diamond_values<FT>& d, const FT& e) {
  return e * ((d.ij + d.jk + d.ki) * d.area_g + (d.ij + d.im + d.mj) * d.area_f) / (2 * d.ij);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_DIAMOND_H
