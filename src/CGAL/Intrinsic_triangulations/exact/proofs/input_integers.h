// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_INPUT_INTEGERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_INPUT_INTEGERS_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Word_integer.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/Question.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/Rung.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/enum.h>
#include <CGAL/int.h>
#include <CGAL/number_utils.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The usual expressions as they are written: steps would take half as long again, and most ties are
// decided here.
template <class Integer>
Integer evaluate(const Recorded_diamond_expression& expression, const Diamond_values<Integer>& d) {
  switch (expression.zero_meaning()) {
  case Zero_meaning::cocircular:
    return Delaunay_expression()(d);
  case Zero_meaning::collinear_at_source:
    return Convexity_at_source_expression()(d);
  case Zero_meaning::collinear_at_target:
    return Convexity_at_target_expression()(d);
  default:
    return expression(d);
  }
}

/*
The sign of an expression that is linear in the areas, A a_f + B a_g, from integer squared lengths.
It follows from the signs of A and B if they agree, else from that of A^2 D_f - B^2 D_g.
Coefficients are sums of at most 16 squared lengths; squared lengths must be below 2^(b - 6) for
integers of b bits.
*/
template <class Integer>
Sign integer_diamond_sign(Diamond_values<Integer> d,
                          const Recorded_diamond_expression& expression) {
  d.area_f = 1, d.area_g = 0;
  const Integer a = evaluate(expression, d);
  d.area_f = 0, d.area_g = 1;
  const Integer b = evaluate(expression, d);
  if (a.is_zero() && b.is_zero()) return ZERO; // two right angles
  const auto squared_area = [](const Integer& ij, const Integer& jk, const Integer& ki) {
    const Integer p = (ij + ki - jk).magnitude(); // D = 4 L_ij L_ki - p^2
    return full_product(ij + ij, ki + ki) - full_product(p, p);
  };
  const auto left = squared_area(d.ij, d.jk, d.ki);
  const auto right = squared_area(d.ij, d.mj, d.im);
  const int sign_a = left.is_zero() ? 0 : a.sign(), sign_b = right.is_zero() ? 0 : b.sign();
  if (sign_a == sign_b || sign_b == 0) return CGAL::sign(sign_a);
  if (sign_a == 0) return CGAL::sign(sign_b);
  const Integer m = a.magnitude(), n = b.magnitude();
  const auto x = full_product(full_product(m, m), left),
             y = full_product(full_product(n, n), right);
  return x == y ? ZERO : CGAL::sign(is_less(y, x) ? sign_a : sign_b);
}

// The four corners i, j, k, m of a diamond of input faces.
class Corners {
public:
  Corners(const Input_metric& input, const Input_diamond& d) : delta_(input.delta()) {
    const auto& [left, right] = d;
    const Input_metric::Sides &f = input.sides(left.face), &g = input.sides(right.face);
    const std::uint32_t corner[4] = {f[left.slot], f[(left.slot + 1) % 3], f[(left.slot + 2) % 3],
                                     g[(right.slot + 2) % 3]};
    for (const std::uint32_t v : corner)
      for (const double x : input.points()[v]) {
        coordinates_.emplace_back(x);
        range_.include(coordinates_.back());
      }
    include_square(delta_);
    const unsigned l = left.slot, r = right.slot;
    for (const double x :
         {input.excess(left.face, l), input.excess(left.face, (l + 1) % 3),
          input.excess(left.face, (l + 2) % 3), input.excess(right.face, (r + 1) % 3),
          input.excess(right.face, (r + 2) % 3)}) {
      excess_.emplace_back(x);
      include_square(excess_.back());
    }
  }

  int width() const { return range_.width(); }

  template <class Length>
  Diamond_values<Length> lengths() const {
    Length p[4][3];
    for (unsigned c = 0; c < 12; ++c)
      p[c / 3][c % 3] = coordinates_[c].template scaled<Length>(range_.lowest);
    const Length delta = delta_.scaled<Length>(2 * range_.lowest);
    const auto length = [&](int a, int b, std::size_t side) {
      const Length x = p[a][0] - p[b][0], y = p[a][1] - p[b][1], z = p[a][2] - p[b][2];
      return x * x + y * y + z * z + delta + excess_[side].scaled<Length>(2 * range_.lowest);
    };
    return {
        length(0, 1, 0), length(1, 2, 1), length(2, 0, 2), length(0, 3, 3), length(3, 1, 4), 0, 0};
  }

private:
  void include_square(const Binary_double& x) {
    if (x.mantissa == 0) return;
    range_.lowest = std::min(range_.lowest, (x.exponent - 1) / 2 - 1);
    range_.highest = std::max(range_.highest, (x.exponent + 53) / 2 + 1);
  }

  boost::container::static_vector<Binary_double, 12> coordinates_;
  Binary_double delta_;
  boost::container::static_vector<Binary_double, 5> excess_; // ij, jk, ki, im, mj
  Bit_range range_;
};

// The five sides of a diamond of input faces with given squared lengths.
class Side_lengths {
public:
  Side_lengths(const Input_metric& input, const Input_diamond& d) : delta_(input.delta()) {
    const auto& [left, right] = d;
    const Input_metric::Sides &f = input.sides(left.face), &g = input.sides(right.face);
    for (const std::uint32_t e : {f[left.slot], f[(left.slot + 1) % 3], f[(left.slot + 2) % 3],
                                  g[(right.slot + 1) % 3], g[(right.slot + 2) % 3]}) {
      lengths_.emplace_back(input.squared_lengths()[e]);
      range_.include(lengths_.back());
    }
    range_.include(delta_);
  }

  // half the bits, as for coordinates
  int width() const { return (range_.width() + 1) / 2; }

  template <class Length>
  Diamond_values<Length> lengths() const {
    const auto length = [&](std::size_t i) {
      return lengths_[i].template scaled<Length>(range_.lowest) +
             delta_.scaled<Length>(range_.lowest);
    };
    return {length(0), length(1), length(2), length(3), length(4), 0, 0};
  }

private:
  boost::container::static_vector<Binary_double, 5> lengths_;
  Binary_double delta_;
  Bit_range range_;
};

// Coordinates of w bits have squared lengths below 2^(2w + 4), and 2w + 4 <= b - 6 for b bits.
template <class Source>
Answer integer_diamond_sign(const Source& source, const Recorded_diamond_expression& expression) {
  if (source.width() <= 58)
    return to_answer(integer_diamond_sign(source.template lengths<Word_integer<2>>(), expression));
  if (source.width() <= 122)
    return to_answer(integer_diamond_sign(source.template lengths<Word_integer<4>>(), expression));
  return Answer::open;
}

} // namespace internal

/*!
\brief decides signs of expressions in two faces of the input, in integers of fixed size, if they
are linear in the areas and coordinates spread over no more than 122 bits.

Nearly all ties on real meshes are of this kind: quadrilaterals of CAD surfaces that were cut along
a diagonal. Constant time, a third of a microsecond.
*/
struct Input_integers_proof {
  static constexpr Rung rung = Rung::integers;
  /// returns the sign.
  Answer operator()(const Question<Input_diamond, Recorded_diamond_expression>& q) const {
    if (!q.expression.is_linear_in_areas()) return Answer::open;
    if (q.input.is_embedded())
      return internal::integer_diamond_sign(internal::Corners(q.input, q.figure), q.expression);
    return internal::integer_diamond_sign(internal::Side_lengths(q.input, q.figure), q.expression);
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_INPUT_INTEGERS_H
