// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_TENSOR_NORM_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_TENSOR_NORM_H

#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <array>
#include <limits>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief measures vectors of the plane by a symmetric positive definite tensor: |v|_g^2 = v^T M v.

Keeps a linear map A with M = A^T A, so that |v|_g = |A v|: then a large ratio of stretches in
`from_stretches()` causes no cancellation.
*/
class Tensor_norm {
public:
  /// constructs the Euclidean norm.
  Tensor_norm() = default;

  /*!
  \brief takes the entries of M.

  If M is not positive definite, the norm of every vector is NaN, which `scale_by_norm()` reports
  with the face.
  */
  static Tensor_norm from_tensor(double xx, double xy, double yy) {
    Tensor_norm n; // by Cholesky
    const double a = std::sqrt(xx), b = xy / a, c = std::sqrt(yy - b * b);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    n.map_ = {a, b, 0, c > 0 && std::isfinite(a) ? c : nan};
    if (!(n.map_[3] > 0)) n.map_ = {nan, nan, nan, nan};
    return n;
  }

  /*!
  \brief multiplies lengths along a direction by one factor and lengths across it by another.
  \param direction the direction, not zero, of any length
  \param along factor along the direction, positive
  \param across factor across it, positive
  */
  static Tensor_norm from_stretches(const Unscaled_vector& direction, double along, double across) {
    const double l = std::hypot(direction[0], direction[1]);
    const double x = direction[0] / l, y = direction[1] / l;
    Tensor_norm n;
    n.map_ = {along * x, along * y, -across * y, across * x};
    return n;
  }

  /// measures a vector.
  double operator()(const Unscaled_vector& v) const {
    return std::hypot(map_[0] * v[0] + map_[1] * v[1], map_[2] * v[0] + map_[3] * v[1]);
  }

private:
  std::array<double, 4> map_ = {1, 0, 0, 1}; // A by rows
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_TENSOR_NORM_H
