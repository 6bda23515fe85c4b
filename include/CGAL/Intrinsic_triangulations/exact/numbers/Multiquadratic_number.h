// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MULTIQUADRATIC_NUMBER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MULTIQUADRATIC_NUMBER_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/multiquadratic_terms.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a number of the field Q(sqrt(d_0), sqrt(d_1), ...) of a `Square_class_basis`.

The value is 2^e (sum of n_S sqrt(d_S)) / m with integers n_S for sets S of representatives, and m
odd, positive, coprime to the n_S. Since the sqrt(d_S) are linearly independent over the rationals,
the number is zero iff it has no terms, and equal numbers have equal representations. Powers of two
are kept apart because input is made of doubles: until the first division sums and products need no
greatest common divisor.

Rational numbers belong to every basis; two numbers that are not rational must share one, which must
outlive them.
\cgalModels{Field}
*/
class Multiquadratic_number {
public:
  /// Set of representatives, as bits.
  using Mask = Square_class_basis::Mask;

  /// constructs zero.
  Multiquadratic_number() : Multiquadratic_number({}, one(), 0, nullptr) {}
  /// constructs an integer.
  Multiquadratic_number(int n) : Multiquadratic_number(Gmpq(n)) {}
  /// constructs a rational from a finite double, exactly.
  Multiquadratic_number(double x) : Multiquadratic_number(Gmpq(x)) {}
  /// constructs a rational number.
  Multiquadratic_number(const Gmpq& x) : Multiquadratic_number(nullptr, x, 0) {}
  /// constructs the square root of a rational number.
  /// \pre `basis` made `root`, and outlives this number
  Multiquadratic_number(const Square_class_basis& basis, const Square_root& root)
      : Multiquadratic_number(root.radical == 0 ? nullptr : &basis, root.factor, root.radical) {}

  /// tells whether the number is zero, exactly.
  bool is_zero() const { return terms_.empty(); }
  /// tells whether the number is rational.
  bool is_rational() const {
    return terms_.empty() || (terms_.size() == 1 && terms_.front().radical == 0);
  }
  /// returns the number of products of roots that occur.
  std::size_t number_of_terms() const { return terms_.size(); }

  /// returns the rational coefficient of sqrt(d_radical).
  Gmpq coefficient(Mask radical) const {
    for (const internal::Multiquadratic_term& t : terms_)
      if (t.radical == radical) return coefficient(t);
    return Gmpq(0);
  }

  /// returns the value in another number type. \param from_rational converts a `Gmpq` to that type
  template <class From_rational>
  auto value(const From_rational& from_rational) const {
    auto result = from_rational(Gmpq(0));
    for (const internal::Multiquadratic_term& t : terms_) {
      auto term = from_rational(coefficient(t));
      if (t.radical != 0) term = term * sqrt(from_rational(Gmpq(basis_->product(t.radical))));
      result = result + term;
    }
    return result;
  }

  /*!
  \brief returns the inverse.
  \pre the number is not zero
  \complexity one greatest common divisor for a single term; in general 3^r products of integers
  whose size grows by the factor 2^r, where r generators occur
  */
  Multiquadratic_number inverse() const {
    CGAL_precondition(!is_zero());
    const auto [z, n] = internal::cofactor(basis_, terms_);
    const Gmpz m = n.sign() == NEGATIVE ? -denominator_ : denominator_;
    const auto twos = mpz_scan1(n.mpz(), 0);
    Gmpz odd;
    mpz_tdiv_q_2exp(odd.mpz(), n.mpz(), twos);
    mpz_abs(odd.mpz(), odd.mpz());
    if (odd == 1) odd = one();
    return canonical(internal::scaled(z, m), odd, odd, -exponent_ - static_cast<long>(twos),
                     basis_);
  }

  /// returns the negated number.
  Multiquadratic_number operator-() const {
    return {internal::scaled(terms_, Gmpz(-1)), denominator_, exponent_, basis_};
  }

