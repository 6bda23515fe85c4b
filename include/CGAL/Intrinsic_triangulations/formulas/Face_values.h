// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_FACE_VALUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_FACE_VALUES_H

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>

#include <CGAL/Uncertain.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

/*!
\file
The values of a face, and bounds on its shape as signs of polynomials in these, for refinement.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief names a side of a face of the input.
*/
struct Face_side {
  std::uint32_t face; ///< the face
  std::uint32_t slot; ///< 0, 1 or 2
  /// tells whether they are the same side of the same face.
  friend bool operator==(const Face_side&, const Face_side&) = default;
};

/*!
\brief names a face and its sides in counterclockwise order, from any of them.
*/
struct Indexed_face {
  std::uint32_t face;                 ///< the face
  std::array<std::uint32_t, 3> edges; ///< its edges
};

/*!
\brief holds the squared lengths and the quadruple area of a face.
\tparam FT a model of `RingNumber`
*/
template <RingNumber FT>
struct Face_values {
  std::array<FT, 3> squared_lengths; ///< of the sides in order
  FT quadruple_area;                 ///< four times the area
};

namespace internal {

// the doubles that a metric has of a face
template <class Metric>
Face_values<double> approximate_values(const Metric& metric, const Indexed_face& face) {
  return {{metric.approximate_squared_length(face.edges[0]),
           metric.approximate_squared_length(face.edges[1]),
           metric.approximate_squared_length(face.edges[2])},
          metric.approximate_quadruple_area(face.face)};
}

} // namespace internal

/*!
\brief joins two faces along the first side of each.
*/
template <RingNumber FT>
Diamond_values<FT> diamond_values(const Face_values<FT>& left, const Face_values<FT>& right) {
  return {left.squared_lengths[0],  left.squared_lengths[1],  left.squared_lengths[2],
          right.squared_lengths[1], right.squared_lengths[2], left.quadruple_area,
          right.quadruple_area};
}

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

/*
The angle of a wedge, which is a sum of corner angles at a vertex, needs no trigonometry. At corner
i of a face ijk let z = p + i a, p = L_ij + L_ki - L_jk and a the quadruple area; then z = 2 |ij|
|ik| exp(i theta), theta the angle there. The product of the z of several faces has the sum of their
angles as its argument: its imaginary part has the sign of the sine of the sum, its real part that
of the cosine.
*/
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
\brief evaluates to a value with the sign of the sine of the sum of angles of faces, each at the
source of its first side.
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
\brief evaluates to a value with the sign of the cosine of the sum of angles of faces, each at the
source of its first side.
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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_FACE_VALUES_H
