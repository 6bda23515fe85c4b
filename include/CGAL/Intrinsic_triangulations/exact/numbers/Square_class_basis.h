// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_SQUARE_CLASS_BASIS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_SQUARE_CLASS_BASIS_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Proof_watch.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a square root of a rational number, relative to a `Square_class_basis`: factor times the
square root of the product of the representatives whose bits are set in `radical`.
*/
struct Square_root {
  /// Set of representatives, as bits: two words, since lengths across a rolled sheet are sums of as
  /// many roots as it has folds.
  __extension__ using Mask = unsigned __int128;

  Gmpq factor;      ///< rational, not negative
  Mask radical = 0; ///< zero iff the number is the square of a rational
};

/*!
\brief writes square roots of rationals as rational multiples of products of independent ones.

Two positive rationals are in one square class if their product is the square of a rational; classes
form a vector space over GF(2) under multiplication. The basis holds representatives d_0, d_1, ...
of independent classes, integers > 1, and takes in another for each root that the present ones do
not express. The products of sqrt(d_i) over all sets of indices are then linearly independent over
the rationals (Besicovitch, On the linear independence of fractional powers of integers, 1940),
which is what makes `Multiquadratic_number::is_zero()` exact.

<b>Method, and why answers are never wrong.</b> For an odd prime p let chi_p(n) be the Legendre
symbol of n with all factors p removed. chi_p is multiplicative, and 1 on squares: it is a linear
functional on square classes. The basis keeps for each d_i a prime p_i and the product e_i of d_i
with earlier representatives, such that chi_{p_i}(e_i) = -1 and chi_{p_j}(e_i) = 1 for all j < i.
The matrix is unitriangular, so forward substitution finds for any n the *only* set S for which n
d_S has all symbols 1. If n d_S is a perfect square, which is tested in integers, sqrt(n) = sqrt(n
d_S) / d_S sqrt(d_S). If not, n is independent of the basis: n d_T is not a square for T = S by the
test, nor for any other set T, which has a symbol -1. Then d_k = n and e_k = n d_S enter the basis,
and since e_k is not a square, half of all primes have chi_p(e_k) = -1, so that p_k is found by
trying.

Representatives never change: roots stay valid while the basis grows. Threads must not share it, not
even for `product()`, which stores results.
*/
class Square_class_basis {
public:
  /// Set of representatives, as bits.
  using Mask = Square_root::Mask;
  /// Largest number of representatives.
  static constexpr std::size_t max_dimension = 128;

  /// constructs the basis of the trivial class.
  Square_class_basis() = default;

  /*!
  \brief writes the square root of `x` in the basis, which grows if necessary.
  \pre `x` is not negative
  \return the root, or nothing if it needs a new representative and there are `max_dimension`
  \complexity one Legendre symbol for each representative and the root of one integer
  */
  std::optional<Square_root> sqrt_of(const Gmpq& x);

  /*!
  \brief writes the square root of a positive integer in the basis; fast where it is a
  representative.
  \return as for rationals
  */
  std::optional<Square_root> sqrt_of(const Gmpz& n);

  /// divides `n` by a square that is cheap to find, and returns its root. \pre `n` is positive
  static Gmpz extract_square(Gmpz& n);

  /*!
  \brief bounds the time that products of numbers of the basis may take from now on: when the
  lengths of coefficients, multiplied and summed over all pairs, have reached `words`,
  `std::length_error` is thrown.

  A number of a field of k square roots has up to 2^k terms.
  */
  void limit_products(std::size_t words) { words_left_ = words; }
  /// returns what is left of that.
  std::size_t words_left() const { return words_left_; }
  /// counts the words of coefficients that are multiplied. \throws std::length_error see
  /// `limit_products()`
  void count_words(std::size_t words) const {
    if (words > words_left_ || (words > 1000 && !Proof_watch::goes_on()))
      throw std::length_error("products have too many terms");
    words_left_ -= words;
  }

  /// returns the number of representatives.
  std::size_t dimension() const { return generators_.size(); }

  /*!
  \brief returns representative number `i`.
  \pre i < `dimension()`
  */
  const Gmpz& representative(std::size_t i) const {
    CGAL_precondition(i < dimension());
    return generators_[i].d;
  }

  /*!
  \brief returns the product of a set of representatives, and stores it.
  \pre all bits are below `dimension()`
  \return a reference that stays valid until a new representative enters
  */
  const Gmpz& product(Mask mask) const;

private:
  struct Generator {
    Gmpz d;              // representative
    unsigned long prime; // chi_prime(e) = -1 for e = e_of
    Mask e_of;           // e as a product of representatives; the highest bit is this generator's
    Mask symbols;        // bit i is set iff chi_{p_i}(e) = -1; no bit below this generator's
  };

  struct Hash {
    std::size_t operator()(Mask m) const {
      return std::hash<std::uint64_t>()(static_cast<std::uint64_t>(m) ^
                                        static_cast<std::uint64_t>(m >> 64U) * 0x9e3779b97f4a7c15U);
    }
  };

  // returns the only set S for which n d_S can be a square
  Mask find_candidate(const Gmpz& n) const;

  // makes n a representative; e = n d_S with S the candidate is not a square
  void append(const Gmpz& n, Mask candidate, const Gmpz& e);

  std::vector<Generator> generators_;
  mutable std::size_t words_left_ = std::numeric_limits<std::size_t>::max();
  Gmpz one_ = Gmpz(1);
  mutable std::unordered_map<Mask, Gmpz, Hash> products_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_SQUARE_CLASS_BASIS_H
