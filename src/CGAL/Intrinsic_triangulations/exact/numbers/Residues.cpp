// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/numbers/Residues.h>

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Gmpz.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

// The primes that are 3 modulo 4, downwards from 2^61. GMP's test is proven for numbers of 64 bits.
std::uint64_t residue_prime(std::size_t n) {
  thread_local std::vector<std::uint64_t> primes;
  while (primes.size() <= n) {
    std::uint64_t p = (primes.empty() ? (std::uint64_t(1) << 61U) + 3 : primes.back()) - 4;
    while (mpz_probab_prime_p(Gmpz(static_cast<unsigned long>(p)).mpz(), 24) == 0) p -= 4;
    primes.push_back(p);
  }
  return primes[n];
}

} // namespace

} // namespace internal

std::uint64_t Residues::Prime::power(std::uint64_t a, std::uint64_t exponent) const {
  std::uint64_t result = one;
  for (; exponent != 0; exponent >>= 1U) {
    if ((exponent & 1U) != 0) result = product(result, a);
    a = product(a, a);
  }
  return result;
}

Residues::Residues(double x) {
  if (x == 0) return;
  int exponent = 0;
  const double part = std::ldexp(std::frexp(std::abs(x), &exponent), 53); // an integer
  const auto integer = static_cast<std::uint64_t>(part);
  exponent -= 53;
  for (std::size_t n = 0; n < count; ++n) {
    const Prime& p = fields().primes[n];
    const std::uint64_t base = exponent >= 0       ? p.reduced(p.one + p.one)
                               : (p.one & 1U) == 0 ? p.one / 2
                                                   : (p.one + p.value) / 2;
    const std::uint64_t value =
        p.product(p.product(integer, p.square),
                  p.power(base, static_cast<std::uint64_t>(std::abs(exponent))));
    in_[n].first = x < 0 && value != 0 ? p.value - value : value;
  }
}

Residues::Residues(const Gmpz& number) {
  for (std::size_t n = 0; n < count; ++n) {
    const Prime& p = fields().primes[n];
    in_[n].first = p.product(mpz_fdiv_ui(number.mpz(), p.value), p.square);
  }
}

// -1 has no root modulo p: n or -n has one
Residues Residues::sqrt_of(const Gmpz& number) {
  Residues result(number);
  for (std::size_t n = 0; n < count; ++n) {
    const Prime& p = fields().primes[n];
    auto& [real, imaginary] = result.in_[n];
    const std::uint64_t root = p.power(real, (p.value + 1) / 4);
    if (p.product(root, root) == real) {
      real = root;
    } else {
      real = 0;
      imaginary = root;
    }
  }
  return result;
}

bool Residues::is_zero() const {
  return std::all_of(in_.begin(), in_.end(), [](const Pair& x) { return x == Pair(0, 0); });
}
bool Residues::has_zero() const {
  return std::any_of(in_.begin(), in_.end(), [](const Pair& x) { return x == Pair(0, 0); });
}

Residues Residues::inverse() const {
  if (has_zero()) fields().are_defined = false;
  Residues result;
  for (std::size_t n = 0; n < count; ++n) {
    const Prime& p = fields().primes[n];
    const auto& [a, b] = in_[n];
    const std::uint64_t norm = p.reduced(p.product(a, a) + p.product(b, b)),
                        inverse = p.power(norm, p.value - 2);
    result.in_[n] = {p.product(a, inverse), p.product(p.reduced(p.value - b), inverse)};
  }
  return result;
}

Residue_fields::Residue_fields(std::size_t n) : before_(Residues::fields()) {
  Residues::Fields& all = Residues::fields();
  all.are_defined = true;
  for (std::size_t k = 0; k < Residues::count; ++k) {
    Residues::Prime& p = all.primes[k];
    p.value = internal::residue_prime(Residues::count * n + k);
    std::uint64_t inverse = 1; // Newton's method doubles the right digits
    for (int i = 0; i < 6; ++i) inverse *= 2 - p.value * inverse;
    p.negative_inverse = 0 - inverse;
    p.one = static_cast<std::uint64_t>((Residues::Wide(1) << 64U) % p.value);
    p.square = static_cast<std::uint64_t>(Residues::Wide(p.one) * p.one % p.value);
  }
}

} // namespace CGAL::Intrinsic_triangulations
