// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure.h>

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Gmpq.h>
#include <CGAL/number_utils.h>

#include <array>

namespace CGAL::Intrinsic_triangulations {

namespace {

// twice the area of a triangle; `scale` is set to the sum of all products, without signs
template <class FT>
double cross_product(const std::array<double, 3>& p, const std::array<double, 3>& q,
                     const std::array<double, 3>& r, double& scale) {
  std::array<FT, 3> u{}, v{};
  for (unsigned k = 0; k < 3; ++k) {
    u[k] = FT(q[k]) - FT(p[k]);
    v[k] = FT(r[k]) - FT(p[k]);
  }
  std::array<double, 3> normal{};
  scale = 0;
  for (unsigned k = 0; k < 3; ++k) {
    const FT x = u[(k + 1) % 3] * v[(k + 2) % 3], y = u[(k + 2) % 3] * v[(k + 1) % 3];
    normal[k] = CGAL::to_double(FT(x - y));
    scale += std::abs(CGAL::to_double(x)) + std::abs(CGAL::to_double(y));
  }
  return std::hypot(normal[0], normal[1], normal[2]);
}

} // namespace

double area_in_space(const std::array<double, 3>& p, const std::array<double, 3>& q,
                     const std::array<double, 3>& r) {
  double scale = 0;
  const double twice = cross_product<double>(p, q, r, scale);
  // rounding is below 2^-49 of the products: where they cancel, as on needles, rationals are right
  if (twice > 0x1p-7 * scale) return twice / 2;
  return cross_product<CGAL::Gmpq>(p, q, r, scale) / 2;
}

} // namespace CGAL::Intrinsic_triangulations
