// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MPFR_NUMBER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MPFR_NUMBER_H

#include <mpfr.h>

#include <array>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a floating point number by MPFR, whose bits are within it: nothing is allocated.

All operations round to the nearest.
\tparam precision number of bits
*/
template <unsigned precision>
class Mpfr_number {
public:
  /// Number of bits.
  static constexpr unsigned bits = precision;
  /// More than the relative error of each operation: 2^(2 - bits).
  static constexpr double rounding = [] {
    double x = 4;
    for (unsigned n = 0; n < precision; ++n) x /= 2;
    return x;
  }();

  /// constructs zero.
  Mpfr_number() {
    mpfr_custom_init(limbs_.data(), precision);
    mpfr_custom_init_set(value_, MPFR_ZERO_KIND, 0, precision, limbs_.data());
  }
  /// converts a number exactly.
  Mpfr_number(double x) : Mpfr_number() { // NOLINT(google-explicit-constructor)
    mpfr_set_d(value_, x, MPFR_RNDN);
  }
  /// copies.
  Mpfr_number(const Mpfr_number& other) : limbs_(other.limbs_) {
    *value_ = *other.value_;
    mpfr_custom_move(value_, limbs_.data());
  }
  /// copies.
  Mpfr_number& operator=(const Mpfr_number& other) {
    limbs_ = other.limbs_;
    *value_ = *other.value_;
    mpfr_custom_move(value_, limbs_.data());
    return *this;
  }
  ~Mpfr_number() = default;

  /// returns the sum.
  friend Mpfr_number operator+(const Mpfr_number& a, const Mpfr_number& b) {
    Mpfr_number result;
    mpfr_add(result.value_, a.value_, b.value_, MPFR_RNDN);
    return result;
  }
  /// returns the difference.
  friend Mpfr_number operator-(const Mpfr_number& a, const Mpfr_number& b) {
    Mpfr_number result;
    mpfr_sub(result.value_, a.value_, b.value_, MPFR_RNDN);
    return result;
  }
  /// returns the product.
  friend Mpfr_number operator*(const Mpfr_number& a, const Mpfr_number& b) {
    Mpfr_number result;
    mpfr_mul(result.value_, a.value_, b.value_, MPFR_RNDN);
    return result;
  }
  /// returns the quotient.
  friend Mpfr_number operator/(const Mpfr_number& a, const Mpfr_number& b) {
    Mpfr_number result;
    mpfr_div(result.value_, a.value_, b.value_, MPFR_RNDN);
    return result;
  }
  /// returns the square root.
  friend Mpfr_number sqrt(const Mpfr_number& x) {
    Mpfr_number result;
    mpfr_sqrt(result.value_, x.value_, MPFR_RNDN);
    return result;
  }
  /// tells whether the values are equal.
  friend bool operator==(const Mpfr_number& a, const Mpfr_number& b) {
    return mpfr_equal_p(a.value_, b.value_) != 0;
  }

  /// returns the nearest double.
  double to_double() const { return mpfr_get_d(value_, MPFR_RNDN); }

private:
  std::array<mp_limb_t, (precision + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS> limbs_;
  mpfr_t value_; // points to the limbs
};

/// Enough for what is unfolded across some hundred triangles.
using Mpfr_256 = Mpfr_number<256>;
/// As many as a double can tell the errors of.
using Mpfr_1024 = Mpfr_number<1024>;

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MPFR_NUMBER_H
