// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_TRIANGLE_INEQUALITY_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_TRIANGLE_INEQUALITY_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/triangle_inequality.h>

#include <CGAL/Gmpq.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE bool
squares_satisfy_triangle_inequality(double L_ij, double L_jk, double L_ki) {
  const double d = squared_quadruple_area(L_ij, L_jk, L_ki);
  const double scale = 4 * (L_ij + L_jk + L_ki - std::max({L_ij, L_jk, L_ki})) *
                       std::min({L_ij, L_jk, L_ki}); // 4yz at least
  if (std::abs(d) > 0x1p-90 * scale && scale > 0x1p-800 && scale < 0x1p1000 && std::isfinite(d))
    return d > 0;
  return squared_quadruple_area(Gmpq(L_ij), Gmpq(L_jk), Gmpq(L_ki)) >= Gmpq(0);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_TRIANGLE_INEQUALITY_IMPL_H
