// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/layout/Sphere_centring.h>

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

Eigen::Vector3d Sphere_centring::mean() const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i)
    sum += weights[static_cast<Eigen::Index>(i)] * points[i];
  return sum;
}

double Sphere_centring::change(const Eigen::Vector3d& direction, double length) const {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    // cosh - sinh x = e^-length (1 + x) / 2 + e^length (1 - x) / 2, as squares of lengths
    const double ahead = (points[i] + direction).squaredNorm() / 4,
                 behind = (points[i] - direction).squaredNorm() / 4;
    sum += weights[static_cast<Eigen::Index>(i)] *
           std::log(std::exp(-length) * ahead + std::exp(length) * behind);
  }
  return sum;
}

// The motion takes (p, 1) to a light-like vector, which is scaled to (q, 1).
void Sphere_centring::boost(const Eigen::Vector3d& direction, double length) {
  const double s = std::sinh(length), c = std::cosh(length);
  for (Eigen::Vector3d& p : points) {
    const double x = direction.dot(p);
    const Eigen::Vector3d q = p + (c * x - s - x) * direction;
    p = q.normalized(); // q / (c - s x), but for rounding
  }
}

void Sphere_centring::run() {
  for (iterations = 0; iterations < 100; ++iterations) { // 20 are enough on the data set
    const Eigen::Vector3d m = mean();
    is_centred = m.norm() <= 1e-14; // 90 roundings of coordinates up to 1
    if (is_centred) return;
    Eigen::Matrix3d hessian = Eigen::Matrix3d::Identity();
    for (std::size_t i = 0; i < points.size(); ++i)
      hessian -= weights[static_cast<Eigen::Index>(i)] * points[i] * points[i].transpose();
    Eigen::Vector3d step = hessian.ldlt().solve(m);
    if (!step.allFinite() || !(step.dot(m) > 0)) step = m;
    const Eigen::Vector3d direction = step.normalized();
    double length = step.norm();
    const double slope = direction.dot(m); // by which the function falls
    // Armijo's condition, with a tenth of the slope; on the data set 10 halvings are enough
    int halvings = 0;
    while (halvings < 40 && !(change(direction, length) <= -0.1 * length * slope)) {
      length /= 2;
      ++halvings;
    }
    // Near the minimum, changes, about the square of the mean, are below rounding; a full step of
    // Newton is then right.
    if (halvings == 40) {
      if (m.norm() > 1e-6) return;
      length = step.norm();
    }
    const std::vector<Eigen::Vector3d> before = points;
    boost(direction, length);
    if (halvings == 40 && !(mean().norm() < m.norm())) {
      points = before;
      is_centred = true;
      return;
    }
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal
