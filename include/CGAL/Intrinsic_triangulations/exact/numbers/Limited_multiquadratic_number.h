// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_LIMITED_MULTIQUADRATIC_NUMBER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_LIMITED_MULTIQUADRATIC_NUMBER_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Multiquadratic_number.h>

#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a `Multiquadratic_number`, or unknown if computing it would take too long.

A number of a field of k square roots has up to 2^k terms, but sums of many lengths have few: the
flat picture of a strip of n rectangles has about n^2. Products of more than `maximal_products` pairs
of terms, quotients by more than one term, and all that is computed from them, are unknown.
*/
class Limited_multiquadratic_number {
public:
  /// Largest number of pairs of terms that are multiplied; under a millisecond.
  static constexpr std::size_t maximal_products = 1 << 13;

  /// constructs an integer.
  Limited_multiquadratic_number(int n = 0) : value_(Multiquadratic_number(n)) {}
  /// constructs a rational from a finite double, exactly.
  Limited_multiquadratic_number(double x) : value_(Multiquadratic_number(x)) {}
  /// constructs a known number.
  Limited_multiquadratic_number(Multiquadratic_number value) : value_(std::move(value)) {}

  /// tells whether the value is known, and zero.
  bool is_proven_zero() const { return value_ && value_->is_zero(); }

  /// adds
  friend Limited_multiquadratic_number operator+(const Limited_multiquadratic_number& x,
                                                 const Limited_multiquadratic_number& y) {
    return x.value_ && y.value_ ? known(*x.value_ + *y.value_) : unknown();
  }
  /// subtracts
  friend Limited_multiquadratic_number operator-(const Limited_multiquadratic_number& x,
                                                 const Limited_multiquadratic_number& y) {
    return x.value_ && y.value_ ? known(*x.value_ - *y.value_) : unknown();
  }
  /// multiplies
  friend Limited_multiquadratic_number operator*(const Limited_multiquadratic_number& x,
                                                 const Limited_multiquadratic_number& y) {
    const bool is_short =
        x.value_ && y.value_ &&
        x.value_->number_of_terms() * y.value_->number_of_terms() <= maximal_products;
    return is_short ? known(*x.value_ * *y.value_) : unknown();
  }
  /// divides
  friend Limited_multiquadratic_number operator/(const Limited_multiquadratic_number& x,
                                                 const Limited_multiquadratic_number& y) {
    return x.value_ && y.value_ && y.value_->number_of_terms() == 1 ? known(*x.value_ / *y.value_)
                                                                    : unknown();
  }

private:
  static Limited_multiquadratic_number known(Multiquadratic_number value) { return value; }
  static Limited_multiquadratic_number unknown() {
    Limited_multiquadratic_number result;
    result.value_.reset();
    return result;
  }

  std::optional<Multiquadratic_number> value_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_LIMITED_MULTIQUADRATIC_NUMBER_H
