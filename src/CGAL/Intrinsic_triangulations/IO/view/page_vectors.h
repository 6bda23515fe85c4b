// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_VECTORS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_VECTORS_H

#include <CGAL/Intrinsic_triangulations/IO/view/drawn_geometry.h>
#include <CGAL/Intrinsic_triangulations/IO/view/write_html_view.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Vectors as a page has them: the longest is as long as half a mean edge.
struct Page_vectors {
  std::vector<std::array<float, 3>> places, vectors;
  double longest = 0;    // after scaling
  std::size_t given = 0; // vectors that are not zero

  std::size_t bytes() const { return 24 * places.size(); }
};

inline double mean_length(const Drawn_edges& edges, std::span<const std::array<float, 3>> points) {
  double sum = 0;
  for (std::size_t i = 0; i < edges.room.size(); ++i) {
    const std::array<float, 3>&p = points[edges.ends[2 * i]], &q = points[edges.ends[2 * i + 1]];
    sum += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }
  return edges.room.empty() ? 0 : sum / static_cast<double>(edges.room.size());
}

// At most so many vectors, those at one place together, from evenly chosen places.
inline Page_vectors page_vectors(std::span<const Placed_vector> all,
                                 const Unit_ball_scaling& scaling, double mean_edge,
                                 std::size_t most) {
  Page_vectors result;
  double longest = 0;
  for (const auto& [place, v] : all)
    if (const double size = std::hypot(v[0], v[1], v[2]); std::isfinite(size))
      longest = std::max(longest, size);
  if (!(longest > 0 && mean_edge > 0)) return result;
  result.longest = mean_edge / 2;
  const std::size_t few = std::max<std::size_t>(most, 1), step = (all.size() + few - 1) / few;
  for (std::size_t i = 0, n = 0; i < all.size(); ++i) {
    if (i > 0 && all[i].place != all[i - 1].place) ++n;
    const std::array<double, 3>& v = all[i].vector;
    const double size = std::hypot(v[0], v[1], v[2]);
    if (!(size > 0) || !std::isfinite(size)) continue;
    ++result.given;
    if (n % step != 0) continue;
    result.places.push_back(scaling(all[i].place));
    std::array<float, 3> scaled;
    for (std::size_t c = 0; c < 3; ++c)
      scaled[c] = static_cast<float>(v[c] / longest * result.longest);
    result.vectors.push_back(scaled);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_VECTORS_H
