// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_CHECK_COORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_CHECK_COORDINATES_H

#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The comparison of angles around edges is the first to read coordinates.
inline void check_coordinates(const std::vector<std::array<double, 3>>& points) {
  for (std::size_t v = 0; v < points.size(); ++v)
    for (const double x : points[v])
      if (!std::isfinite(x))
        throw Invalid_input::about(
            Element_kind::vertex, v,
            " has a coordinate that is not finite; correct it, or remove the "
            "vertex and its faces");
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_CHECK_COORDINATES_H
