// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_POLYGON_SOUP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_POLYGON_SOUP_H

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// Points and faces as they are in a file, see `read_polygon_soup()`.
struct Polygon_soup {
  std::vector<std::array<double, 3>> points;     ///< coordinates
  std::vector<std::vector<std::uint32_t>> faces; ///< the points at the corners of each face
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_POLYGON_SOUP_H
