// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_ANGLES_TRIANGLE_ANGLES_H
#define CGAL_INTRINSIC_CONFORMAL_ANGLES_TRIANGLE_ANGLES_H

#include <CGAL/number_type_basic.h>

#include <array>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// Angles of a triangle opposite its sides, and their derivatives by the scale u at its corners:
// with weights w and excesses x of sides, the sum of w (du_i - du_j)^2 + x (du_i^2 + du_j^2) over
// the sides ij is minus the sum of du_i d(angle_i).
struct Triangle_angles {
  std::array<double, 3> angle, weight, excess;
};

// Of a Euclidean triangle: the weights are halves of the cotangents, and there is no excess.
// \param surplus see `surpluses()`
Triangle_angles euclidean_angles(const std::array<double, 3>& sides,
                                 const std::array<double, 3>& surplus);

// Of the hyperbolic triangle whose sides have lengths l with lambda = 2 sinh(l/2), see
// `hyperbolic_metric()`.
// \param surplus see `surpluses()`
Triangle_angles hyperbolic_angles(const std::array<double, 3>& lambda,
                                  const std::array<double, 3>& surplus);

// The squared tangents of half of the angles opposite the sides of a hyperbolic triangle, from
// s = sinh(l/2) of its sides: with half of the perimeter p
//
//     tan^2(angle_k / 2) = sinh(p - l_i) sinh(p - l_j) / (sinh(p) sinh(p - l_k)).
//
// The addition theorem gives the factors without subtractions but in x_k = s_i + s_j - s_k, which
// are positive in an ideal Delaunay triangulation. For small triangles they become those of
// Euclid's formula.
// \param x `surpluses()`
// \param positive makes a number positive that is so but for rounding
template <class Number, class Positive>
std::array<Number, 3> squared_half_tangents(const std::array<Number, 3>& s,
                                            std::array<Number, 3> x, const Positive& positive) {
  const Number one(1);
  std::array<Number, 3> cosh, cosh_minus_1, result;
  for (std::size_t k = 0; k < 3; ++k) {
    x[k] = positive(x[k]);
    cosh[k] = CGAL::sqrt(one + s[k] * s[k]);
    cosh_minus_1[k] = s[k] * s[k] / (one + cosh[k]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const Number more = s[i] * cosh_minus_1[j] + s[j] * cosh_minus_1[i],
                 sum = s[i] * cosh[j] + s[j] * cosh[i], // sinh((l_i + l_j) / 2)
        part = (s[i] - s[j]) * (more / sum);
    result[k] = positive(x[i] + part) * positive(x[j] - part) / ((x[k] + more) * (sum + s[k]));
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_CONFORMAL_ANGLES_TRIANGLE_ANGLES_H
