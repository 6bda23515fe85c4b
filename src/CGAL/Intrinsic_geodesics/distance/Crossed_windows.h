// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_CROSSED_WINDOWS_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_CROSSED_WINDOWS_H

#include <CGAL/Intrinsic_geodesics/distance/Distance_field.h>
#include <CGAL/Intrinsic_geodesics/distance/Window.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The nearest window of a side that shows the far corner.
struct Split {
  double distance = std::numeric_limits<double>::infinity();
  double crossing =
      std::numeric_limits<double>::infinity(); // of its line to the corner and the side
  bool operator==(const Split&) const = default;
};

/*!
\brief is what a search remembers of windows on a surface where several faces may meet at an edge.

Two paths whose images cross in the plane need not cross on the surface if they came through other
faces, so that Chen and Han's rule holds among windows only that crossed the same branches. A
window of the same source that covers another one, and is as near at both ends, is as near in
between: it stands in for it whatever both crossed. Without this, windows multiply at every branch.
*/
class Crossed_windows {
public:
  /// forgets all.
  void clear() {
    numbers_.clear();
    splits_.clear();
    seen_.clear();
  }
  /// returns the number of a crossing, which comes into being if it is not there yet.
  std::uint32_t crossing(Distance_field& field, std::uint32_t source, std::uint32_t from,
                         std::uint32_t to) {
    const auto next = static_cast<std::uint32_t>(Crossing::first + field.crossings.size());
    const auto [place, is_new] = numbers_.try_emplace({source, from, to}, next);
    if (is_new) field.crossings.push_back({source, field.root(source), from, to});
    return place->second;
  }
  /// returns the split of a side among the windows of a crossing.
  Split& split(std::uint32_t side, std::uint32_t crossing) { return splits_[key(side, crossing)]; }
  /// returns whether a window that was seen before through the side stands in for this one, and
  /// takes note of it if not. \param length of the side
  bool is_covered(const Distance_field& field, std::uint32_t side, const Window& w, double length) {
    std::vector<Window>& seen = seen_[key(side, field.root(w.source))];
    const Squared_rays rays(w);
    constexpr double rounding = 4 * window_distance_tolerance; // squares, of two windows
    const bool is_covered = std::ranges::any_of(seen, [&](const Window& other) {
      return other.begin <= w.begin + rounding * length && other.end >= w.end - rounding * length &&
             other.squared_distance(w.begin) <= rays.begin * (1 + rounding) &&
             other.squared_distance(w.end) <= rays.end * (1 + rounding);
    });
    if (!is_covered) seen.push_back(w);
    return is_covered;
  }

private:
  static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
    return (std::uint64_t{a} << 32U) | b;
  }

  std::map<std::array<std::uint32_t, 3>, std::uint32_t> numbers_;
  std::unordered_map<std::uint64_t, Split> splits_;
  std::unordered_map<std::uint64_t, std::vector<Window>> seen_; // by sides and sources
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_CROSSED_WINDOWS_H
