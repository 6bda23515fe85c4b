// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/domains/Delaunay_star.h>
#include <CGAL/Intrinsic_triangulations/formulas/Space_vector.h>
#include <CGAL/Intrinsic_triangulations/input/polygons/Point_kernel.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>
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

  static constexpr double tie = Delaunay_star::tie;

  // where the direction of a point meets the square of the points with |x| + |y| = 1, along it;
  // with a relative error of 1e-15
  static double direction(const std::array<double, 2>& at) {
    const auto [x, y] = at;
    if (y > 0 || (y == 0 && x > 0)) return x >= 0 ? y / (x + y) : 1 + x / (x - y);
    return x <= 0 ? 2 + y / (x + y) : 3 + x / (x - y);
  }
  static double squared_distance(const Neighbour& a) {
    return a.at[0] * a.at[0] + a.at[1] * a.at[1];
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
  // which of them is nearer, or whether they are as near
  static CGAL::Comparison_result compare_distances(const Neighbour& a, const Neighbour& b) {
    const double d = squared_distance(a), e = squared_distance(b);
    if (is_in_range(e) && d < (1 - tie) * e) return CGAL::SMALLER;
    if (is_in_range(d) && e < (1 - tie) * d) return CGAL::LARGER;
    if (is_in_range(d) && is_in_range(e)) return CGAL::EQUAL;
    return Exactly<Exact::Compare_distance_2, Approximate::Compare_distance_2>()(
        Point(0, 0), point(a), point(b));
  }
  // By how much the edge to `b` is Delaunay between those to `a` and `c`: by less than `tie`, if
  // four points are on a circle.
  static double strength(const Neighbour& a, const Neighbour& b, const Neighbour& c) {
    if (turn(a, c) != CGAL::POSITIVE) return 1; // no edge from `a` to `c` is in front of `b`
    const double in_plane = side_of_circle(a, b, c);
    const bool is_open = std::abs(in_plane) <= open && is_flat(a, b, 0.5) && is_flat(b, c, 0.5);
    return is_open || is_on_circle_in_space(a, b, c) ? excess_in_space(a, b, c) : in_plane;
  }
  // whether the triangle of the origin is as large in the plane as a part of it in space
  static bool is_flat(const Neighbour& a, const Neighbour& b, double part) {
    return a.at[0] * b.at[1] - a.at[1] * b.at[0] >
           part * length(cross_product(a.in_space, b.in_space));
  }
  // of the angle between two neighbours
  static double cosine(const Neighbour& a, const Neighbour& b) {
    return (a.at[0] * b.at[0] + a.at[1] * b.at[1]) / (a.distance * b.distance);
  }

private:
  using Exact = Point_kernel::Exact_kernel;
  using Approximate = Point_kernel::Approximate_kernel;
  template <class E, class A>
  using Exactly = Point_kernel::Exactly<E, A>;

  // Up to this value the turn into the plane may have changed the side: clouds have the same areas
  // up to 1 % with 1/16 to 1/4 (with 0 up to 33 % off). No star of a lattice of squares has it.
  static constexpr double open = 0.13;
  // whether products neither underflow nor overflow
  static bool is_in_range(double x) { return x > 1e-280 && x < 1e300; }

  // from -2 to 2
  static double angle(const Neighbour& a, const Neighbour& b) {
    const double turned = b.direction - a.direction;
    return turned < -2 ? turned + 4 : turned > 2 ? turned - 4 : turned;
  }
  // The sum of two angles, from 0 to 2 pi: that of the product of two complex numbers.
  class Sum_of_angles {
  public:
    using Sides = std::array<Space_vector<double>, 2>;
    Sum_of_angles(const Sides& first, const Sides& second)
        : first_(product(first)), second_(product(second)), sum_(first_ * second_) {}

    double value() const {
      if (!is_in_range(std::abs(sum_.real()) + std::abs(sum_.imag())))
        return std::arg(first_) + std::arg(second_);
      const double angle = std::arg(sum_);
      return std::signbit(angle) ? angle + 2 * std::numbers::pi : angle; // -0: two angles of pi
    }
    // whether it is between pi and 2 pi, and the other one between 0 and pi, one of them by pi / 4
    bool is_clearly_greater(const Sum_of_angles& other) const {
      return sum_.imag() < 0 && other.sum_.imag() > 0 &&
             (sum_.real() > sum_.imag() || other.sum_.real() > -other.sum_.imag());
    }

  private:
    // a number with the angle between two sides
    static std::complex<double> product(const Sides& s) {
      return {inner_product(s[0], s[1]), length(cross_product(s[0], s[1]))};
    }

    std::complex<double> first_, second_, sum_;
  };
  // By how much the angles of the quadrilateral at the ends of its diagonal from the origin to `b`
  // exceed those at `a` and `c`; 1 if clearly: what is positive is not compared.
  static double excess_in_space(const Neighbour& a, const Neighbour& b, const Neighbour& c) {
    const Space_vector<double> to_a = difference(a.in_space, b.in_space),
                               to_c = difference(c.in_space, b.in_space);
    const Sum_of_angles at_ends({a.in_space, c.in_space}, {to_a, to_c}),
        beside({a.in_space, to_a}, {c.in_space, to_c});
    return at_ends.is_clearly_greater(beside) ? 1 : at_ends.value() - beside.value();
  }
  static double length(const Space_vector<double>& v) {
    const double square = inner_product(v, v);
    return is_in_range(square) ? std::sqrt(square) : norm(v);
  }
  // Whether four points are nearly on a circle in space, in this order, by Ptolemy's theorem. The
  // test is coarse: the difference grows with the square of the distance from the circle, so that
  // points up to 2^-15 off pass. Then angles decide.
  static bool is_on_circle_in_space(const Neighbour& a, const Neighbour& b, const Neighbour& c) {
    const double diagonals = length(b.in_space) * length(difference(a.in_space, c.in_space)),
                 sides = length(a.in_space) * length(difference(b.in_space, c.in_space)) +
                         length(c.in_space) * length(difference(a.in_space, b.in_space));
    return sides - diagonals < tie * diagonals; // not if squares vanish
  }
  // On which side of the circle through three points the origin is, from -1 to 1: positive
  // inside. The plane does not decide where the value is small: it differs from the surface by
  // about the square of a neighbour's distance over the radius of curvature.
  static double side_of_circle(const Neighbour& a, const Neighbour& b, const Neighbour& c) {
    double determinant = 0, size = 0;
    for (const auto& [p, q, r] : {std::array{&a, &b, &c}, {&b, &c, &a}, {&c, &a, &b}}) {
      const double s = squared_distance(*p);
      determinant += s * (q->at[0] * r->at[1] - q->at[1] * r->at[0]);
      size += s * (q->distance * r->distance);
    }
    if (is_in_range(size)) return determinant / size;
    return Exactly<Exact::Side_of_oriented_circle_2, Approximate::Side_of_oriented_circle_2>()(
        point(a), point(b), point(c), Point(0, 0));
  }
  static Point point(const Neighbour& a) { return Point(a.at[0], a.at[1]); }
};

