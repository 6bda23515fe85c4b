// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_CONJUGATE_BOUND_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_CONJUGATE_BOUND_H

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <stdexcept>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief bounds an algebraic number x, and all of its conjugates: d^e 2^t x is an algebraic integer,
and no conjugate of x exceeds 2^b. All numbers of a computation share d, a positive integer.

If x is not zero, the norm of d^e 2^t x is an integer that is not zero: that is what separates x
from zero (Burnikel, Funke, Mehlhorn, Schirra, A separation bound for real algebraic expressions,
2009, with one denominator in place of many).
\cgalModels{FieldNumber}
*/
class Conjugate_bound {
public:
  /// bounds zero.
  Conjugate_bound() = default;
  /// bounds a finite double.
  Conjugate_bound(double x) { // NOLINT(google-explicit-constructor)
    if (x == 0) return;
    int exponent = 0;
    const double part = std::ldexp(std::frexp(std::abs(x), &exponent), 53); // an integer
    twos_ = 53 - exponent - std::countr_zero(static_cast<std::uint64_t>(part));
    bits_ = exponent;
  }
  /// bounds a number by e, t and b.
  Conjugate_bound(unsigned denominators, int twos, double bits)
      : denominators_(denominators), twos_(twos), bits_(bits) {}

  /// returns b, for d^e 2^t x in place of x. \param bits_of_denominator binary logarithm of d
  double bits_of_integer(double bits_of_denominator) const {
    return denominators_ * bits_of_denominator + twos_ + bits_;
  }

  /// adds.
  friend Conjugate_bound operator+(const Conjugate_bound& x, const Conjugate_bound& y) {
    return {std::max(x.denominators_, y.denominators_), std::max(x.twos_, y.twos_),
            std::max(x.bits_, y.bits_) + 1};
  }
  /// subtracts.
  friend Conjugate_bound operator-(const Conjugate_bound& x, const Conjugate_bound& y) {
    return x + y;
  }
  /// negates.
  Conjugate_bound operator-() const { return *this; }
  /// multiplies.
  friend Conjugate_bound operator*(const Conjugate_bound& x, const Conjugate_bound& y) {
    return {x.denominators_ + y.denominators_, x.twos_ + y.twos_, x.bits_ + y.bits_};
  }
  /// \throws std::length_error nothing is known of a quotient
  friend Conjugate_bound operator/(const Conjugate_bound&, const Conjugate_bound&) {
    throw std::length_error("a quotient has no bound");
  }

private:
  unsigned denominators_ = 0;
  int twos_ = 0;
  double bits_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_CONJUGATE_BOUND_H
