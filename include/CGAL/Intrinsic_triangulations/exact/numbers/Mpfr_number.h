// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MPFR_NUMBER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MPFR_NUMBER_H

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Gmpq.h>

#include <boost/container/small_vector.hpp>
#include <mpfr.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <limits>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a floating point number by MPFR. Nothing is allocated for up to 1024 bits.

All operations round to the nearest, to as many bits as the `Mpfr_precision` of the thread says; one
class for all of them is compiled once.
*/
class Mpfr_number {
public:
  /// Number type of errors. \note the exponents of `long double` bound the precision
  using Magnitude = long double;
  /// Largest number of bits whose errors it can represent.
  static constexpr unsigned most_bits =
      std::numeric_limits<Magnitude>::max_exponent > 16000 ? 8192 : 512;

  /// returns more than the relative error of each operation: 2^(2 - bits).
  static Magnitude rounding() { return precision().rounding; }

  /// constructs zero.
  Mpfr_number() : limbs_(limbs(precision().bits), boost::container::default_init) {
    const unsigned bits = precision().bits;
    mpfr_custom_init_set(value_, MPFR_ZERO_KIND, 0, bits, limbs_.data());
  }
  /// converts a number exactly.
  Mpfr_number(double x) : Mpfr_number() { // NOLINT(google-explicit-constructor)
    mpfr_set_d(value_, x, MPFR_RNDN);
  }
  /// returns the number nearest to a rational one.
  static Mpfr_number nearest(const Gmpq& x) {
    Mpfr_number result;
    mpfr_set_q(result.value_, x.mpq(), MPFR_RNDN);
    return result;
  }
  /// copies.
  Mpfr_number(const Mpfr_number& other) : limbs_(other.limbs_) { copy_value(other); }
  /// copies.
  Mpfr_number& operator=(const Mpfr_number& other) {
    if (this == &other) return *this;
    limbs_ = other.limbs_;
    copy_value(other);
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
  /// returns a number near this one; slower outside the range of doubles.
  Magnitude magnitude() const {
    const double x = to_double(), size = std::abs(x);
    return size > 0x1p-1000 && size < 0x1p1000 ? x : mpfr_get_ld(value_, MPFR_RNDN);
  }

private:
  friend class Mpfr_precision;
  struct Precision {
    unsigned bits;
    Magnitude rounding;
  };
  // of the thread; enough for what is unfolded across some hundred triangles
  static Precision& precision() {
    thread_local Precision current{256, 0x1p-254L};
    return current;
  }

  static std::size_t limbs(std::size_t bits) { return (bits + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS; }

  void copy_value(const Mpfr_number& other) {
    *value_ = *other.value_;
    mpfr_custom_move(value_, limbs_.data());
  }

  boost::container::small_vector<mp_limb_t, 16> limbs_;
  mpfr_t value_; // points to the limbs
};

/// sets the precision of new `Mpfr_number`s of a thread for a lifetime; it is 256 bits elsewhere.
class Mpfr_precision {
public:
  /// sets the precision, to `Mpfr_number::most_bits` at most.
  explicit Mpfr_precision(unsigned bits) : previous_(Mpfr_number::precision()) {
    bits = std::min(bits, Mpfr_number::most_bits);
    Mpfr_number::precision() = {bits, std::ldexp(4.0L, -static_cast<int>(bits))};
  }
  /// restores the precision.
  ~Mpfr_precision() { Mpfr_number::precision() = previous_; }
  Mpfr_precision(const Mpfr_precision&) = delete;
  Mpfr_precision& operator=(const Mpfr_precision&) = delete;

private:
  Mpfr_number::Precision previous_;
};

/*!
\brief computes in more and more bits: 53 (doubles), 106 (pairs of doubles), 256, 512, 1024, ...
\param first, last the least and the greatest number of bits
\param is_done a functor that computes in a number of bits, and tells whether that was enough
\return whether it was
*/
template <std::predicate<unsigned> Is_done>
constexpr bool raise_precision(unsigned first, unsigned last, const Is_done& is_done) {
  for (unsigned bits = first; bits <= last; bits = bits < 106 ? 106 : bits < 256 ? 256 : 2 * bits)
    if (is_done(bits)) return true;
  return false;
}

/// does the same for enclosures that have to be narrow. These skip 512 bits, so that one step less
/// leads to a face that is too thin for 256.
/// \param first, last, is_done see `raise_precision()`
/// \return whether the bits were enough
template <std::predicate<unsigned> Is_done>
constexpr bool narrow_enclosures(unsigned first, unsigned last, const Is_done& is_done) {
  return raise_precision(first, last, [&](unsigned bits) { return bits != 512 && is_done(bits); });
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MPFR_NUMBER_H
