// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_WORD_INTEGER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_WORD_INTEGER_H

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is an integer modulo 2^(64 n) in n words, read as a signed number in two's complement.

It has no length, sign or branches, which makes it several times faster than an integer of variable
length for the few hundred bits of ties between input faces. The caller prevents overflow.
\tparam n number of words
*/
template <std::size_t n>
class Word_integer {
public:
  /// constructs zero.
  constexpr Word_integer() = default;
  /// converts an integer.
  constexpr Word_integer(std::int64_t x) { // implicit, as for built-in integers
    words_.fill(x < 0 ? ~std::uint64_t(0) : 0);
    words_[0] = static_cast<std::uint64_t>(x);
  }

  /// converts an integer of fewer words.
  template <std::size_t m>
    requires(m < n)
  explicit constexpr Word_integer(const Word_integer<m>& x) {
    words_.fill(x.is_negative() ? ~std::uint64_t(0) : 0);
    for (std::size_t i = 0; i < m; ++i) words_[i] = x.words_[i];
  }

  /// returns the sign, -1, 0 or 1.
  constexpr int sign() const { return is_negative() ? -1 : is_zero() ? 0 : 1; }
  /// tells whether the number is zero.
  constexpr bool is_zero() const {
    std::uint64_t any = 0;
    for (const std::uint64_t w : words_) any |= w;
    return any == 0;
  }
  /// returns the absolute value.
  constexpr Word_integer magnitude() const {
    return is_negative() ? Word_integer() - *this : *this;
  }

  /// returns the words, the lowest first.
  constexpr const std::array<std::uint64_t, n>& words() const { return words_; }

  /// returns 2^k times the number. \pre `k` < 64 n
  constexpr Word_integer shifted(unsigned k) const {
    Word_integer result;
    const std::size_t whole = k / 64;
    const unsigned part = k % 64;
    for (std::size_t i = whole; i < n; ++i) {
      result.words_[i] = words_[i - whole] << part;
      if (part != 0 && i > whole) result.words_[i] |= words_[i - whole - 1] >> (64 - part);
    }
    return result;
  }

  /// adds, modulo the range.
  friend constexpr Word_integer operator+(const Word_integer& a, const Word_integer& b) {
    Word_integer sum;
    Wide carry = 0;
    for (std::size_t i = 0; i < n; ++i) {
      carry += static_cast<Wide>(a.words_[i]) + b.words_[i];
      sum.words_[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return sum;
  }
  /// subtracts, modulo the range.
  friend constexpr Word_integer operator-(const Word_integer& a, const Word_integer& b) {
    Word_integer difference;
    Wide borrow = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Wide d = static_cast<Wide>(a.words_[i]) - b.words_[i] - borrow;
      difference.words_[i] = static_cast<std::uint64_t>(d);
      borrow = d >> 127;
    }
    return difference;
  }
  /// negates, modulo the range.
  friend constexpr Word_integer operator-(const Word_integer& a) { return Word_integer() - a; }
  /// multiplies, modulo the range.
  friend constexpr Word_integer operator*(const Word_integer& a, const Word_integer& b) {
    Word_integer product;
    for (std::size_t i = 0; i < n; ++i) product.add_multiple(a.words_[i], b, i, n);
    return product;
  }
  /// compares all words.
  friend constexpr bool operator==(const Word_integer& a, const Word_integer& b) = default;

  /*!
  \brief returns the product in twice as many words.
  \pre neither number is negative
  */
  friend constexpr Word_integer<2 * n> full_product(const Word_integer& a, const Word_integer& b) {
    return a.times(b);
  }

  /// tells whether `a` is less than `b`. \pre neither number is negative
  friend constexpr bool is_less(const Word_integer& a, const Word_integer& b) {
    for (std::size_t i = n; i-- > 0;)
      if (a.words_[i] != b.words_[i]) return a.words_[i] < b.words_[i];
    return false;
  }

private:
  template <std::size_t>
  friend class Word_integer;
  __extension__ using Wide = unsigned __int128;

  constexpr bool is_negative() const { return words_[n - 1] >> 63 != 0; }

  constexpr Word_integer<2 * n> times(const Word_integer& b) const {
    Word_integer<2 * n> product;
    for (std::size_t i = 0; i < n; ++i) product.add_multiple(words_[i], b, i, 2 * n);
    return product;
  }

  // adds x b 2^(64 shift), up to word `end`
  template <std::size_t m>
  constexpr void add_multiple(std::uint64_t x, const Word_integer<m>& b, std::size_t shift,
                              std::size_t end) {
    Wide carry = 0;
    std::size_t j = shift;
    for (std::size_t k = 0; k < m && j < end; ++k, ++j) {
      carry += static_cast<Wide>(x) * b.words_[k] + words_[j];
      words_[j] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    if (j < end) words_[j] = static_cast<std::uint64_t>(carry);
  }

  std::array<std::uint64_t, n> words_{};
};

namespace internal {

// A finite double as an integer times a power of two.
struct Binary_double {
  std::int64_t mantissa;
  int exponent;

  explicit Binary_double(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const int biased = static_cast<int>(bits >> 52 & 0x7ffU);
    const auto fraction = static_cast<std::int64_t>(bits & 0xfffffffffffffULL);
    mantissa = biased == 0 ? fraction : fraction | std::int64_t{1} << 52;
    exponent = (biased == 0 ? 1 : biased) - 1075;
    const int zeros = mantissa == 0 ? 0 : std::countr_zero(static_cast<std::uint64_t>(mantissa));
    mantissa >>= zeros;
    exponent += zeros;
    if (bits >> 63 != 0) mantissa = -mantissa;
  }

  // the value / 2^e, for e <= exponent
  template <class Integer>
  Integer scaled(int e) const {
    return mantissa == 0 ? Integer(0)
                         : Integer(mantissa).shifted(static_cast<unsigned>(exponent - e));
  }
};

// The range of bits that some doubles occupy.
struct Bit_range {
  int lowest = std::numeric_limits<int>::max() / 4;
  int highest = std::numeric_limits<int>::min() / 4;

  void include(const Binary_double& x) {
    if (x.mantissa == 0) return;
    lowest = std::min(lowest, x.exponent);
    highest =
        std::max(highest, x.exponent + static_cast<int>(std::bit_width(
                                           static_cast<std::uint64_t>(std::abs(x.mantissa)))));
  }
  int width() const { return highest - lowest; }
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_WORD_INTEGER_H
