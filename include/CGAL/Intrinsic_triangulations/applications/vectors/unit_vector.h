// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_UNIT_VECTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_UNIT_VECTOR_H

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// Where a vector is not known.
inline constexpr std::complex<double> unknown_vector{std::numeric_limits<double>::quiet_NaN(),
                                                     std::numeric_limits<double>::quiet_NaN()};

inline bool is_known(const std::complex<double>& z) {
  return std::isfinite(z.real()) && std::isfinite(z.imag());
}

// A vector of length 1, or zero.
inline std::complex<double> unit_vector(const std::complex<double>& z) {
  const double larger = std::max(std::abs(z.real()), std::abs(z.imag()));
  if (!(larger > 0) || !std::isfinite(larger)) return 0;
  const std::complex<double> scaled = z / larger; // whose square does not underflow
  return scaled / std::abs(scaled);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_UNIT_VECTOR_H
