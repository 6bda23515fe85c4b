// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_TEXTURE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_TEXTURE_H

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>
#include <CGAL/Intrinsic_triangulations/formulas/is_torn.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace CGAL::Intrinsic_triangulations::internal {

// How places in the plane are scaled on a page: the longer side of their bounding box becomes 1.
class Texture_scaling {
  using Place = std::array<double, 2>;

public:
  Texture_scaling(std::span<const Place> places, bool is_disk) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Place greatest{-infinity, -infinity};
    least_ = {infinity, infinity};
    for (const Place& p : places)
      for (std::size_t c = 0; c < 2 && is_place(p); ++c) {
        least_[c] = std::min(least_[c], p[c]);
        greatest[c] = std::max(greatest[c], p[c]);
      }
    if (is_disk) {
      least_ = {-1, -1};
      greatest = {1, 1};
    }
    size_ = std::max(greatest[0] - least_[0], greatest[1] - least_[1]);
  }

  // Not a number where there is no place.
  float operator()(const Place& p, std::size_t c) const {
    return !is_place(p) ? std::numeric_limits<float>::quiet_NaN()
           : size_ > 0  ? static_cast<float>((p[c] - least_[c]) / size_)
                        : 0.f;
  }
  // a length after scaling
  double scaled(double length) const { return size_ > 0 ? length / size_ : 0; }

private:
  static bool is_place(const Place& p) { return std::isfinite(p[0]) && std::isfinite(p[1]); }

  Place least_;
  double size_;
};

// The radius within which a logarithm is a map: no edge is torn. Places at crossings of edges are
// means of those at the ends, and tell nothing.
inline double radius_of_logarithm(const Common_subdivision& s,
                                  std::span<const std::array<double, 3>> points,
                                  std::span<const std::array<double, 2>> places) {
  double radius = 0, least_torn = std::numeric_limits<double>::infinity();
  for (const auto& [u, v] : places)
    if (std::isfinite(u) && std::isfinite(v)) radius = std::max(radius, std::hypot(u, v));
  for_each_subdivision_edge(
      s, [&](std::uint32_t a, std::uint32_t b, const Common_subdivision::Side&) {
        const double length = std::hypot(points[a][0] - points[b][0], points[a][1] - points[b][1],
                                         points[a][2] - points[b][2]);
        if (!is_torn(places[a], places[b], length)) return;
        for (const std::uint32_t v : {a, b})
          if (const double d = std::hypot(places[v][0], places[v][1]);
              v < s.vertices.size() && d < least_torn)
            least_torn = d;
      });
  return std::min(radius, least_torn);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_TEXTURE_H
