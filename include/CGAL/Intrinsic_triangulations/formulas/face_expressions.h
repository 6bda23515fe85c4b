// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_FACE_EXPRESSIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_FACE_EXPRESSIONS_H

#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>

#include <cstddef>
#include <span>

/*!
\file
Bounds on the shape of a face, as signs of polynomials in its squared lengths and quadruple area: what
refinement asks of the arithmetic (§1.2 of the design).
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief evaluates to a value that is positive iff the angle opposite a side is smaller than a bound.

With the side ij and the corner k, cot k = (L_jk + L_ki - L_ij) / a, which falls as the angle grows.
*/
struct Small_angle_expression {
  std::size_t side; ///< the side opposite the corner: 0, 1 or 2
  double cotangent; ///< cotangent of the bound
  /// evaluates the expression
  template <class FT>
  FT operator()(std::span<const Face_values<FT>> faces) const {
    const auto& [l, a] = faces[0];
    return l[(side + 1) % 3] + l[(side + 2) % 3] - l[side] - FT(cotangent) * a;
  }
};

/*!
\brief evaluates to a value that is positive iff the circumradius of a face exceeds a bound.

R = l_ij l_jk l_ki / a.
*/
struct Large_circumradius_expression {
  double squared_radius; ///< square of the bound
  /// evaluates the expression
  template <class FT>
  FT operator()(std::span<const Face_values<FT>> faces) const {
    const auto& [l, a] = faces[0];
    return l[0] * l[1] * l[2] - FT(squared_radius) * a * a;
  }
};

/*!
\brief evaluates to a value that is positive iff a side of a face is longer than a bound.
*/
struct Long_side_expression {
  std::size_t side;      ///< the side: 0, 1 or 2
  double squared_length; ///< square of the bound
  /// evaluates the expression
  template <class FT>
  FT operator()(std::span<const Face_values<FT>> faces) const {
    return faces[0].squared_lengths[side] - FT(squared_length);
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_FACE_EXPRESSIONS_H
