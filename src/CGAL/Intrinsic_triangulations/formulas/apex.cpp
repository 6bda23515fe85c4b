// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>

namespace CGAL::Intrinsic_triangulations {

Plane_sides planar_sides(double ij, double jk, double ki, double area) {
  const double l = std::sqrt(ij), two_l = 2 * l, height = area / two_l;
  return {{{l, 0},
           {-twice_inner_product(jk, ki, ij) / two_l, height},
           {-twice_inner_product(ij, jk, ki) / two_l, -height}}};
}

std::array<double, 3> weights_in_triangle(const Plane_vector<double>& p,
                                          const Plane_vector<double>& a,
                                          const Plane_vector<double>& b,
                                          const Plane_vector<double>& c) {
  const Plane_vector<double> side = b - a;
  const auto seen = [&](const Plane_vector<double>& q) { // with a at 0 and b at 1
    return in_frame(side, q - a) / dot(side, side);
  };
  const Plane_vector<double> at = seen(p), apex = seen(c);
  double least = 0, most = 1; // of c
  // Weights of b and a are not negative: k apex.x <= at.x and k (1 - apex.x) <= 1 - at.x. Where k
  // gives way the point moves up or down by apex.y, else along the side by the slope: the less the
  // better.
  const auto restrict_to = [&](double slope, double bound) {
    if (slope > apex.y) most = std::min(most, bound / slope);
    if (slope < -apex.y) least = std::max(least, bound / slope);
  };
  restrict_to(apex.x, at.x);
  restrict_to(1 - apex.x, 1 - at.x);
  most = std::max(most, 0.0);
  least = std::min(least, most);
  const double k = apex.y > 0 ? std::clamp(at.y / apex.y, least, most) : least;
  const double j = std::clamp(at.x - k * apex.x, 0.0, 1 - k);
  return {1 - k - j, j, k};
}

} // namespace CGAL::Intrinsic_triangulations
