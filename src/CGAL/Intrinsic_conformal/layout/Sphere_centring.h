// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_LAYOUT_SPHERE_CENTRING_H
#define CGAL_INTRINSIC_CONFORMAL_LAYOUT_SPHERE_CENTRING_H

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Points on the unit sphere that Möbius transformations move until their mean is 0.
struct Sphere_centring {
  std::vector<Eigen::Vector3d> points;
  Eigen::VectorXd weights; // not negative, with sum 1

  std::size_t iterations = 0;
  bool is_centred = false;

  Eigen::Vector3d mean() const;
  void run();

private:
  // The change of sum w log -<y, (p, 1)>, where the boost along `direction` by a hyperbolic length
  // moves y to the centre.
  double change(const Eigen::Vector3d& direction, double length) const;
  void boost(const Eigen::Vector3d& direction, double length);
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_CONFORMAL_LAYOUT_SPHERE_CENTRING_H
