// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_BARYCENTRIC_SOLVE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_BARYCENTRIC_SOLVE_H

#include <CGAL/Intrinsic_triangulations/formulas/compensated_arithmetic.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

/*!
\file
What `local_coordinates.h` computes with: planar cross products and the 3 x 3 system of §2.3.7.
*/

namespace CGAL::Intrinsic_triangulations::internal {

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

// Three equations in three unknowns, the last column being the right-hand side.
template <class FT>
using Augmented_matrix = std::array<std::array<FT, 4>, 3>;

// Brings the largest remaining entry to row and column `step`.
template <class FT>
void pivot(Augmented_matrix<FT>& m, std::array<std::size_t, 3>& unknowns, std::size_t step) {
  std::size_t row = step, column = step;
  for (std::size_t r = step; r < 3; ++r)
    for (std::size_t c = step; c < 3; ++c)
      if (is_less(FT(CGAL::abs(m[row][column])), FT(CGAL::abs(m[r][c])))) row = r, column = c;
  std::swap(m[step], m[row]);
  for (std::array<FT, 4>& equation : m) std::swap(equation[step], equation[column]);
  std::swap(unknowns[step], unknowns[column]);
}

// Solves by Gaussian elimination with complete pivoting. The matrix must be regular.
template <class FT>
std::array<FT, 3> solve(Augmented_matrix<FT> m) {
  std::array<std::size_t, 3> unknowns{0, 1, 2};
  for (std::size_t s = 0; s < 3; ++s) {
    pivot(m, unknowns, s);
    CGAL_precondition(m[s][s] != FT(0));
    for (std::size_t r = s + 1; r < 3; ++r) {
      const FT factor = m[r][s] / m[s][s];
      for (std::size_t c = s + 1; c < 4; ++c) m[r][c] = m[r][c] - factor * m[s][c];
    }
  }
  std::array<FT, 3> x{FT(0), FT(0), FT(0)};
  for (std::size_t s = 3; s-- > 0;) {
    FT value = m[s][3];
    for (std::size_t c = s + 1; c < 3; ++c) value = value - m[s][c] * x[unknowns[c]];
    x[unknowns[s]] = value / m[s][s];
  }
  return x;
}

// Solves for the coordinates that give (p_x, p_y) and sum to p_1.
template <class FT>
std::array<FT, 3> solve_barycentric(const std::array<std::array<FT, 2>, 3>& f,
                                    const std::array<FT, 3>& p) {
  return solve(Augmented_matrix<FT>{{{f[0][0], f[1][0], f[2][0], p[0]},
                                     {f[0][1], f[1][1], f[2][1], p[1]},
                                     {FT(1), FT(1), FT(1), p[2]}}});
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_BARYCENTRIC_SOLVE_H
