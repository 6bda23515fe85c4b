// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_UNIT_BALL_SCALING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_UNIT_BALL_SCALING_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace CGAL::Intrinsic_triangulations::internal {

// Centres points and scales them to the unit ball before they are rounded to single precision; half of each
// coordinate is taken first, so that no difference overflows.
class Unit_ball_scaling {
  using Point = std::array<double, 3>;

public:
  explicit Unit_ball_scaling(std::span<const Point> points) {
    for (std::size_t c = 0; c < 3 && !points.empty(); ++c) {
      const auto [least, greatest] =
          std::minmax_element(points.begin(), points.end(),
                              [c](const Point& p, const Point& q) { return p[c] < q[c]; });
      low_[c] = (*least)[c] / 2;
      extent_[c] = (*greatest)[c] / 2 - low_[c];
    }
    const double greatest = std::max({extent_[0], extent_[1], extent_[2]});
    unit_ = greatest > 0 ? greatest : 1;
    double radius = 0;
    for (const Point& p : points)
      radius = std::max(radius, std::hypot(centred(p, 0), centred(p, 1), centred(p, 2)));
    radius_ = radius > 0 ? radius : 1;
  }

  std::array<float, 3> operator()(const Point& p) const {
    std::array<float, 3> result;
    for (std::size_t c = 0; c < 3; ++c) result[c] = static_cast<float>(centred(p, c) / radius_);
    return result;
  }
  // half of the sides of the bounding box
  const Point& extent() const { return extent_; }

private:
  double centred(const Point& p, std::size_t c) const {
    return ((p[c] / 2 - low_[c]) - extent_[c] / 2) / unit_;
  }

  Point low_{0, 0, 0}, extent_{0, 0, 0};
  double unit_ = 1, radius_ = 1;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_UNIT_BALL_SCALING_H
