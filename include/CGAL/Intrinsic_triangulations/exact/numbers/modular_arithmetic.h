// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MODULAR_ARITHMETIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MODULAR_ARITHMETIC_H

#include <array>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief returns a b modulo m.
\pre `m` is not zero
*/
constexpr std::uint64_t product_modulo(std::uint64_t a, std::uint64_t b, std::uint64_t m) {
  __extension__ using Wide = unsigned __int128;
  return static_cast<std::uint64_t>(static_cast<Wide>(a) * b % m);
}

/*!
\brief returns base^exponent modulo m.
\pre `m` > 1
\complexity logarithmic in the exponent
*/
constexpr std::uint64_t power_modulo(std::uint64_t base, std::uint64_t exponent, std::uint64_t m) {
  std::uint64_t result = 1;
  for (base %= m; exponent != 0; exponent >>= 1) {
    if (exponent % 2 != 0) result = product_modulo(result, base, m);
    base = product_modulo(base, base, m);
  }
  return result;
}

namespace internal {

inline constexpr std::array<std::uint64_t, 12> prime_bases = {2,  3,  5,  7,  11, 13,
                                                              17, 19, 23, 29, 31, 37};

constexpr bool is_strong_probable_prime(std::uint64_t n, std::uint64_t base) {
  std::uint64_t odd = n - 1;
  int twos = 0;
  for (; odd % 2 == 0; odd /= 2) ++twos;
  std::uint64_t x = power_modulo(base, odd, n);
  if (x == 1 || x == n - 1) return true;
  for (int i = 1; i < twos; ++i) {
    x = product_modulo(x, x, n);
    if (x == n - 1) return true;
  }
  return false;
}

} // namespace internal

/*!
\brief tells whether `n` is a prime number.

The test of Miller and Rabin to the first twelve prime bases, which has no false positive below
3.3e24 (Sorenson and Webster, Strong pseudoprimes to twelve prime bases, Math. Comp. 86, 2017);
below 3.2e9 the first four bases suffice (Jaeschke, On strong pseudoprimes to several bases, Math.
Comp. 61, 1993).
\complexity logarithmic
*/
constexpr bool is_prime(std::uint64_t n) {
  if (n < 2) return false;
  for (const std::uint64_t p : internal::prime_bases) {
    if (n % p == 0) return n == p;
  }
  for (const std::uint64_t p : internal::prime_bases) {
    if (p > 7 && n < 3200000000U) break;
    if (!internal::is_strong_probable_prime(n, p)) return false;
  }
  return true;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MODULAR_ARITHMETIC_H