  /// adds.
  friend Multiquadratic_number operator+(const Multiquadratic_number& x,
                                         const Multiquadratic_number& y) {
    return sum(x, y, false);
  }
  /// subtracts.
  friend Multiquadratic_number operator-(const Multiquadratic_number& x,
                                         const Multiquadratic_number& y) {
    return sum(x, y, true);
  }
  /// \throws std::length_error see `Square_class_basis::limit_products()`
  friend Multiquadratic_number operator*(const Multiquadratic_number& x,
                                         const Multiquadratic_number& y) {
    const Square_class_basis* basis = common_basis(x, y);
    if (basis != nullptr) basis->count_pairs(x.terms_.size() * y.terms_.size());
    const Gmpz m = product(x.denominator_, y.denominator_);
    return canonical(internal::product(basis, x.terms_, y.terms_), m, m, x.exponent_ + y.exponent_,
                     basis);
  }
  /// \pre `y` is not zero
  friend Multiquadratic_number operator/(const Multiquadratic_number& x,
                                         const Multiquadratic_number& y) {
    return x * y.inverse();
  }

  /// adds `y`.
  Multiquadratic_number& operator+=(const Multiquadratic_number& y) { return *this = *this + y; }
  /// subtracts `y`.
  Multiquadratic_number& operator-=(const Multiquadratic_number& y) { return *this = *this - y; }
  /// multiplies by `y`.
  Multiquadratic_number& operator*=(const Multiquadratic_number& y) { return *this = *this * y; }
  /// divides by `y`.
  Multiquadratic_number& operator/=(const Multiquadratic_number& y) { return *this = *this / y; }

  /// tells whether two numbers are equal, exactly.
  friend bool operator==(const Multiquadratic_number& x, const Multiquadratic_number& y) {
    return x.exponent_ == y.exponent_ && x.denominator_ == y.denominator_ &&
           std::equal(x.terms_.begin(), x.terms_.end(), y.terms_.begin(), y.terms_.end(),
                      [](const auto& s, const auto& t) {
                        return s.radical == t.radical && s.value == t.value;
                      });
  }

private:
  using Terms = internal::Multiquadratic_terms;

  Multiquadratic_number(Terms terms, const Gmpz& denominator, long exponent,
                        const Square_class_basis* basis)
      : terms_(std::move(terms)), denominator_(denominator), exponent_(exponent), basis_(basis) {}

  Multiquadratic_number(const Square_class_basis* basis, const Gmpq& x, Mask radical)
      : denominator_(one()), basis_(basis) {
    if (x.sign() == ZERO) return;
    terms_.push_back({radical, x.numerator()});
    const Gmpz m = x.denominator();
    const auto twos = mpz_scan1(m.mpz(), 0);
    exponent_ = -static_cast<long>(twos);
    const Gmpz odd = m >> static_cast<long>(twos);
    if (odd != 1) denominator_ = odd;
    strip_twos();
  }

  // shared by all numbers with this denominator: handles are counted
  static const Gmpz& one() {
    static const Gmpz value(1);
    return value;
  }

  static Gmpz product(const Gmpz& x, const Gmpz& y) { return x == 1 ? y : y == 1 ? x : x * y; }

  static const Square_class_basis* common_basis(const Multiquadratic_number& x,
                                                const Multiquadratic_number& y) {
    CGAL_precondition(x.basis_ == nullptr || y.basis_ == nullptr || x.basis_ == y.basis_);
    return x.basis_ != nullptr ? x.basis_ : y.basis_;
  }

