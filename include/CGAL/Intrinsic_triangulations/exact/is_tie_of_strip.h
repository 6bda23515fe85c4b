// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_IS_TIE_OF_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_IS_TIE_OF_STRIP_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Binary_double.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Word_integer.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/integer_diamond_sign.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <utility>

/*!
\file
Ties over cylinders and prisms, decided in integers of fixed size. On CAD surfaces nearly all ties that
flips make are of this kind.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

/*
A diamond over a strip of triangles in space that is folded along parallel lines only, the *rulings*.

Let h be an integer vector along the rulings. Unfolding about them leaves x = <p, h> of a point p as it
is. Triangles between two rulings lie in one plane, a *panel*. There y, the coordinate at right angles,
is off that of a point b by |(p - b) x h| / |h|, the root of a rational number, or its negative: the
sign is that of <n, h x (p - b)>, n the normal of the panel. So with b on the ruling over which the
panel is entered, |h| y is a sum of signed roots of integers W = |(p - b) x h|^2, one for each panel on
the way from the first. Such sums are equal if their terms cancel.

Coordinates are integers below 2^w, differences below 2^(w + 1), components of cross products below
2^(2w + 3), sums of four x below 2^(2w + 5), W and products of normals below 2^(4w + 8). With
2w + 10 <= 64 `words`, as squared lengths need (see `integer_diamond_sign()`), the former fit so many
words and the latter twice as many.
*/
template <std::size_t words>
class Cylinder_strip {
public:
  using Integer = Word_integer<words>;
  using Vector = std::array<Integer, 3>;
  using Points = boost::container::small_vector<Vector, 16>;

  // `points` are the positions of the points of the diamond; both must outlive the strip
  Cylinder_strip(const Unfolded_diamond& diamond, const Points& points)
      : diamond_(diamond), points_(points) {
    is_valid_ = find_panels();
    if (is_valid_ && panels_.size() > 1)
      for (std::size_t c = 0; c < 4; ++c) x_[c] = product(points_[diamond_.point(c)], ruling_);
  }

  // Whether the corners are proven to be cocircular; in the sense of `Delaunay_expression`.
  bool is_cocircular() const {
    if (!is_valid_) return false;
    return panels_.size() == 1 ? is_cocircular_in_plane() : is_isosceles_trapezoid();
  }

  // Whether three corners are proven to be collinear.
  bool is_collinear(std::size_t a, std::size_t b, std::size_t c) const {
    if (!is_valid_) return false;
    if (panels_.size() == 1)
      return is_zero(cross(difference(point(a), point(b)), difference(point(c), point(b))));
    Root_sum
        sum; // twice the area of the triangle: of x_a (y_b - y_c) + x_b (y_c - y_a) + x_c (y_a - y_b)
    add_y(a, x_[c] - x_[b], sum);
    add_y(b, x_[a] - x_[c], sum);
    add_y(c, x_[b] - x_[a], sum);
    return sum.is_proven_zero();
  }

private:
  using Wide = Word_integer<2 * words>;
  using Coefficients = std::array<int, 4>; // of the four corners

  struct Panel {
    std::uint32_t base;   // point on the ruling over which it is entered
    std::uint32_t parent; // triangle beyond the ruling
  };

  struct Placed_triangle {
    std::uint32_t panel;
    Vector normal; // of any length
  };

  // A sum of roots of integers, with coefficients.
  struct Root_sum {
    boost::container::small_vector<std::pair<Wide, Wide>, 8> terms;

    void add(const Wide& square, bool is_positive, const Integer& coefficient) {
      const bool is_added = is_positive == (coefficient.sign() > 0);
      const Wide c = full_product(coefficient.magnitude(), Integer(1));
      for (auto& [s, sum] : terms)
        if (s == square) {
          sum = is_added ? sum + c : sum - c;
          return;
        }
      terms.emplace_back(square, is_added ? c : Wide() - c);
    }
    bool is_proven_zero() const {
      return std::all_of(terms.begin(), terms.end(),
                         [](const auto& t) { return t.second.is_zero(); });
    }
  };

  const Vector& point(std::size_t corner) const { return points_[diamond_.point(corner)]; }

  static Vector difference(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }

