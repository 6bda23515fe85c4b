// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_WHOLE_STAR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_WHOLE_STAR_H

#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>

#include <cstddef>
#include <cstdint>
#include <vector>

/*!
\file
A flat vertex that moves among the faces about it (Eq. 8 of the course), in any field.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief indexes the edges and faces about a vertex in the interior, counterclockwise.
*/
struct Whole_star {
  std::vector<std::uint32_t> spokes; ///< the edges from the vertex
  std::vector<std::uint32_t> rim;    ///< the edge opposite the vertex in each face
  std::vector<std::uint32_t> faces;  ///< the face after each spoke
};

/*!
\brief holds values of a star, in its order.
\tparam FT a model of `Field`
*/
template <class FT>
struct Whole_star_values {
  std::vector<FT> spokes; ///< squared lengths of the edges from the vertex
  std::vector<FT> rim;    ///< squared lengths of the edges opposite it
  std::vector<FT> areas;  ///< quadruple areas of the faces
};

/*!
\brief computes what a star becomes when its vertex moves by b s_0 + c s_1, with s_k the vectors along its spokes.

With the first spoke as unit all points are in the field: S_k = conj(s_0) s_k as complex numbers, where conj(s_k) s_k+1 =
(L_k + L_k+1 - R_k + i a_k) / 2. New squared lengths are sums of squares, which lose nothing to cancellation.
\param v the values
\param b the part of the first spoke
\param c the part of the second one
\pre the vertex is flat, the spokes have lengths
\return the new values of spokes and areas; areas are negative where the rim is not seen from there
*/
template <class FT>
Whole_star_values<FT> moved_in_star(const Whole_star_values<FT>& v, const FT& b, const FT& c) {
  const std::size_t n = v.spokes.size();
  std::vector<Plane_vector<FT>> s{{v.spokes[0], FT(0)}};
  for (std::size_t k = 0; k + 1 < n; ++k)
    s.push_back(s[k] * scaled_corner(v.spokes[k], v.rim[k], v.spokes[k + 1], v.areas[k]) /
                FT(v.spokes[k] + v.spokes[k]));
  const Plane_vector<FT> to{b * s[0].x + c * s[1].x, c * s[1].y};
  for (Plane_vector<FT>& p : s) p = p - to;
  Whole_star_values<FT> result{{}, v.rim, {}};
  for (std::size_t k = 0; k < n; ++k) {
    result.spokes.push_back(dot(s[k], s[k]) / v.spokes[0]);
    const FT half = cross(s[k], s[(k + 1) % n]) / v.spokes[0];
    result.areas.push_back(half + half);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_WHOLE_STAR_H
