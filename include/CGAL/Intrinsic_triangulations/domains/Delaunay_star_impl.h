// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_DELAUNAY_STAR_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_DELAUNAY_STAR_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/domains/Delaunay_star.h>
#include <CGAL/Intrinsic_triangulations/input/Point_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Predicates about neighbours of the origin.
class Star_predicates {
public:
  using Neighbour = Delaunay_star::Neighbour;
  using Point = Point_kernel::Point_2;

  explicit Star_predicates(std::uint32_t center) : center_(center) {}

  // whether `b` is to the left of the line from the origin to `a`: positive
  static CGAL::Orientation turn(const Neighbour& a, const Neighbour& b) {
    const double left = a.at[0] * b.at[1], right = a.at[1] * b.at[0], area = left - right;
    if (is_certain(area, std::abs(left) + std::abs(right)))
      return area > 0 ? CGAL::POSITIVE : CGAL::NEGATIVE;
    return Exactly<Exact::Orientation_2, Approximate::Orientation_2>()(Point(0, 0), point(a),
                                                                       point(b));
  }
  static bool is_nearer(const Neighbour& a, const Neighbour& b) {
    return Exactly<Exact::Compare_distance_2, Approximate::Compare_distance_2>()(
               Point(0, 0), point(a), point(b)) == CGAL::SMALLER;
  }
  // by direction, then by distance
  static bool is_before(const Neighbour& a, const Neighbour& b) {
    const bool above_a = is_above(a), above_b = is_above(b);
    if (above_a != above_b) return above_a;
    const CGAL::Orientation o = turn(a, b);
    return o == CGAL::COLLINEAR ? is_nearer(a, b) : o == CGAL::POSITIVE;
  }
  static bool is_same_direction(const Neighbour& a, const Neighbour& b) {
    return is_above(a) == is_above(b) && turn(a, b) == CGAL::COLLINEAR;
  }
  // whether the edge to `b` is Delaunay between those to `a` and `c`
  bool is_kept(const Neighbour& a, const Neighbour& b, const Neighbour& c) const {
    const CGAL::Oriented_side side =
        Exactly<Exact::Side_of_oriented_circle_2, Approximate::Side_of_oriented_circle_2>()(
            point(a), point(b), point(c), Point(0, 0));
    if (side != CGAL::ON_ORIENTED_BOUNDARY) return side == CGAL::ON_POSITIVE_SIDE;
    return std::min(center_, b.number) < std::min(a.number, c.number);
  }

private:
  using Exact = Point_kernel::Exact_kernel;
  using Approximate = Point_kernel::Approximate_kernel;
  template <class E, class A>
  using Exactly = Point_kernel::Exactly<E, A>;

  // whether rounding cannot have changed the sign of a difference of two products
  static bool is_certain(double difference, double sum_of_sizes) {
    return std::abs(difference) > 0x1p-50 * sum_of_sizes + 0x1p-1000;
  }
  static Point point(const Neighbour& a) { return Point(a.at[0], a.at[1]); }
  static bool is_above(const Neighbour& a) { return a.at[1] > 0 || (a.at[1] == 0 && a.at[0] > 0); }

  std::uint32_t center_;
};

CGAL_INTRINSIC_TRIANGULATIONS_INLINE bool Delaunay_star::find(std::uint32_t center,
                                                              std::vector<Neighbour>& neighbours) {
  using P = Star_predicates;
  const P predicates(center);
  std::erase_if(neighbours, [](const Neighbour& a) { return a.at[0] == 0 && a.at[1] == 0; });
  std::sort(neighbours.begin(), neighbours.end(), P::is_before);
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end(), P::is_same_direction),
                   neighbours.end()); // those behind another
  const std::size_t n = neighbours.size();
  if (n < 2) return false;
  // begin after a gap of half a turn, if there is one, else at the nearest, which is always in the star
  std::size_t first = 0;
  bool is_closed = true;
  for (std::size_t i = 0; i < n && is_closed; ++i) {
    is_closed = P::turn(neighbours[i], neighbours[(i + 1) % n]) == CGAL::POSITIVE;
    if (!is_closed) first = (i + 1) % n;
  }
  const auto begin = neighbours.begin();
  if (is_closed)
    first =
        static_cast<std::size_t>(std::min_element(begin, neighbours.end(), P::is_nearer) - begin);
  std::rotate(begin, begin + static_cast<std::ptrdiff_t>(first), neighbours.end());
  if (is_closed) neighbours.push_back(neighbours.front());
  std::size_t kept = 0; // Graham's scan
  for (const Neighbour& c : std::vector<Neighbour>(neighbours)) {
    while (kept > 1 && !predicates.is_kept(neighbours[kept - 2], neighbours[kept - 1], c)) --kept;
    neighbours[kept++] = c;
  }
  neighbours.resize(is_closed ? kept - 1 : kept);
  if (neighbours.size() == 2 && P::turn(neighbours[0], neighbours[1]) != CGAL::POSITIVE)
    neighbours.clear(); // on a line
  return is_closed;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_DELAUNAY_STAR_IMPL_H
