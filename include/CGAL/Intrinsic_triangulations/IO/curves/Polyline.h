// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_POLYLINE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_POLYLINE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a curve in space, for a file or a page: points that straight lines join.
*/
struct Polyline {
  /// Its points, in order.
  std::vector<std::array<double, 3>> points;
  /// Whether a line joins the last point with the first one.
  bool is_closed = false;
  /// A number that tells it from others.
  std::int32_t label = 0;

  /// returns the number of lines.
  std::size_t number_of_segments() const {
    return points.size() < 2 ? 0 : points.size() - (is_closed ? 0 : 1);
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_POLYLINE_H