  static Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  static Integer product(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  static Wide wide_product(const Vector& a, const Vector& b) {
    Wide sum;
    for (std::size_t k = 0; k < 3; ++k) {
      const Wide p = full_product(a[k].magnitude(), b[k].magnitude());
      sum = a[k].sign() * b[k].sign() < 0 ? sum - p : sum + p;
    }
    return sum;
  }

  static bool is_zero(const Vector& v) {
    return v[0].is_zero() && v[1].is_zero() && v[2].is_zero();
  }

  // sorts triangles into panels; whether they are a strip as above
  bool find_panels() {
    for (const Unfolded_diamond::Triangle& t : diamond_.triangles) {
      const Vector& start = points_[t.start()];
      const Vector side = difference(points_[t.end()], start);
      const Vector apex = difference(points_[t.point[(t.entry + 2) % 3]], start);
      Placed_triangle placed{0, cross(side, apex)};
      if (is_zero(placed.normal)) return false;
      if (triangles_.empty())
        panels_.push_back({t.start(), 0});
      else if (!find_panel(t, side, apex, placed))
        return false;
      triangles_.push_back(placed);
    }
    return true;
  }

  bool find_panel(const Unfolded_diamond::Triangle& t, const Vector& side, const Vector& apex,
                  Placed_triangle& placed) {
    const Placed_triangle& parent = triangles_[t.parent];
    placed.panel = parent.panel;
    const bool is_flat = wide_product(apex, parent.normal).is_zero() &&
                         wide_product(placed.normal, parent.normal).sign() > 0;
    if (is_flat) return true;
    if (panels_.size() == 1)
      ruling_ = side;
    else if (!is_zero(cross(side, ruling_)))
      return false;
    placed.panel = static_cast<std::uint32_t>(panels_.size());
    panels_.push_back({t.start(), t.parent});
    return true;
  }

  // The base {a, b} and c, d opposite: y_a = y_b, y_c = y_d, x_a + x_b = x_c + x_d, or the same with x
  // and y exchanged. Then rows a - b and c - d of the matrix with rows (x, y, x^2 + y^2, 1) are linearly
  // dependent. Its determinant, of which `Delaunay_expression` is a multiple, is zero.
  bool is_isosceles_trapezoid() const {
    static constexpr Coefficients pairings[3][3] = {{{1, -1, 0, 0}, {0, 0, 1, -1}, {1, 1, -1, -1}},
                                                    {{1, 0, -1, 0}, {0, 1, 0, -1}, {1, -1, 1, -1}},
                                                    {{1, 0, 0, -1}, {0, 1, -1, 0}, {1, -1, -1, 1}}};
    return std::any_of(std::begin(pairings), std::end(pairings), [this](const auto& p) {
      const auto& [base, opposite, both] = p;
      return (x_vanishes(base) && x_vanishes(opposite) && y_vanishes(both)) ||
             (x_vanishes(both) && y_vanishes(base) && y_vanishes(opposite));
    });
  }

  bool x_vanishes(const Coefficients& coefficients) const {
    Integer sum;
    for (std::size_t c = 0; c < 4; ++c)
      if (coefficients[c] != 0) sum = coefficients[c] > 0 ? sum + x_[c] : sum - x_[c];
    return sum.is_zero();
  }

  // whether it is proven
  bool y_vanishes(const Coefficients& coefficients) const {
    Root_sum sum;
    for (std::size_t c = 0; c < 4; ++c)
      if (coefficients[c] != 0) add_y(c, Integer(coefficients[c]), sum);
    return sum.is_proven_zero();
  }

  // adds |h| y of a corner, over the panels on the way to it
  void add_y(std::size_t corner, const Integer& coefficient, Root_sum& sum) const {
    if (coefficient.is_zero()) return;
    std::uint32_t point = diamond_.point(corner), triangle = diamond_.corners[corner].triangle;
    for (;;) {
      const std::uint32_t p = triangles_[triangle].panel;
      const Panel& panel = panels_[p];
      const Vector v = cross(ruling_, difference(points_[point], points_[panel.base]));
      const int sign = wide_product(triangles_[triangle].normal, v).sign();
      if (sign != 0) sum.add(wide_product(v, v), sign > 0, coefficient);
      if (p == 0) return;
      point = panel.base;
      triangle = panel.parent;
    }
  }

  // in space all distances are there
  bool is_cocircular_in_plane() const {
    const auto length = [this](std::size_t a, std::size_t b) {
      const Vector v = difference(points_[diamond_.point(a)], points_[diamond_.point(b)]);
      return product(v, v);
    };
    const Diamond_values<Integer> d{
        length(0, 1), length(1, 2), length(2, 0), length(0, 3), length(3, 1), 0, 0};
    return integer_diamond_sign(d, recorded(Delaunay_expression())) == ZERO;
  }

  const Unfolded_diamond& diamond_;
  const Points& points_;
  boost::container::small_vector<Placed_triangle, 16> triangles_;
  boost::container::small_vector<Panel, 8> panels_;
  Vector ruling_{};
  std::array<Integer, 4> x_;
  bool is_valid_ = false;
};

// The positions in space of the points of an unfolded diamond.
class Strip_points {
public:
  Strip_points(const Input_metric& input, const Unfolded_diamond& diamond) {
    const auto& triangles = diamond.triangles;
    const Input_metric::Sides& first = input.sides(triangles.front().face);
    add(input.points()[first[0]]);
    add(input.points()[first[1]]);
    for (const Unfolded_diamond::Triangle& t : triangles)
      add(input.points()[input.sides(t.face)[(t.entry + 2) % 3]]);
  }

