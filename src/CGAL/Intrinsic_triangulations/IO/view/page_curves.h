// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_CURVES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_CURVES_H

#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/view/drawn_geometry.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Curves as a page has them: points one after another. The size of a closed curve is negative.
struct Page_curves {
  std::vector<std::array<float, 3>> points;
  std::vector<std::int32_t> sizes, labels; // of each curve
  double tolerance = 0; // how far points that were left out may be from a point before, in radii

  std::size_t bytes() const { return 12 * points.size() + 8 * sizes.size(); }

  // Adds a curve; leaves out points within the tolerance of the last one that it has, except ends.
  void add(const Polyline& curve, const Unit_ball_scaling& scaling) {
    const std::size_t begin = points.size(), n = curve.points.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::array<float, 3> p = scaling(curve.points[i]);
      const auto is_near = [&](const std::array<float, 3>& q) {
        return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]) <= tolerance;
      };
      if (i == 0 || i + 1 == n || tolerance == 0 || !is_near(points.back())) points.push_back(p);
    }
    const auto size = static_cast<std::int32_t>(points.size() - begin);
    sizes.push_back(curve.is_closed ? -size : size);
    labels.push_back(curve.label);
  }
};

// A share of the curves with lines, evenly chosen, each two neighbours together: shaft and tip of
// an arrow.
inline Page_curves thinned_curves(std::span<const Polyline> curves,
                                  const Unit_ball_scaling& scaling, double tolerance,
                                  double share) {
  Page_curves result;
  result.tolerance = tolerance;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto pair = static_cast<double>(i / 2);
    const bool is_shown = share >= 1 || std::floor((pair + 1) * share) > std::floor(pair * share);
    if (is_shown && curves[i].number_of_segments() > 0) result.add(curves[i], scaling);
  }
  return result;
}

// The curves; if they need too many bytes, first with fewer points, then fewer of them; few curves
// keep their number.
inline Page_curves curves_within(std::span<const Polyline> curves, const Unit_ball_scaling& scaling,
                                 std::size_t most_bytes) {
  // a quarter of a pixel and two, where the ball of this diameter fills 1000
  constexpr double least_tolerance = 5e-4, visible_tolerance = 4e-3, diameter = 2;
  constexpr std::size_t few = 200;
  double tolerance = 0, share = 1;
  while (true) {
    Page_curves result = thinned_curves(curves, scaling, tolerance, share);
    const std::size_t bytes = result.bytes();
    if (bytes <= most_bytes || tolerance > diameter) return result;
    if (tolerance < visible_tolerance || result.sizes.size() <= few)
      tolerance = std::max(2 * tolerance, least_tolerance);
    else
      share *= std::min(0.9, 0.97 * static_cast<double>(most_bytes) / static_cast<double>(bytes));
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_CURVES_H
