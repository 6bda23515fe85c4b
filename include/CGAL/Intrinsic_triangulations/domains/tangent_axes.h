// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_TANGENT_AXES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_TANGENT_AXES_H

#include <array>
#include <cmath>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

using Symmetric_matrix_3 = std::array<std::array<double, 3>, 3>;

// Turns axes p and q so that the entry (p, q) becomes zero.
inline void rotate(Symmetric_matrix_3& m, Symmetric_matrix_3& axes, unsigned p, unsigned q) {
  const double half = (m[q][q] - m[p][p]) / 2, entry = m[p][q];
  if (entry == 0 || std::abs(entry) <= 1e-20 * (m[p][p] + m[q][q])) return; // far below rounding
  const double tangent = entry / (half + std::copysign(std::hypot(half, entry), half));
  const double c = 1 / std::sqrt(1 + tangent * tangent), s = c * tangent;
  const auto turn = [c, s](double& x, double& y) {
    const double old = x;
    x = c * old - s * y;
    y = s * old + c * y;
  };
  for (unsigned k = 0; k < 3; ++k) turn(m[k][p], m[k][q]);
  for (unsigned k = 0; k < 3; ++k) turn(m[p][k], m[q][k]);
  for (unsigned k = 0; k < 3; ++k) turn(axes[p][k], axes[q][k]);
}

// Two orthonormal vectors in the plane that fits points of this covariance best: eigenvectors of the largest eigenvalues, by
// Jacobi's method, which squares the error with every round.
inline std::array<std::array<double, 3>, 2> tangent_axes(Symmetric_matrix_3 covariance) {
  Symmetric_matrix_3 axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int round = 0; round < 8; ++round)
    for (const auto& [p, q] : {std::pair(0U, 1U), {0U, 2U}, {1U, 2U}})
      rotate(covariance, axes, p, q);
  unsigned normal = 0;
  for (unsigned k = 1; k < 3; ++k)
    if (covariance[k][k] < covariance[normal][normal]) normal = k;
  return {axes[(normal + 1) % 3], axes[(normal + 2) % 3]};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_TANGENT_AXES_H
