// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_RESIDUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_RESIDUES_H

#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is the image of a number in some finite fields at once, F_p(i) for a few primes p = 3 modulo
4 below 2^61. Every integer has a square root there.

The primes are those of the `Residue_fields` of the thread. Factors are multiplied as Montgomery,
Modular multiplication without trial division, 1985.
\cgalModels{Field}
*/
class Residues {
public:
  /// Number of fields. Proofs count bits, so it decides on time alone: a value that is not zero
  /// vanishes in all four about once in 2^243, so that one evaluation finds out.
  static constexpr std::size_t count = 4;
  /// Binary logarithm of the least prime.
  static constexpr double bits_of_prime = 60.9;

  /// constructs zero.
  Residues() = default;
  /// converts an integer.
  Residues(int n) : Residues(static_cast<double>(n)) {} // NOLINT(google-explicit-constructor)
  /// converts a finite double, exactly.
  Residues(double x); // NOLINT(google-explicit-constructor)
  /// converts an integer.
  explicit Residues(const Gmpz& n);
  /// converts a rational number; see `inverse()`.
  explicit Residues(const Gmpq& x)
      : Residues(x.denominator() == Gmpz(1) ? Residues(x.numerator())
                                            : Residues(x.numerator()) / Residues(x.denominator())) {
  }
  /// returns a square root of an integer.
  static Residues sqrt_of(const Gmpz& n);

  /// tells whether the number is zero in all fields.
  bool is_zero() const;
  /// tells whether it is zero in one of them.
  bool has_zero() const;
  /// returns the inverse; where there is none, zero, and `Residue_fields::are_defined()` ends.
  Residues inverse() const;

  /// adds.
  friend Residues operator+(const Residues& x, const Residues& y) {
    return each(x, y, [](const Prime& p, const Pair& a, const Pair& b) {
      return Pair{p.reduced(a.first + b.first), p.reduced(a.second + b.second)};
    });
  }
  /// subtracts.
  friend Residues operator-(const Residues& x, const Residues& y) {
    return each(x, y, [](const Prime& p, const Pair& a, const Pair& b) {
      return Pair{p.reduced(a.first + p.value - b.first), p.reduced(a.second + p.value - b.second)};
    });
  }
  /// negates.
  Residues operator-() const { return Residues() - *this; }
  /// multiplies.
  friend Residues operator*(const Residues& x, const Residues& y) {
    return each(x, y, [](const Prime& p, const Pair& a, const Pair& b) { return p.product(a, b); });
  }
  /// divides; see `inverse()`.
  friend Residues operator/(const Residues& x, const Residues& y) { return x * y.inverse(); }
  /// adds `y`.
  Residues& operator+=(const Residues& y) { return *this = *this + y; }
  /// subtracts `y`.
  Residues& operator-=(const Residues& y) { return *this = *this - y; }
  /// multiplies by `y`.
  Residues& operator*=(const Residues& y) { return *this = *this * y; }
  /// divides by `y`.
  Residues& operator/=(const Residues& y) { return *this = *this / y; }

private:
  friend class Residue_fields;
  using Pair = std::pair<std::uint64_t, std::uint64_t>; // real and imaginary part, times 2^64
  __extension__ using Wide = unsigned __int128;

  struct Prime {
    std::uint64_t value = 0;
    std::uint64_t negative_inverse = 0; // of the prime modulo 2^64
    std::uint64_t one = 0, square = 0;  // 2^64 and 2^128

    std::uint64_t reduced(std::uint64_t x) const { return x >= value ? x - value : x; }
    // of x / 2^64, for x below 2^124
    std::uint64_t divided(Wide x) const {
      const std::uint64_t m = static_cast<std::uint64_t>(x) * negative_inverse;
      return reduced(static_cast<std::uint64_t>((x + Wide(m) * value) >> 64U));
    }
    std::uint64_t product(std::uint64_t a, std::uint64_t b) const { return divided(Wide(a) * b); }
    Pair product(const Pair& a, const Pair& b) const {
      return {divided(Wide(a.first) * b.first + Wide(a.second) * (value - b.second)),
              divided(Wide(a.first) * b.second + Wide(a.second) * b.first)};
    }
    std::uint64_t power(std::uint64_t a, std::uint64_t exponent) const;
  };
  struct Fields {
    std::array<Prime, count> primes;
    bool are_defined = true;
  };
  static Fields& fields() {
    thread_local Fields current;
    return current;
  }

  template <class Function>
  static Residues each(const Residues& x, const Residues& y, const Function& f) {
    const Fields& all = fields();
    Residues result;
    for (std::size_t n = 0; n < count; ++n) result.in_[n] = f(all.primes[n], x.in_[n], y.in_[n]);
    return result;
  }

  std::array<Pair, count> in_{};
};

/// sets the fields of the `Residues` of a thread for a lifetime.
class Residue_fields {
public:
  /// sets the fields number `n`; no prime is in two of them.
  explicit Residue_fields(std::size_t n);
  /// restores the fields before.
  ~Residue_fields() { Residues::fields() = before_; }
  Residue_fields(const Residue_fields&) = delete;
  Residue_fields& operator=(const Residue_fields&) = delete;
  /// tells whether nothing was divided by zero.
  static bool are_defined() { return Residues::fields().are_defined; }

private:
  Residues::Fields before_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_RESIDUES_H
