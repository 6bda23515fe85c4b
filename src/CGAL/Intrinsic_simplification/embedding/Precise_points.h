// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_PRECISE_POINTS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_PRECISE_POINTS_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A point in space with 106 bits. Where faces are hardly bent, heights are square roots of
// curvatures, and distances hardly depend on them: doubles would not fix them.
using Precise_point = std::array<Double_double, 3>;
using Precise_points = std::vector<Precise_point>;
using Space_points = std::vector<Eigen::Vector3d>;

inline Precise_point vector_between(const Precise_point& p, const Precise_point& q) {
  return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
}

inline Double_double scalar_product(const Precise_point& a, const Precise_point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Precise_point cross_product(const Precise_point& a, const Precise_point& b) {
  Precise_point c;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    c[k] = a[i] * b[j] - a[j] * b[i];
  }
  return c;
}

// \tparam Real a floating-point type, with 53 bits or more
template <class Real>
Real rounded_to(const Double_double& x) {
  const double high = x.to_double();
  return Real(high) + Real((x - Double_double(high)).to_double());
}

inline Eigen::Vector3d rounded(const Precise_point& p) {
  return {p[0].to_double(), p[1].to_double(), p[2].to_double()};
}

inline Space_points rounded(const Precise_points& points) {
  Space_points result;
  for (const Precise_point& p : points) result.push_back(rounded(p));
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_PRECISE_POINTS_H