  // x + y = 2^e (x_S f_x + y_S f_y) / lcm(m_x, m_y), e the smaller exponent; what is common to all
  // integers and to the denominator divides gcd(m_x, m_y), as for fractions
  static Multiquadratic_number sum(const Multiquadratic_number& x, const Multiquadratic_number& y,
                                   bool subtract) {
    if (y.is_zero()) return x;
    if (x.is_zero()) return subtract ? -y : y;
    const Gmpz &m_x = x.denominator_, &m_y = y.denominator_;
    const Gmpz g = m_x == m_y ? m_x : m_x == 1 || m_y == 1 ? one() : gcd(m_x, m_y);
    Gmpz f_x = quotient(m_y, g), f_y = quotient(m_x, g);
    const Gmpz m = product(m_x, f_x);
    const long e = std::min(x.exponent_, y.exponent_);
    f_x = shifted(f_x, x.exponent_ - e);
    f_y = shifted(f_y, y.exponent_ - e);
    Terms t_x, t_y;
    const Terms& u = f_x == 1 ? x.terms_ : (t_x = internal::scaled(x.terms_, f_x));
    const Terms& v = f_y == 1 ? y.terms_ : (t_y = internal::scaled(y.terms_, f_y));
    return canonical(internal::sum(u, v, subtract), m, g, e, common_basis(x, y));
  }

  static Gmpz gcd(const Gmpz& x, const Gmpz& y) {
    Gmpz g;
    mpz_gcd(g.mpz(), x.mpz(), y.mpz());
    return g;
  }

  static Gmpz quotient(const Gmpz& x, const Gmpz& divisor) {
    if (divisor == 1) return x;
    if (divisor == x) return one();
    Gmpz q;
    mpz_divexact(q.mpz(), x.mpz(), divisor.mpz());
    return q;
  }

  static Gmpz shifted(const Gmpz& x, long bits) {
    if (bits == 0) return x;
    Gmpz result;
    mpz_mul_2exp(result.mpz(), x.mpz(), static_cast<mp_bitcnt_t>(bits));
    return result;
  }

  // brings 2^exponent terms / m to lowest terms; m is odd and positive, and what is common to it
  // and to all terms divides g
  static Multiquadratic_number canonical(Terms terms, const Gmpz& m, const Gmpz& g, long exponent,
                                         const Square_class_basis* basis) {
    if (terms.empty()) return {};
    Multiquadratic_number result(std::move(terms), m, exponent, basis);
    result.reduce(g);
    result.strip_twos();
    if (result.is_rational()) result.basis_ = nullptr;
    return result;
  }

  void reduce(Gmpz g) {
    for (const internal::Multiquadratic_term& t : terms_) {
      if (g == 1) return;
      g = gcd(g, t.value);
    }
    if (g == 1) return;
    for (internal::Multiquadratic_term& t : terms_) t.value = quotient(t.value, g);
    denominator_ = quotient(denominator_, g);
  }

  // makes one of the integers odd
  void strip_twos() {
    mp_bitcnt_t twos = ~mp_bitcnt_t(0);
    for (const internal::Multiquadratic_term& t : terms_) {
      const Gmpz& value = t.value;
      if ((twos = std::min(twos, mpz_scan1(value.mpz(), 0))) == 0) return;
    }
    if (terms_.empty()) return;
    for (internal::Multiquadratic_term& t : terms_) {
      const Gmpz value = t.value;
      t.value = Gmpz();
      mpz_tdiv_q_2exp(t.value.mpz(), value.mpz(), twos);
    }
    exponent_ += static_cast<long>(twos);
  }

  Gmpq coefficient(const internal::Multiquadratic_term& t) const {
    const Gmpq unscaled(t.value, denominator_);
    Gmpq result;
    if (exponent_ >= 0)
      mpq_mul_2exp(result.mpq(), unscaled.mpq(), static_cast<mp_bitcnt_t>(exponent_));
    else
      mpq_div_2exp(result.mpq(), unscaled.mpq(), static_cast<mp_bitcnt_t>(-exponent_));
    return result;
  }

  Terms terms_;
  Gmpz denominator_;
  long exponent_ = 0;
  const Square_class_basis* basis_ = nullptr; // null if rational
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MULTIQUADRATIC_NUMBER_H