  int width() const { return range_.width(); }

  template <std::size_t words>
  typename Cylinder_strip<words>::Points integers() const {
    using Integer = Word_integer<words>;
    typename Cylinder_strip<words>::Points result;
    for (const auto& [x, y, z] : points_)
      result.push_back({x.template scaled<Integer>(range_.lowest),
                        y.template scaled<Integer>(range_.lowest),
                        z.template scaled<Integer>(range_.lowest)});
    return result;
  }

private:
  void add(const Input_metric::Point& p) {
    points_.push_back({Binary_double(p[0]), Binary_double(p[1]), Binary_double(p[2])});
    for (const Binary_double& x : points_.back()) range_.include(x);
  }

  boost::container::small_vector<std::array<Binary_double, 3>, 16> points_;
  Bit_range range_;
};

// the value of a predicate of a strip, false if coordinates are too long
template <class Predicate>
bool holds_on_strip(const Input_metric& input, const Unfolded_diamond& diamond,
                    const Predicate& predicate) {
  if (diamond.has_inserted_corners()) return false;
  const Strip_points points(input, diamond);
  const auto holds = [&](const auto& integers, auto words) {
    return predicate(Cylinder_strip<words>(diamond, integers));
  };
  if (points.width() <= 58)
    return holds(points.integers<2>(), std::integral_constant<std::size_t, 2>());
  return points.width() <= 122 &&
         holds(points.integers<4>(), std::integral_constant<std::size_t, 4>());
}

} // namespace internal

/*!
\brief proves that the corners of an unfolded diamond are cocircular, where the triangles lie in one plane,
or are folded along parallel lines and the corners are those of an isosceles trapezoid with sides along
or across them.

Nearly all ties that flips on CAD surfaces make are of this kind: cylinders are made of rectangles there.
\param input the input
\param diamond the triangles
\return true if `Delaunay_expression` is zero, proven; false if nothing is known
\pre triangles are those of space, without mollification; corners are those of two faces, left and right
of an edge, with areas that are not negative
\complexity linear in the number of triangles, about a tenth of a microsecond each
*/
inline bool is_cocircular_strip(const Input_metric& input, const Unfolded_diamond& diamond) {
  return internal::holds_on_strip(input, diamond,
                                  [](const auto& strip) { return strip.is_cocircular(); });
}

/*!
\brief proves that three corners of an unfolded diamond are collinear, where the triangles lie in one plane, or are folded along
parallel lines and points are as far apart across these as they are along them: paths around prisms are straight there.
\param input, diamond see `is_cocircular_strip()`
\param a, b, c corners
\return true if they are collinear, proven; false if nothing is known
\complexity as of `is_cocircular_strip()`
*/
inline bool is_collinear_strip(const Input_metric& input, const Unfolded_diamond& diamond,
                               std::size_t a, std::size_t b, std::size_t c) {
  return internal::holds_on_strip(input, diamond,
                                  [&](const auto& strip) { return strip.is_collinear(a, b, c); });
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_IS_TIE_OF_STRIP_H
