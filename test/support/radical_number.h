// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_RADICAL_NUMBER_H
#define TEST_INTRINSIC_TRIANGULATIONS_RADICAL_NUMBER_H

#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>

#include <boost/multiprecision/mpfr.hpp>

#include <algorithm>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

// Numbers of the field of all square roots of small integers, by the book: sums of rational multiples of roots of
// squarefree integers, which are given by their prime factors. Roots of different squarefree integers are linearly
// independent, so that a number is zero iff it has no terms; other signs are read from 1000 decimal digits.

namespace radical_number {

class Number {
public:
  Number(int x = 0) : Number(CGAL::Gmpq(x)) {}
  Number(double x) : Number(CGAL::Gmpq(x)) {}
  Number(const CGAL::Gmpq& x) { add({}, x); }

  /// The square root of an integer that is a square, or has small prime factors.
  static Number sqrt(const CGAL::Gmpz& n) {
    Number result;
    CGAL::Gmpz factor;
    mpz_sqrt(factor.mpz(), n.mpz());
    if (factor * factor == n) return Number(CGAL::Gmpq(factor));
    Primes primes;
    CGAL::Gmpz rest = n;
    factor = CGAL::Gmpz(1);
    for (unsigned long p = 2; rest > 1; ++p) {
      if (p > 10000000) throw std::domain_error("a prime is too large for the oracle");
      int exponent = 0;
      for (; mpz_divisible_ui_p(rest.mpz(), p) != 0; ++exponent)
        mpz_divexact_ui(rest.mpz(), rest.mpz(), p);
      for (int e = 0; e < exponent / 2; ++e) factor = factor * CGAL::Gmpz(p);
      if (exponent % 2 != 0) primes.push_back(p);
    }
    result.add(primes, CGAL::Gmpq(factor));
    return result;
  }

  int sign() const {
    if (terms_.empty()) return 0;
    using Float = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<1000>,
                                                boost::multiprecision::et_off>;
    Float sum(0), size(0);
    for (const auto& [primes, c] : terms_) {
      Float term(1);
      for (const unsigned long p : primes) term = term * Float(p);
      term = boost::multiprecision::sqrt(term);
      mpfr_mul_q(term.backend().data(), term.backend().data(), c.mpq(), MPFR_RNDN);
      sum = sum + term;
      size = size + abs(term);
    }
    if (abs(sum) < size * Float("1e-900")) throw std::domain_error("the oracle needs more digits");
    return sum < 0 ? -1 : 1;
  }

  /// The number if it is rational, else 0.
  CGAL::Gmpq rational() const {
    return terms_.size() == 1 && terms_.begin()->first.empty() ? terms_.begin()->second
                                                               : CGAL::Gmpq(0);
  }

  friend Number operator+(Number x, const Number& y) {
    for (const auto& [primes, c] : y.terms_) x.add(primes, c);
    return x;
  }
  friend Number operator-(Number x, const Number& y) {
    for (const auto& [primes, c] : y.terms_) x.add(primes, -c);
    return x;
  }
  friend Number operator*(const Number& x, const Number& y) {
    Number result;
    for (const auto& [p, c] : x.terms_)
      for (const auto& [q, d] : y.terms_) {
        Primes both, one;
        std::set_intersection(p.begin(), p.end(), q.begin(), q.end(), std::back_inserter(both));
        std::set_symmetric_difference(p.begin(), p.end(), q.begin(), q.end(),
                                      std::back_inserter(one));
        CGAL::Gmpq factor = c * d;
        for (const unsigned long r : both) factor *= CGAL::Gmpq(static_cast<double>(r));
        result.add(one, factor);
      }
    return result;
  }
  friend Number operator/(const Number& x, const Number& y) { return x * y.inverse(); }

private:
  using Primes = std::vector<unsigned long>; // increasing

  void add(const Primes& primes, const CGAL::Gmpq& c) {
    CGAL::Gmpq& sum = terms_[primes];
    sum += c;
    if (sum == 0) terms_.erase(primes);
  }

  // conjugates one root after another: (a + b sqrt(p)) (a - b sqrt(p)) is free of sqrt(p)
  Number inverse() const {
    if (terms_.empty()) throw std::domain_error("division by zero");
    for (const auto& [primes, c] : terms_)
      if (!primes.empty()) {
        const unsigned long p = primes.front();
        Number conjugate;
        for (const auto& [q, d] : terms_)
          conjugate.add(q, std::binary_search(q.begin(), q.end(), p) ? -d : d);
        return conjugate * (*this * conjugate).inverse();
      }
    return Number(CGAL::Gmpq(1) / terms_.begin()->second);
  }

  std::map<Primes, CGAL::Gmpq> terms_;
};

} // namespace radical_number

#endif // TEST_INTRINSIC_TRIANGULATIONS_RADICAL_NUMBER_H
