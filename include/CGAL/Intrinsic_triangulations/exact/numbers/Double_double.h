// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_DOUBLE_DOUBLE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_DOUBLE_DOUBLE_H

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <boost/config.hpp>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a sum of two doubles, about 106 bits.

The relative error of each operation is below 2^-102 where nothing overflows or underflows and
rounding is to the nearest: Joldes, Muller, Popescu, "Tight and rigorous error bounds for basic
building blocks of double-word arithmetic" (2017), Lefevre et al., "Accurate calculation of
Euclidean norms using double-word arithmetic" (2022).
*/
class Double_double {
public:
  /// Number type of errors.
  using Magnitude = double;
  /// returns more than the relative error of each operation.
  static constexpr double rounding() { return 0x1p-102; }

  /// constructs zero.
  Double_double() = default;
  /// converts a number exactly.
  Double_double(double x) : high_(x) {} // NOLINT(google-explicit-constructor)

  /// returns the nearest double.
  double to_double() const { return high_; }
  /// returns a number near this one.
  Magnitude magnitude() const { return high_; }

  /// returns the product of two doubles, exactly unless it underflows.
  static Double_double product(double a, double b) { return two_product(a, b); }
  /// returns the difference of two doubles, exactly.
  static Double_double difference(double a, double b) { return two_sum(a, -b); }
  /// tells whether the number is a double.
  bool is_double() const { return low_ == 0; }

  /// returns a + b faster, with an error below 2^-104 (|a| + |b|).
  BOOST_FORCEINLINE static Double_double rough_sum(const Double_double& a, const Double_double& b) {
    const Double_double s = two_sum(a.high_, b.high_);
    return fast_two_sum(s.high_, s.low_ + (a.low_ + b.low_));
  }
  /// returns the product with a power of two, exactly unless it underflows.
  Double_double scaled(double power) const { return {power * high_, power * low_}; }

  /// tells whether two sums are the same.
  friend bool operator==(const Double_double&, const Double_double&) = default;
  /// returns the negative.
  BOOST_FORCEINLINE friend Double_double operator-(const Double_double& a) {
    return {-a.high_, -a.low_};
  }
  /// returns the sum.
  BOOST_FORCEINLINE friend Double_double operator+(const Double_double& a, const Double_double& b) {
    const Double_double s = two_sum(a.high_, b.high_), t = two_sum(a.low_, b.low_);
    const Double_double v = fast_two_sum(s.high_, s.low_ + t.high_);
    return fast_two_sum(v.high_, t.low_ + v.low_);
  }
  /// returns the difference.
  BOOST_FORCEINLINE friend Double_double operator-(const Double_double& a, const Double_double& b) {
    return a + -b;
  }
  /// returns the product.
  BOOST_FORCEINLINE friend Double_double operator*(const Double_double& a, const Double_double& b) {
    const Double_double p = two_product(a.high_, b.high_);
    return fast_two_sum(p.high_, p.low_ + (a.high_ * b.low_ + a.low_ * b.high_));
  }
  /// returns the quotient.
  BOOST_FORCEINLINE friend Double_double operator/(const Double_double& a, const Double_double& b) {
    const double q = a.high_ / b.high_;
    const Double_double p = two_product(q, b.high_);
    const double rest = (a.high_ - p.high_) - p.low_ + a.low_ - q * b.low_;
    return fast_two_sum(q, rest / b.high_);
  }
  /// returns the square root. \pre `x` is positive
  BOOST_FORCEINLINE friend Double_double sqrt(const Double_double& x) {
    const double s = std::sqrt(x.high_);
    const Double_double p = two_product(s, s);
    const double rest = (x.high_ - p.high_) - p.low_ + x.low_;
    return fast_two_sum(s, rest / (s + s));
  }

private:
  Double_double(double high, double low) : high_(high), low_(low) {}

  // sums and products without error
  BOOST_FORCEINLINE static Double_double two_sum(double a, double b) {
    const double s = a + b, b_part = s - a, a_part = s - b_part;
    return {s, (a - a_part) + (b - b_part)};
  }
  BOOST_FORCEINLINE static Double_double fast_two_sum(double a, double b) { // |a| >= |b| or a = 0
    const double s = a + b;
    return {s, b - (s - a)};
  }
  BOOST_FORCEINLINE static Double_double two_product(double a, double b) {
    const double p = a * b;
    return {p, std::fma(a, b, -p)};
  }

  double high_ = 0, low_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_DOUBLE_DOUBLE_H
