// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_TRIANGLE_INEQUALITY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_TRIANGLE_INEQUALITY_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>

#include <CGAL/Gmpq.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

/*!
\file
Which faces of a metric given by squared lengths violate the triangle inequality, exactly.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The edges of the sides of a face, in the order of its halfedges.
inline std::array<std::uint32_t, 3> edges_of_face(const Gluing_map& mesh, std::uint32_t f) {
  const auto [h, n, l] = mesh.sides({f});
  return {h.index / 2, n.index / 2, l.index / 2};
}

} // namespace internal

/*!
\brief tells whether the square roots of three numbers satisfy the triangle inequality: no side is
longer than the other two together. Exact.

They do iff (4A)^2 >= 0. `squared_quadruple_area()` in doubles errs by less than 2^-98 of 4yz, with y and z
the two shortest, unless something over- or underflows; what it leaves open is computed in rationals.
\pre all are finite and not negative
\complexity constant
*/
inline bool squares_satisfy_triangle_inequality(double L_ij, double L_jk, double L_ki) {
  const double d = squared_quadruple_area(L_ij, L_jk, L_ki);
  const double scale = 4 * (L_ij + L_jk + L_ki - std::max({L_ij, L_jk, L_ki})) *
                       std::min({L_ij, L_jk, L_ki}); // 4yz at least
  if (std::abs(d) > 0x1p-90 * scale && scale > 0x1p-800 && scale < 0x1p1000 && std::isfinite(d))
    return d > 0;
  return squared_quadruple_area(Gmpq(L_ij), Gmpq(L_jk), Gmpq(L_ki)) >= Gmpq(0);
}

/*!
\brief lists the faces whose sides violate the triangle inequality. Exact; faces of zero area satisfy it.
\param mesh the connectivity, oriented or not
\param squared_lengths one squared length per edge of `mesh`, finite and not negative
\return the numbers of the faces, increasing
\complexity linear
*/
inline std::vector<std::uint32_t>
faces_violating_triangle_inequality(const Gluing_map& mesh,
                                    const std::vector<double>& squared_lengths) {
  std::vector<std::uint32_t> result;
  for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f) {
    const auto [a, b, c] = internal::edges_of_face(mesh, f);
    if (!squares_satisfy_triangle_inequality(squared_lengths[a], squared_lengths[b],
                                             squared_lengths[c]))
      result.push_back(f);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_TRIANGLE_INEQUALITY_H
