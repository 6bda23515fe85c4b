// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_CONJUGATE_BOUND_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_CONJUGATE_BOUND_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Integer_faces.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>

#include <CGAL/Gmpz.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief bounds an algebraic number: the number times powers of three given integers is an algebraic
integer, and no conjugate of the number is above 2^bits in absolute value.
*/
struct Height {
  double bits;                     ///< binary logarithm of a bound on all conjugates
  std::array<unsigned, 3> degrees; ///< exponents of the integers

  /// bounds a sum.
  friend Height operator+(const Height& a, const Height& b) {
    Height sum{std::max(a.bits, b.bits) + 1, a.degrees};
    for (std::size_t i = 0; i < 3; ++i) sum.degrees[i] = std::max(a.degrees[i], b.degrees[i]);
    return sum;
  }
  /// bounds a difference.
  friend Height operator-(const Height& a, const Height& b) { return a + b; }
  /// bounds a negated number.
  friend Height operator-(const Height& a) { return a; }
  /// bounds a product.
  friend Height operator*(const Height& a, const Height& b) {
    Height product{a.bits + b.bits, a.degrees};
    for (std::size_t i = 0; i < 3; ++i) product.degrees[i] += b.degrees[i];
    return product;
  }
};

/*!
\brief bounds algebraic integers that are multiples of expressions in the values of an unfolded
diamond.

Take the unit in which the points of the triangles used (or, in an abstract metric, their squared
lengths) are integers.

<b>Size.</b> Let s be an automorphism of the field of the positions. It commutes with complex
conjugation, and |z_v - z_t|^2 is rational. Hence |s(z_v) - s(z_t)| = |z_v - z_t| along the sides of
the triangles (s turns some of them over in the plane), and |s(z_v)| is at most the length of a
path.

<b>Denominators.</b> For two sides u, v of one triangle u' v is an algebraic integer: its trace
2 <u, v> = +-(L_u + L_v - L_uv) and its norm L_u L_v are integers. For sides u, v of triangles that
are joined by a strip with hinges h_1, ..., h_n

    u' v = (u' h_1) (h_1' h_2) ... (h_n' v) / (|h_1|^2 ... |h_n|^2),

so that u' v times the product of the squared lengths of the hinges is one. The same holds of the
squared lengths and quadruple areas of figures whose corners the strip joins, sums of such products
(and of them times i). Where triangles in space lie flat over a hinge, u and v are vectors of one
plane, with integer coordinates: the hinge counts as 1. For other hinges in space, h may be divided by
any common divisor of its coordinates: it stays a vector with integer coordinates in both planes. Thus
hinges along an axis count as 1, too.

<b>Vertices that were inserted</b> are convex combinations of the corners of a triangle: s leaves the
weights alone, so that they are no farther away. Where weights are multiples of 2^-e, 2^e times the point
is a combination of these with integer coefficients. So with the largest such e the unit is divided by 2^e,
and what was said holds of the triangles in which they are.

The three integers are the products over the hinges between i and j, and over those that the left
and the right face need besides.
*/
class Conjugate_bound {
public:
  /*!
  \brief prepares the bound.
  \param diamond the triangles
  \param faces the metric of each
  \param in_space whether triangles may lie flat, see `Unfolded_diamond::is_in_space()`
  */
  Conjugate_bound(const Unfolded_diamond& diamond, const std::vector<const Integer_face*>& faces,
                  bool in_space) {
    for (const Integer_face* f : faces) exponent_ = std::max(exponent_, f->exponent);
    find_reach(diamond, faces);
    find_denominators(diamond);
    find_hinges(diamond, faces, in_space);
  }

  /*!
  \brief returns the binary logarithm of a bound on all conjugates of an algebraic integer that is
  the expression times a positive integer.
  \pre the expression is a polynomial whose terms all have the same total degree, since the unit of the values is not that of
  the input
  */
  double bits(const Recorded_diamond_expression& expression) const {
    const double length = 2 * (1 + reach_), area = length + 1;
    const Height h = expression(Diamond_values<Height>{{length, {1, 0, 0}},
                                                       {length, {1, 1, 0}},
                                                       {length, {1, 1, 0}},
                                                       {length, {1, 0, 1}},
                                                       {length, {1, 0, 1}},
                                                       {area, {1, 1, 0}},
                                                       {area, {1, 0, 1}}});
    double result = h.bits;
    for (std::size_t i = 0; i < 3; ++i) result += h.degrees[i] * hinges_[i];
    return result + 1; // for rounding, which is far below
  }

private:
  double bits_of(const Gmpz& n, long exponent) const {
    return static_cast<double>(mpz_sizeinbase(n.mpz(), 2)) +
           2 * static_cast<double>(exponent_ - exponent);
  }

