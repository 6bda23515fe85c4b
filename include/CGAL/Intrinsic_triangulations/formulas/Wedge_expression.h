// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_WEDGE_EXPRESSION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_WEDGE_EXPRESSION_H

#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>

#include <CGAL/Uncertain.h>

#include <cstddef>
#include <span>

/*!
\file
The angle of a wedge, which is a sum of corner angles at a vertex, without trigonometry.

Of a face ijk let z = p + i a with p = L_ij + L_ki - L_jk and a its quadruple area; then z = 2 |ij| |ik| exp(i theta), theta the
angle at i. The product of the z of several faces has the sum of their angles as its argument: its imaginary part has the
sign of the sine of the sum, its real part that of the cosine.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// the product of the z of the corners at the sources of the first sides, each times its scale
template <class FT>
Plane_vector<FT> wedge_product(std::span<const Face_values<FT>> faces,
                               std::span<const double> scales) {
  const auto factor = [&](std::size_t k) {
    const auto& [l, a] = faces[k];
    return FT(scales[k]) * scaled_corner(l[0], l[1], l[2], a);
  };
  Plane_vector<FT> z = factor(0);
  for (std::size_t k = 1; k < faces.size(); ++k) z = z * factor(k);
  return z;
}

} // namespace internal

/*!
\brief evaluates to a value with the sign of the sine of the sum of angles of faces, each at the source of its first side.
*/
struct Wedge_sine_expression {
  /// Powers of two, one per face: factors that keep the product from overflow.
  std::span<const double> scales;
  /// evaluates the expression
  template <class FT>
  FT operator()(std::span<const Face_values<FT>> faces) const {
    return internal::wedge_product(faces, scales).y;
  }
};

/*!
\brief evaluates to a value with the sign of the cosine of the sum of angles of faces, each at the source of its first side.
*/
struct Wedge_cosine_expression {
  /// Powers of two, one per face: factors that keep the product from overflow.
  std::span<const double> scales;
  /// evaluates the expression
  template <class FT>
  FT operator()(std::span<const Face_values<FT>> faces) const {
    return internal::wedge_product(faces, scales).x;
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_WEDGE_EXPRESSION_H
