// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

// returns n and c with sqrt(x) = c sqrt(n)
std::pair<Gmpz, Gmpq> to_integer(const Gmpq& x) {
  Gmpz n = x.numerator(), m = x.denominator();
  const Gmpz a = Square_class_basis::extract_square(n), b = Square_class_basis::extract_square(m);
  return {n * m, Gmpq(a, b * m)};
}

Gmpz sqrt_of_square(const Gmpz& n) {
  Gmpz root;
  mpz_sqrt(root.mpz(), n.mpz());
  return root;
}

// tells whether chi_p(n) = -1
bool is_negative_symbol(const Gmpz& n, unsigned long p) {
  const int symbol = mpz_kronecker_ui(n.mpz(), p);
  if (symbol != 0) return symbol < 0;
  const Gmpz factor(p);
  Gmpz rest;
  mpz_remove(rest.mpz(), n.mpz(), factor.mpz());
  return mpz_kronecker_ui(rest.mpz(), p) < 0;
}

// standard functions on bits take one word
std::size_t lowest_bit(Square_class_basis::Mask m) {
  const auto low = static_cast<std::uint64_t>(m);
  return static_cast<std::size_t>(
      low != 0 ? std::countr_zero(low)
               : 64 + std::countr_zero(static_cast<std::uint64_t>(m >> 64U)));
}

bool has_odd_size(Square_class_basis::Mask m) {
  return std::popcount(static_cast<std::uint64_t>(m ^ m >> 64U)) % 2 != 0;
}

unsigned long next_prime(unsigned long p) {
  const Gmpz n(p);
  Gmpz next;
  mpz_nextprime(next.mpz(), n.mpz());
  return mpz_get_ui(next.mpz());
}

// odd primes below 2^32; half of them have a given symbol, so that a full basis needs about 256
unsigned long prime_after(unsigned long p) {
  static const auto primes = [] {
    std::array<unsigned long, 320> list{};
    unsigned long q = 1UL << 30;
    for (unsigned long& x : list) x = q = next_prime(q);
    return list;
  }();
  const auto found = std::upper_bound(primes.begin(), primes.end(), p);
  return found == primes.end() ? next_prime(p) : *found;
}

} // namespace

} // namespace internal

std::optional<Square_root> Square_class_basis::sqrt_of(const Gmpq& x) {
  CGAL_precondition(x.sign() != NEGATIVE);
  if (x.sign() == ZERO) return Square_root{};
  auto [n, factor] = internal::to_integer(x);
  std::optional<Square_root> root = sqrt_of(n);
  if (root) root->factor *= factor;
  return root;
}

std::optional<Square_root> Square_class_basis::sqrt_of(const Gmpz& n) {
  if (n == one_) return Square_root{Gmpq(1), 0};
  for (std::size_t i = 0; i < dimension(); ++i)
    if (generators_[i].d == n) return Square_root{Gmpq(1), Mask(1) << i};
  const Mask candidate = find_candidate(n);
  const Gmpz square = n * product(candidate);
  if (mpz_perfect_square_p(square.mpz()) != 0)
    return Square_root{Gmpq(internal::sqrt_of_square(square), product(candidate)), candidate};
  if (dimension() == max_dimension) return std::nullopt;
  append(n, candidate, square);
  return Square_root{Gmpq(1), Mask(1) << (dimension() - 1)};
}

Gmpz Square_class_basis::extract_square(Gmpz& n) {
  if (mpz_perfect_square_p(n.mpz()) != 0)
    return internal::sqrt_of_square(std::exchange(n, Gmpz(1)));
  const unsigned long twos = mpz_scan1(n.mpz(), 0) / 2;
  Gmpz rest, root(1);
  mpz_fdiv_q_2exp(rest.mpz(), n.mpz(), 2 * twos);
  mpz_mul_2exp(root.mpz(), root.mpz(), twos);
  for (const unsigned long p : {3UL, 5UL, 7UL, 11UL, 13UL, 17UL, 19UL, 23UL, 29UL, 31UL})
    while (mpz_divisible_ui_p(rest.mpz(), p * p) != 0) {
      mpz_divexact_ui(rest.mpz(), rest.mpz(), p * p);
      mpz_mul_ui(root.mpz(), root.mpz(), p);
    }
  n = rest;
  return root;
}

const Gmpz& Square_class_basis::product(Mask mask) const {
  if (mask == 0) return one_;
  if ((mask & (mask - 1)) == 0) return generators_[internal::lowest_bit(mask)].d;
  const auto found = products_.find(mask);
  if (found != products_.end()) return found->second;
  Gmpz p(1);
  for (Mask rest = mask; rest != 0; rest &= rest - 1)
    p *= generators_[internal::lowest_bit(rest)].d;
  return products_.emplace(mask, p).first->second;
}

Square_class_basis::Mask Square_class_basis::find_candidate(const Gmpz& n) const {
  Mask symbols = 0, candidate = 0;
  for (std::size_t i = 0; i < dimension(); ++i)
    if (internal::is_negative_symbol(n, generators_[i].prime)) symbols |= Mask(1) << i;
  for (std::size_t i = 0; i < dimension(); ++i)
    if ((symbols >> i & 1) != 0) {
      symbols ^= generators_[i].symbols;
      candidate ^= generators_[i].e_of;
    }
  CGAL_postcondition(symbols == 0);
  return candidate;
}

void Square_class_basis::append(const Gmpz& n, Mask candidate, const Gmpz& e) {
  const std::size_t k = dimension();
  const Mask bit = Mask(1) << k;
  unsigned long p = internal::prime_after(k == 0 ? 1UL << 30 : generators_.back().prime);
  while (!internal::is_negative_symbol(e, p)) p = internal::prime_after(p);
  Mask negative = 0; // representatives with chi_p(d) = -1
  for (std::size_t i = 0; i < k; ++i)
    if (internal::is_negative_symbol(generators_[i].d, p)) negative |= Mask(1) << i;
  if (internal::is_negative_symbol(n, p)) negative |= bit;
  generators_.push_back({n, p, candidate | bit, bit});
  for (std::size_t i = 0; i < k; ++i)
    if (internal::has_odd_size(generators_[i].e_of & negative)) generators_[i].symbols |= bit;
}

} // namespace CGAL::Intrinsic_triangulations
