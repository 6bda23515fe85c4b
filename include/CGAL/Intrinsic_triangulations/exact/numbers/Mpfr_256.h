// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MPFR_256_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MPFR_256_H

#include <mpfr.h>

#include <array>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a floating point number of 256 bits by MPFR, whose bits are within it: nothing is allocated.

All operations round to the nearest.
*/
class Mpfr_256 {
public:
  /// constructs zero.
  Mpfr_256() {
    mpfr_custom_init(limbs_.data(), precision);
    mpfr_custom_init_set(value_, MPFR_ZERO_KIND, 0, precision, limbs_.data());
  }
  /// converts a number exactly.
  Mpfr_256(double x) : Mpfr_256() { // NOLINT(google-explicit-constructor)
    mpfr_set_d(value_, x, MPFR_RNDN);
  }
  /// copies.
  Mpfr_256(const Mpfr_256& other) : limbs_(other.limbs_) {
    *value_ = *other.value_;
    mpfr_custom_move(value_, limbs_.data());
  }
  /// copies.
  Mpfr_256& operator=(const Mpfr_256& other) {
    limbs_ = other.limbs_;
    *value_ = *other.value_;
    mpfr_custom_move(value_, limbs_.data());
    return *this;
  }
  ~Mpfr_256() = default;

  /// returns the sum.
  friend Mpfr_256 operator+(const Mpfr_256& a, const Mpfr_256& b) {
    Mpfr_256 result;
    mpfr_add(result.value_, a.value_, b.value_, MPFR_RNDN);
    return result;
  }
  /// returns the difference.
  friend Mpfr_256 operator-(const Mpfr_256& a, const Mpfr_256& b) {
    Mpfr_256 result;
    mpfr_sub(result.value_, a.value_, b.value_, MPFR_RNDN);
    return result;
  }
  /// returns the product.
  friend Mpfr_256 operator*(const Mpfr_256& a, const Mpfr_256& b) {
    Mpfr_256 result;
    mpfr_mul(result.value_, a.value_, b.value_, MPFR_RNDN);
    return result;
  }
  /// returns the quotient.
  friend Mpfr_256 operator/(const Mpfr_256& a, const Mpfr_256& b) {
    Mpfr_256 result;
    mpfr_div(result.value_, a.value_, b.value_, MPFR_RNDN);
    return result;
  }
  /// returns the square root.
  friend Mpfr_256 sqrt(const Mpfr_256& x) {
    Mpfr_256 result;
    mpfr_sqrt(result.value_, x.value_, MPFR_RNDN);
    return result;
  }
  /// tells whether the values are equal.
  friend bool operator==(const Mpfr_256& a, const Mpfr_256& b) {
    return mpfr_equal_p(a.value_, b.value_) != 0;
  }

  /// returns the nearest double.
  double to_double() const { return mpfr_get_d(value_, MPFR_RNDN); }

private:
  static constexpr mpfr_prec_t precision = 256;

  std::array<mp_limb_t, (precision + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS> limbs_;
  mpfr_t value_; // points to the limbs
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MPFR_256_H