// Keeps the nearest of those in one direction, or none if two are as near: points at one place in
// the plane are on both sides of it, and nothing says which of them is a neighbour. Directions
// follow each other in a circle.
static void drop_those_behind(std::vector<Delaunay_star::Neighbour>& neighbours) {
  using P = Star_predicates;
  const std::size_t n = neighbours.size();
  std::size_t first = 0, kept = 0;
  while (first < n && P::is_same_direction(neighbours[(first + n - 1) % n], neighbours[first]))
    ++first;
  if (first < n)
    std::rotate(neighbours.begin(), neighbours.begin() + std::ptrdiff_t(first), neighbours.end());
  bool is_alone = true;
  for (std::size_t i = 0; i < n; ++i) {
    const Delaunay_star::Neighbour& here = neighbours[i];
    if (i == 0 || !P::is_same_direction(neighbours[i - 1], here)) {
      if (!is_alone) --kept;
      neighbours[kept++] = here;
      is_alone = true;
      continue;
    }
    const CGAL::Comparison_result c = P::compare_distances(here, neighbours[kept - 1]);
    if (c == CGAL::SMALLER) neighbours[kept - 1] = here;
    if (c != CGAL::LARGER) is_alone = c == CGAL::SMALLER;
  }
  neighbours.resize(is_alone ? kept : kept - 1);
}

