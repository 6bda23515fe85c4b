// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/domains/Delaunay_star.h>
#include <CGAL/Intrinsic_triangulations/formulas/Space_vector.h>
#include <CGAL/Intrinsic_triangulations/input/polygons/Point_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Predicates about neighbours of the origin. What differs by less than `tie` is equal: coordinates
// of points that were turned are rounded, and results must not depend on that. Where products
// leave the range of doubles, exact numbers decide.
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
    const double turned = angle(a, b);
    if (std::abs(turned) <= tie || std::abs(turned) >= 2 - tie) return CGAL::COLLINEAR;
    return turned > 0 ? CGAL::POSITIVE : CGAL::NEGATIVE;
  }
  static bool is_same_direction(const Neighbour& a, const Neighbour& b) {
    return std::abs(angle(a, b)) <= tie;
  }
  static bool is_nearer(const Neighbour& a, const Neighbour& b) {
    const double d = squared_distance(a), e = squared_distance(b);
    if (is_in_range(e) && d < (1 - tie) * e) return true;
    if (is_in_range(d) && e < (1 - tie) * d) return false;
    if (is_in_range(d) && is_in_range(e)) return a.number < b.number;
    return Exactly<Exact::Compare_distance_2, Approximate::Compare_distance_2>()(
               Point(0, 0), point(a), point(b)) == CGAL::SMALLER;
  }
  // whether the edge to `b` is Delaunay between those to `a` and `c`
  bool is_kept(const Neighbour& a, const Neighbour& b, const Neighbour& c) const {
    const CGAL::Oriented_side side = side_of_circle(a, b, c);
    if (side != CGAL::ON_ORIENTED_BOUNDARY) return side == CGAL::ON_POSITIVE_SIDE;
    const double excess = excess_in_space(a, b, c);
    if (std::abs(excess) > tie) return excess > 0;
    return std::min(center_, b.number) < std::min(a.number, c.number);
  }

private:
  using Exact = Point_kernel::Exact_kernel;
  using Approximate = Point_kernel::Approximate_kernel;
  template <class E, class A>
  using Exactly = Point_kernel::Exactly<E, A>;

  // Far above rounding, of coordinates a million times as large as distances, too; far below what
  // changes a surface.
  static constexpr double tie = 0x1p-30;
  // What the turn into the plane may change: from 1/16 to 1/4 clouds have the same areas up to 1 %
  // (0: 33 %); no quotient that squares on lattices have.
  static constexpr double open = 0.13;
  // whether products neither underflow nor overflow
  static bool is_in_range(double x) { return x > 1e-280 && x < 1e300; }

  // from -2 to 2
  static double angle(const Neighbour& a, const Neighbour& b) {
    const double turned = b.direction - a.direction;
    return turned < -2 ? turned + 4 : turned > 2 ? turned - 4 : turned;
  }
  // By how much the angles of the quadrilateral at the ends of its diagonal from the origin to `b`
  // exceed those at `a` and `c`.
  static double excess_in_space(const Neighbour& a, const Neighbour& b, const Neighbour& c) {
    const auto angle = [](const Space_vector<double>& v, const Space_vector<double>& w) {
      return std::atan2(norm(cross_product(v, w)), inner_product(v, w));
    };
    const auto at_end = [&](const Neighbour& x) { // between the origin and b
      return angle(x.in_space, difference(x.in_space, b.in_space));
    };
    return angle(a.in_space, c.in_space) +
           angle(difference(a.in_space, b.in_space), difference(c.in_space, b.in_space)) -
           at_end(a) - at_end(c);
  }
  // whether the triangle of the origin is about as large in the plane as in space
  static bool is_flat(const Neighbour& a, const Neighbour& b) {
    return 2 * (a.at[0] * b.at[1] - a.at[1] * b.at[0]) >
           norm(cross_product(a.in_space, b.in_space));
  }
  // On which side of the circle through three points the origin is; on it, if the plane leaves that
  // open: it differs from the surface by about the square of a neighbour's distance over the radius
  // of curvature.
  static CGAL::Oriented_side side_of_circle(const Neighbour& a, const Neighbour& b,
                                            const Neighbour& c) {
    double determinant = 0, size = 0;
    for (const auto& [p, q, r] : {std::array{&a, &b, &c}, {&b, &c, &a}, {&c, &a, &b}}) {
      const double s = squared_distance(*p), x = q->at[0] * r->at[1], y = q->at[1] * r->at[0];
      determinant += s * (x - y);
      size += s * (std::abs(x) + std::abs(y));
    }
    if (is_in_range(size)) {
      if (std::abs(determinant) <= (is_flat(a, b) && is_flat(b, c) ? open : tie) * size)
        return CGAL::ON_ORIENTED_BOUNDARY;
      return determinant > 0 ? CGAL::ON_POSITIVE_SIDE : CGAL::ON_NEGATIVE_SIDE;
    }
    return Exactly<Exact::Side_of_oriented_circle_2, Approximate::Side_of_oriented_circle_2>()(
        point(a), point(b), point(c), Point(0, 0));
  }
  static Point point(const Neighbour& a) { return Point(a.at[0], a.at[1]); }
  static double squared_distance(const Neighbour& a) {
    return a.at[0] * a.at[0] + a.at[1] * a.at[1];
  }

  std::uint32_t center_;
};

