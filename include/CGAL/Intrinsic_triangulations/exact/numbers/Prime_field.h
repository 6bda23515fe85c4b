// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_PRIME_FIELD_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_PRIME_FIELD_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/modular_arithmetic.h>

#include <CGAL/Gmpz.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief computes modulo a prime chosen at run time.

Elements are integers x < p that stand for x / 2^64 modulo p, which makes a product cost three
multiplications and no division (Montgomery, Modular multiplication without trial division, 1985).
*/
class Prime_field {
public:
  /// An element, in Montgomery's form.
  using Element = std::uint64_t;

  /// constructs the field of `p` elements. \pre `p` is an odd prime below 2^62
  explicit Prime_field(std::uint64_t p) : p_(p), negated_inverse_(p) {
    // Newton: p x = 1 modulo 2^n implies p x (2 - p x) = 1 modulo 2^2n; n = 3 for x = p
    for (int i = 0; i < 5; ++i) negated_inverse_ *= 2 - p * negated_inverse_;
    negated_inverse_ = 0 - negated_inverse_;
    one_ = (0 - p) % p; // 2^64 modulo p
    square_ = product_modulo(one_, one_, p);
  }

  /// returns the number of elements.
  std::uint64_t size() const { return p_; }
  /// returns 1.
  Element one() const { return one_; }
  /// returns x + y.
  Element add(Element x, Element y) const { return reduced(x + y); }
  /// returns x - y.
  Element subtract(Element x, Element y) const { return x >= y ? x - y : x + p_ - y; }
  /// returns -x.
  Element negate(Element x) const { return x == 0 ? 0 : p_ - x; }

  /// returns x y.
  Element multiply(Element x, Element y) const {
    __extension__ using Wide = unsigned __int128;
    const Wide t = static_cast<Wide>(x) * y;
    const std::uint64_t q = static_cast<std::uint64_t>(t) * negated_inverse_;
    return reduced(static_cast<std::uint64_t>((t + static_cast<Wide>(q) * p_) >> 64));
  }

  /// returns x^n.
  Element power(Element x, std::uint64_t n) const {
    Element result = one_;
    for (; n != 0; n >>= 1) {
      if (n % 2 != 0) result = multiply(result, x);
      x = multiply(x, x);
    }
    return result;
  }

  /// returns 1 / x. \pre `x` is not zero
  Element inverse(Element x) const { return power(x, p_ - 2); }

  /// returns a square root of x, or of -x where x has none: then `true`. \pre p is 3 modulo 4
  std::pair<Element, bool> root(Element x) const {
    const Element r = power(x, (p_ + 1) / 4);
    return {r, multiply(r, r) != x};
  }

  /// returns the residue of an integer.
  Element element(const Gmpz& n) const {
    static_assert(GMP_NUMB_BITS == 64 || GMP_NUMB_BITS == 32);
    const Element radix = GMP_NUMB_BITS == 64 ? square_ : multiply(std::uint64_t(1) << 32, square_);
    Element result = 0;
    for (std::size_t i = mpz_size(n.mpz()); i-- > 0;) {
      const std::uint64_t limb = mpz_getlimbn(n.mpz(), static_cast<mp_size_t>(i));
      // a product of any word and an element is reduced correctly: it is below 2^64 p
      result = add(multiply(result, radix), multiply(limb, square_));
    }
    return n.sign() == NEGATIVE ? negate(result) : result;
  }

private:
  Element reduced(std::uint64_t x) const { return x >= p_ ? x - p_ : x; }

  std::uint64_t p_;
  std::uint64_t negated_inverse_; // -1 / p modulo 2^64
  Element one_;                   // 2^64 modulo p
  Element square_;                // 2^128 modulo p
};

/*!
\brief lists the fields of the largest primes below 2^62 that are 3 modulo 4, found when asked for.
*/
class Prime_fields {
public:
  /// Lower bound of the binary logarithm of the first million primes.
  static constexpr double bits = 61.99;

  /// returns field number `i`; references stay valid.
  const Prime_field& operator[](std::size_t i) {
    while (fields_.size() <= i) {
      std::uint64_t p =
          (std::uint64_t(1) << 62) - offsets[std::min(fields_.size(), offsets.size() - 1)];
      if (fields_.size() >= offsets.size())
        for (p = fields_.back().size() - 4; !is_prime(p);) p -= 4;
      fields_.emplace_back(p);
    }
    return fields_[i];
  }

private:
  // 2^62 - p for the first of these primes p: finding one takes longer than working in its field
  static constexpr std::array<std::uint64_t, 40> offsets{
      57,   117,  153,  273,  317,  581,  633,  765,  773,  777,  813,  981,  993,  1001,
      1017, 1197, 1241, 1293, 1353, 1433, 1553, 1581, 1617, 1673, 1697, 1701, 1881, 2073,
      2141, 2217, 2285, 2397, 2421, 2541, 2661, 2753, 2777, 2793, 2861, 3041};

  std::deque<Prime_field> fields_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_PRIME_FIELD_H