// Leaves edges out that are not Delaunay, again and again; of two beside each other, the one that
// is less so, and both if they are alike. So the result does not depend on where one begins.
static void drop_those_in_front(std::vector<Delaunay_star::Neighbour>& star, bool is_closed) {
  using P = Star_predicates;
  constexpr double unknown = std::numeric_limits<double>::infinity();
  for (Delaunay_star::Neighbour& a : star) a.strength = unknown;
  for (std::size_t n = 0, kept = 0; n != star.size(); kept = 0) {
    n = star.size();
    if (!is_closed) star.front().strength = star.back().strength = 1;
    for (std::size_t i = 0; i < n; ++i)
      if (star[i].strength == unknown)
        star[i].strength = P::strength(star[(i + n - 1) % n], star[i], star[(i + 1) % n]);
    const double first = star.front().strength;
    double before = star.back().strength;
    bool is_last_dropped = false, is_first_dropped = false;
    for (std::size_t i = 0; i < n; ++i) {
      const double here = star[i].strength, after = i + 1 < n ? star[i + 1].strength : first;
      const bool is_dropped = here < -P::tie && here <= std::min(before, after) + P::tie;
      if (!is_dropped) star[kept] = star[i];
      if (!is_dropped && is_last_dropped) star[kept].strength = unknown;
      if (is_dropped && kept > 0) star[kept - 1].strength = unknown;
      if (is_dropped && i == 0) is_first_dropped = true;
      if (!is_dropped) ++kept;
      before = here;
      is_last_dropped = is_dropped;
    }
    if (kept == 0) return; // all are alike: none is in front of another
    if (is_first_dropped) star[kept - 1].strength = unknown;
    if (is_last_dropped) star[0].strength = unknown;
    star.resize(kept);
  }
}

// Opens a closed star at a border: at the widest angle across which the neighbours are not spread
// in the plane but turn in space. Such a star was closed only because the plane is tilted. Edges
// that are tied within the angle are left out.
// \return whether there is one; then the star begins behind it
static bool open_at_border(std::vector<Delaunay_star::Neighbour>& neighbours) {
  using P = Star_predicates;
  const std::size_t n = neighbours.size();
  std::size_t first = n, dropped = 0;
  double least = -std::sqrt(0.75); // the cosine of the widest, which is above 5/6 pi
  for (std::size_t i = 0; i < n; ++i) {
    if (neighbours[i].is_tied()) continue;
    std::size_t count = 1;
    while (neighbours[(i + count) % n].is_tied()) ++count;
    const auto &a = neighbours[i], &b = neighbours[(i + count) % n];
    if (count == n || !(P::cosine(a, b) < least) || P::is_flat(a, b, 0.5)) continue;
    first = (i + count) % n;
    dropped = count - 1;
    least = P::cosine(a, b);
  }
  if (first == n) return false;
  std::rotate(neighbours.begin(), neighbours.begin() + std::ptrdiff_t(first), neighbours.end());
  neighbours.resize(n - dropped);
  return true;
}

Delaunay_star::Extent Delaunay_star::find(std::vector<Neighbour>& neighbours) {
  using P = Star_predicates;
  std::erase_if(neighbours, [](const Neighbour& a) { return a.at[0] == 0 && a.at[1] == 0; });
  for (Neighbour& a : neighbours) {
    a.direction = P::direction(a.at);
    a.distance = std::sqrt(P::squared_distance(a));
  }
  std::ranges::sort(neighbours, {}, &Neighbour::direction);
  drop_those_behind(neighbours);
  const std::size_t n = neighbours.size();
  if (n < 2) return Extent::open;
  std::size_t first = n; // after a gap of half a turn
  for (std::size_t i = 0; i < n; ++i)
    if (P::turn(neighbours[i], neighbours[(i + 1) % n]) != CGAL::POSITIVE) first = (i + 1) % n;
  const bool is_closed = first == n;
  if (!is_closed)
    std::rotate(neighbours.begin(), neighbours.begin() + std::ptrdiff_t(first), neighbours.end());
  drop_those_in_front(neighbours, is_closed);
  if (neighbours.size() == 2 && P::turn(neighbours[0], neighbours[1]) != CGAL::POSITIVE)
    neighbours.clear(); // on a line
  if (!is_closed) return Extent::open;
  return open_at_border(neighbours) ? Extent::bent : Extent::closed;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