  // of vectors that depend on no unit; often 1
  static double bits_of(const Gmpz& n) {
    return n == Gmpz(1) ? 0 : static_cast<double>(mpz_sizeinbase(n.mpz(), 2));
  }

  // upper bounds of the distances of points from point 0, over all conjugates
  void find_reach(const Unfolded_diamond& diamond, const std::vector<const Integer_face*>& faces) {
    std::vector<double> distance{0, length(*faces.front(), 0)};
    for (std::size_t n = 0; n < faces.size(); ++n) {
      const Unfolded_diamond::Triangle& t = diamond.triangles[n];
      distance.push_back(std::min(distance[t.start()] + length(*faces[n], (t.entry + 2) % 3),
                                  distance[t.end()] + length(*faces[n], (t.entry + 1) % 3)));
    }
    double farthest = 0;
    for (const Unfolded_diamond::Corner& c : diamond.corners)
      for (std::size_t k = 0; k < (c.is_inserted() ? 3U : 1U); ++k)
        farthest = std::max(farthest, distance[diamond.points(c)[k]]);
    reach_ = std::log2(farthest) + static_cast<double>(exponent_);
  }

  // finds the least e for which 2^e times all weights are integers; refines the unit
  void find_denominators(const Unfolded_diamond& diamond) {
    int e = 0;
    for (const Unfolded_diamond::Corner& c : diamond.corners)
      for (const double w : c.weights) e = std::max(e, fractional_bits(w));
    reach_ += e;
  }

  // the least e >= 0 for which 2^e x is an integer
  static int fractional_bits(double x) {
    int e = 0;
    while (x != std::floor(x)) {
      x *= 2;
      ++e;
    }
    return e;
  }

  static double length(const Integer_face& f, unsigned side) {
    long e = 0;
    const double m = mpz_get_d_2exp(&e, f.squared_lengths[side].mpz()); // L = m 2^e, m < 1
    return std::sqrt(std::ldexp(m, static_cast<int>(e - 2 * f.exponent))) + tiny;
  }

  // of the corners of the diamond
  using Flags = std::array<bool, 4>;

  void find_hinges(const Unfolded_diamond& diamond, const std::vector<const Integer_face*>& faces,
                   bool in_space) {
    std::vector<Flags> beyond(faces.size(), Flags{}); // whether a corner is in the subtree
    for (std::size_t c = 0; c < 4; ++c) beyond[diamond.corners[c].triangle][c] = true;
    for (std::size_t n = faces.size(); n-- > 1;) {
      const Unfolded_diamond::Triangle& t = diamond.triangles[n];
      for (std::size_t c = 0; c < 4; ++c) beyond[t.parent][c] = beyond[t.parent][c] || beyond[n][c];
      if (in_space && Integer_faces::are_flat(*faces[n], *faces[t.parent])) continue;
      const auto separates = [&inside = beyond[n]](unsigned set) {
        bool some = false, others = false;
        for (std::size_t c = 0; c < 4; ++c) {
          if ((set >> c) % 2 == 0) continue;
          some = some || inside[c];
          others = others || !inside[c];
        }
        return some && others;
      };
      const double bits = in_space
                              ? bits_of(faces[n]->reduced_lengths[t.entry])
                              : bits_of(faces[n]->squared_lengths[t.entry], faces[n]->exponent);
      if (separates(0b0011)) {
        hinges_[0] += bits;
      } else {
        if (separates(0b0111)) hinges_[1] += bits;
        if (separates(0b1011)) hinges_[2] += bits;
      }
    }
  }

  static constexpr double tiny = 1e-150;

  long exponent_ = std::numeric_limits<long>::min();
  double reach_ = 0; // binary logarithm of a bound on the distance of corners from point 0
  std::array<double, 3> hinges_{0, 0, 0};
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_CONJUGATE_BOUND_H
