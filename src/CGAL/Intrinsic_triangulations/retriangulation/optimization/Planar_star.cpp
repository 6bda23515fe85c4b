// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/optimization/Planar_star.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

Plane_vector<double> Planar_star::optimum() const {
  double x = 0, y = 0, area = 0;
  for (std::size_t k = 0; k < rim_.size(); ++k) {
    const Plane_vector<double>&a = rim_[k], &b = rim_[(k + 1) % rim_.size()];
    const double aa = dot(a, a), bb = dot(b, b);
    x += aa * b[1] - bb * a[1];
    y += bb * a[0] - aa * b[0];
    area += cross(a, b);
  }
  return {x / (2 * area), y / (2 * area)};
}

double Planar_star::clearance(const Plane_vector<double>& p) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < rim_.size(); ++k) {
    const Plane_vector<double>&a = rim_[k], &b = rim_[(k + 1) % rim_.size()];
    const Plane_vector<double> side = b - a;
    least = std::min(least, cross(side, p - a) / std::hypot(side.x, side.y));
  }
  return least;
}

std::optional<Surface_point> Planar_star::locate(const Plane_vector<double>& p) const {
  for (std::size_t k = 0; k < rim_.size(); ++k) {
    const Plane_vector<double>&a = rim_[k], &b = rim_[(k + 1) % rim_.size()];
    const double area = cross(a, b);
    double u = cross(p, b) / area, v = cross(a, p) / area;
    if (!(u >= -on_spoke && v >= -on_spoke && u + v < 1)) continue;
    if (u < on_spoke) u = 0;
    if (v < on_spoke) v = 0;
    return Surface_point{spokes_[k], {1 - u - v, u, v}};
  }
  return std::nullopt;
}

} // namespace CGAL::Intrinsic_triangulations::internal
