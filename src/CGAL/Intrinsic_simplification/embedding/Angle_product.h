// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_ANGLE_PRODUCT_H
#define CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_ANGLE_PRODUCT_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <numbers>

namespace CGAL::Intrinsic_triangulations::internal {

// The argument of a product of complex numbers, which a double is known to be near to. Near 0, it
// is precise to the last bits of numbers with 106 bits.
class Angle_product {
public:
  void multiply(const Double_double& u, const Double_double& v) {
    const Double_double re = x_ * u - y_ * v;
    y_ = x_ * v + y_ * u;
    x_ = re;
    const double size = std::max(std::abs(x_.to_double()), std::abs(y_.to_double()));
    const double power = std::ldexp(1., size > 0 ? -std::ilogb(size) : 0);
    x_ = x_.scaled(power);
    y_ = y_.scaled(power);
  }
  double near(double guess) const {
    constexpr double turn = 2 * std::numbers::pi;
    const double angle = std::atan2(y_.to_double(), x_.to_double());
    return angle + turn * std::round((guess - angle) / turn);
  }

private:
  Double_double x_ = Double_double(1), y_ = Double_double(0);
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_ANGLE_PRODUCT_H