// Keeps the nearest of those in one direction. Directions follow each other in a circle.
static void drop_those_behind(std::vector<Delaunay_star::Neighbour>& neighbours) {
  using P = Star_predicates;
  std::size_t kept = 0;
  const auto keep_nearer = [&](std::size_t i, const Delaunay_star::Neighbour& a) {
    if (P::is_nearer(a, neighbours[i])) neighbours[i] = a;
  };
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    if (kept > 0 && P::is_same_direction(neighbours[kept - 1], neighbours[i]))
      keep_nearer(kept - 1, neighbours[i]);
    else
      neighbours[kept++] = neighbours[i];
  }
  if (kept > 1 && P::is_same_direction(neighbours[kept - 1], neighbours[0]))
    keep_nearer(0, neighbours[--kept]);
  neighbours.resize(kept);
}

bool Delaunay_star::find(std::uint32_t center, std::vector<Neighbour>& neighbours) {
  using P = Star_predicates;
  const P predicates(center);
  std::erase_if(neighbours, [](const Neighbour& a) { return a.at[0] == 0 && a.at[1] == 0; });
  for (Neighbour& a : neighbours) a.direction = P::direction(a.at);
  std::ranges::sort(neighbours, {}, &Neighbour::direction);
  drop_those_behind(neighbours);
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
  // from the nearer side, whatever the orientation of the plane: decisions in space need not agree
  const bool is_mirrored = P::is_nearer(neighbours.back(), neighbours[is_closed ? 1 : 0]);
  if (is_mirrored) std::reverse(begin + (is_closed ? 1 : 0), neighbours.end());
  if (is_closed) neighbours.push_back(neighbours.front());
  std::size_t kept = 0; // Graham's scan
  for (const Neighbour& c : std::vector<Neighbour>(neighbours)) {
    const auto is_kept = [&](const Neighbour& a, const Neighbour& b) {
      return is_mirrored ? predicates.is_kept(c, b, a) : predicates.is_kept(a, b, c);
    };
    while (kept > 1 && !is_kept(neighbours[kept - 2], neighbours[kept - 1])) --kept;
    neighbours[kept++] = c;
  }
  neighbours.resize(is_closed ? kept - 1 : kept);
  if (is_mirrored) std::ranges::reverse(neighbours);
  if (neighbours.size() == 2 && P::turn(neighbours[0], neighbours[1]) != CGAL::POSITIVE)
    neighbours.clear(); // on a line
  return is_closed;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
