// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_SORT_AROUND_EDGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_SORT_AROUND_EDGE_H

#include <CGAL/Intrinsic_triangulations/input/Point_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Where half planes bounded by a line are, seen from one of them. Only predicates of the kernel on the points as given are
// asked, which are exact.
class Half_planes {
public:
  using Point = Point_kernel::Point_3;

  // \param numbers by which points are known to be the same without a predicate
  Half_planes(const Point& a, const Point& b, const std::vector<Point>& apices,
              const std::vector<std::uint32_t>& numbers)
      : a_(a), b_(b), apices_(apices), numbers_(numbers), sector_(apices.size(), 4) {
    std::size_t first = 0;
    while (first < apices.size() && Point_kernel::Are_collinear()(a, b, apices[first])) ++first;
    for (std::size_t i = first; i < apices.size(); ++i)
      sector_[i] = numbers[i] == numbers[first] ? 0 : sector(apices[first], apices[i]);
  }

  bool is_before(std::uint32_t i, std::uint32_t j) const {
    if (sector_[i] != sector_[j]) return sector_[i] < sector_[j];
    return sector_[i] % 2 == 1 && numbers_[i] != numbers_[j] &&
           Point_kernel::Find_orientation()(a_, b_, apices_[i], apices_[j]) == CGAL::POSITIVE;
  }

private:
  // 0: in the half plane of `first`, 1: less than half a turn from there, 2: half a turn, 3: more, 4: on the line
  int sector(const Point& first, const Point& p) const {
    const CGAL::Orientation side = Point_kernel::Find_orientation()(a_, b_, first, p);
    if (side != CGAL::COPLANAR) return side == CGAL::POSITIVE ? 1 : 3;
    if (Point_kernel::Are_collinear()(a_, b_, p)) return 4;
    return Point_kernel::Find_orientation_in_plane()(a_, b_, first, p) == CGAL::POSITIVE ? 0 : 2;
  }

  const Point &a_, &b_;
  const std::vector<Point>& apices_;
  const std::vector<std::uint32_t>& numbers_;
  std::vector<int> sector_;
};

// Sorts points counterclockwise about the line from `a` to `b`, starting in the half plane of one of them; decided exactly.
// Points in one half plane keep their order, and so do those on the line, which come last.
// \param apices numbers of the points, from 0 in `points`
// \return places in `apices`, in the new order
// \pre coordinates are finite
inline std::vector<std::uint32_t> sort_around_edge(const std::vector<std::array<double, 3>>& points,
                                                   std::uint32_t a, std::uint32_t b,
                                                   const std::vector<std::uint32_t>& apices) {
  const auto point = [&points](std::uint32_t v) {
    return Half_planes::Point(points[v][0], points[v][1], points[v][2]);
  };
  std::vector<Half_planes::Point> corners;
  for (const std::uint32_t v : apices) corners.push_back(point(v));
  const Half_planes::Point from = point(a), to = point(b);
  const Half_planes planes(from, to, corners, apices);
  std::vector<std::uint32_t> order(apices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t i, std::uint32_t j) { return planes.is_before(i, j); });
  return order;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_SORT_AROUND_EDGE_H
