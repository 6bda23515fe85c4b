// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_PENNER_COORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_PENNER_COORDINATES_H

#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>

#include <concepts>
#include <functional>

/*!
\file
Formulas of ideal hyperbolic triangulations, in Penner's lambda lengths.

The corners of an ideal triangle are at infinity, each with a horocycle about it. The lambda length
of a side is exp(d / 2), where d is the signed distance of the horocycles at its ends (Penner 1987).
Moving the horocycle of a corner multiplies the lambda lengths of all sides there by one factor. All
formulas are rational: as in Ptolemy's theorem, whose quadrilaterals are inscribed in a circle.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds the lambda lengths of a diamond, see `Diamond`.
\tparam FT a model of `RingNumber`
*/
template <RingNumber FT>
struct Ideal_diamond_values {
  FT ij; ///< the edge
  FT jk; ///< next side of the left face
  FT ki; ///< last side of the left face
  FT im; ///< next side of the right face
  FT mj; ///< last side of the right face
};

/*!
\brief returns the lambda length of the edge km that a flip makes: products of opposite sides, by
Ptolemy's relation ij km = jk im + ki mj.
\param d the diamond
\param times a functor that multiplies two positive numbers
*/
template <FieldNumber FT, std::invocable<const FT&, const FT&> Times = std::multiplies<>>
FT ptolemy_flip(const Ideal_diamond_values<FT>& d, const Times& times = {}) {
  return (times(d.jk, d.im) + times(d.ki, d.mj)) / d.ij;
}

/*!
\brief returns the lambda length from a vertex i to the apex r of a triangle pqr, beyond side pq as
seen from i: Ptolemy's relation in the ideal quadrilateral i, p, r, q. All terms are positive.
\param ip, iq from i to the ends of the side
\param pq, qr, rp the sides of the triangle
*/
template <FieldNumber FT>
FT lambda_at_apex(const FT& ip, const FT& iq, const FT& pq, const FT& qr, const FT& rp) {
  return (ip * qr + iq * rp) / pq;
}

/*!
\brief evaluates to a value that is positive iff the edge is ideal Delaunay, zero iff the four
corners are on a circle that touches all horocycles alike, negative iff neither.

With the other sides a, b and c, d of the two faces, the edge e is ideal Delaunay iff

    (a^2 + b^2 - e^2) / (a b) + (c^2 + d^2 - e^2) / (c d) >= 0,

which are twice the cosines of the opposite angles in Euclid's triangles with the same lengths
(Springborn 2020). The value is the sum times a b c d, as a difference of two positive terms:
(ac + bd)(ad + bc) - e^2 (ab + cd).
*/
struct Ideal_delaunay_expression {
  /// evaluates the positive term. \param d the diamond \param times see `ptolemy_flip()`
  template <class FT, std::invocable<const FT&, const FT&> Times = std::multiplies<>>
  static constexpr FT outer(const Ideal_diamond_values<FT>& d, const Times& times = {}) {
    return times(FT(times(d.jk, d.im) + times(d.ki, d.mj)),
                 FT(times(d.jk, d.mj) + times(d.ki, d.im)));
  }
  /// evaluates the term that is subtracted; see above.
  template <class FT, std::invocable<const FT&, const FT&> Times = std::multiplies<>>
  static constexpr FT inner(const Ideal_diamond_values<FT>& d, const Times& times = {}) {
    return times(FT(times(d.ij, d.ij)), FT(times(d.jk, d.ki) + times(d.im, d.mj)));
  }
  /// evaluates the expression.
  template <class FT>
  constexpr FT operator()(const Ideal_diamond_values<FT>& d) const {
    return outer(d) - inner(d);
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_PENNER_COORDINATES_H
