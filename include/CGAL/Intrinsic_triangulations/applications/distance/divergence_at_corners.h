// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_DISTANCE_DIVERGENCE_AT_CORNERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_DISTANCE_DIVERGENCE_AT_CORNERS_H

#include <array>
#include <complex>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// What a field of one vector in a face adds to the divergence at its corners: the integral of <v, grad hat function>.
// \param v in the frame of side 0
inline std::array<double, 3>
divergence_at_corners(const std::array<std::complex<double>, 3>& corners, std::complex<double> v) {
  std::array<double, 3> result;
  for (std::size_t k = 0; k < 3;
       ++k) { // area times gradient: the opposite side, a quarter turn to the left, by 2
    const std::complex<double> side = corners[(k + 2) % 3] - corners[(k + 1) % 3];
    result[k] = (side.real() * v.imag() - side.imag() * v.real()) / 2;
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_DISTANCE_DIVERGENCE_AT_CORNERS_H
