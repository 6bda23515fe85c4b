// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/domains/Delaunay_star.h>
#include <CGAL/Intrinsic_triangulations/input/Point_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Predicates about neighbours of the origin. Where rounded values differ by more than their errors,
// they decide.
class Star_predicates {
public:
  using Neighbour = Delaunay_star::Neighbour;
  using Point = Point_kernel::Point_2;

  explicit Star_predicates(std::uint32_t center) : center_(center) {}

  // where the direction of a point meets the square of the points with |x| + |y| = 1, along it;
  // with a relative error of 1e-15
  static double direction(const std::array<double, 2>& at) {
    const auto [x, y] = at;
    if (y > 0 || (y == 0 && x > 0)) return x >= 0 ? y / (x + y) : 1 + x / (x - y);
    return x <= 0 ? 2 + y / (x + y) : 3 + x / (x - y);
  }
  // whether `b` is to the left of the line from the origin to `a`: positive
  static CGAL::Orientation turn(const Neighbour& a, const Neighbour& b) {
    double angle = b.direction - a.direction;
    if (angle < -2) angle += 4;
    if (angle > 2) angle -= 4;
    if (std::abs(angle) > margin && std::abs(angle) < 2 - margin)
      return angle > 0 ? CGAL::POSITIVE : CGAL::NEGATIVE;
    return Exactly<Exact::Orientation_2, Approximate::Orientation_2>()(Point(0, 0), point(a),
                                                                       point(b));
  }
  static bool is_nearer(const Neighbour& a, const Neighbour& b) {
    const double d = squared_distance(a), e = squared_distance(b);
    if (e > least && d < (1 - margin) * e) return true;
    if (d > least && e < (1 - margin) * d) return false;
    return Exactly<Exact::Compare_distance_2, Approximate::Compare_distance_2>()(
               Point(0, 0), point(a), point(b)) == CGAL::SMALLER;
  }
  // by direction, then by distance
  static bool is_before(const Neighbour& a, const Neighbour& b) {
    if (std::abs(a.direction - b.direction) > margin) return a.direction < b.direction;
    const CGAL::Orientation o = turn(a, b);
    return o == CGAL::COLLINEAR ? is_nearer(a, b) : o == CGAL::POSITIVE;
  }
  static bool is_same_direction(const Neighbour& a, const Neighbour& b) {
    return std::abs(a.direction - b.direction) <= margin && turn(a, b) == CGAL::COLLINEAR;
  }
  // whether the edge to `b` is Delaunay between those to `a` and `c`
  bool is_kept(const Neighbour& a, const Neighbour& b, const Neighbour& c) const {
    const CGAL::Oriented_side side = side_of_circle(a, b, c);
    if (side != CGAL::ON_ORIENTED_BOUNDARY) return side == CGAL::ON_POSITIVE_SIDE;
    return std::min(center_, b.number) < std::min(a.number, c.number);
  }

private:
  using Exact = Point_kernel::Exact_kernel;
  using Approximate = Point_kernel::Approximate_kernel;
  template <class E, class A>
  using Exactly = Point_kernel::Exactly<E, A>;

  static constexpr double margin = 1e-13;
  static constexpr double least = 1e-280; // above, products do not underflow

  // On which side of the circle through three points the origin is.
  static CGAL::Oriented_side side_of_circle(const Neighbour& a, const Neighbour& b,
                                            const Neighbour& c) {
    double determinant = 0, size = 0;
    for (const auto& [p, q, r] : {std::array{&a, &b, &c}, {&b, &c, &a}, {&c, &a, &b}}) {
      const double s = squared_distance(*p), x = q->at[0] * r->at[1], y = q->at[1] * r->at[0];
      determinant += s * (x - y);
      size += s * (std::abs(x) + std::abs(y));
    }
    if (size > least && std::abs(determinant) > margin * size)
      return determinant > 0 ? CGAL::ON_POSITIVE_SIDE : CGAL::ON_NEGATIVE_SIDE;
    return Exactly<Exact::Side_of_oriented_circle_2, Approximate::Side_of_oriented_circle_2>()(
        point(a), point(b), point(c), Point(0, 0));
  }
  static Point point(const Neighbour& a) { return Point(a.at[0], a.at[1]); }
  static double squared_distance(const Neighbour& a) {
    return a.at[0] * a.at[0] + a.at[1] * a.at[1];
  }

  std::uint32_t center_;
};

bool Delaunay_star::find(std::uint32_t center, std::vector<Neighbour>& neighbours) {
  using P = Star_predicates;
  const P predicates(center);
  std::erase_if(neighbours, [](const Neighbour& a) { return a.at[0] == 0 && a.at[1] == 0; });
  for (Neighbour& a : neighbours) a.direction = P::direction(a.at);
  std::sort(neighbours.begin(), neighbours.end(), P::is_before);
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end(), P::is_same_direction),
                   neighbours.end()); // those behind another
  const std::size_t n = neighbours.size();
  if (n < 2) return false;
  // begin after a gap of half a turn, if there is one, else at the nearest, which is always in the
  // star
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

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
