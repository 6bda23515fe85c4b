// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MULTIQUADRATIC_NUMBER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MULTIQUADRATIC_NUMBER_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.h>

#include <CGAL/Gmpq.h>
#include <CGAL/assertions.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a number of the field Q(sqrt(d_0), sqrt(d_1), ...) of a `Square_class_basis`.

The value is a sum of terms q_S sqrt(d_S), with rationals q_S for sets S of representatives. Since
the sqrt(d_S) are linearly independent over the rationals, the number is zero iff it has no terms,
and equal numbers have equal terms.

Rational numbers belong to every basis; two numbers that are not rational must share one, which must
outlive them.
\cgalModels{Field}
*/
class Multiquadratic_number {
public:
  /// Set of representatives, as bits.
  using Mask = Square_class_basis::Mask;

  /// constructs zero.
  Multiquadratic_number() = default;
  /// constructs an integer.
  Multiquadratic_number(int n) : Multiquadratic_number(Gmpq(n)) {}
  /// constructs a rational from a finite double, exactly.
  Multiquadratic_number(double x) : Multiquadratic_number(Gmpq(x)) {}
  /// constructs a rational number.
  Multiquadratic_number(const Gmpq& x) { add({0, x}); }
  /// constructs the square root of a rational number.
  /// \pre `basis` made `root`, and outlives this number
  Multiquadratic_number(const Square_class_basis& basis, const Square_root& root)
      : basis_(root.radical == 0 ? nullptr : &basis) {
    add({root.radical, root.factor});
  }

  /// tells whether the number is zero, exactly.
  bool is_zero() const { return terms_.empty(); }
  /// tells whether the number is rational.
  bool is_rational() const { return terms_.empty() || terms_.back().radical == 0; }
  /// returns the number of products of roots that occur.
  std::size_t number_of_terms() const { return terms_.size(); }

  /// returns the rational coefficient of sqrt(d_radical).
  Gmpq coefficient(Mask radical) const {
    for (const Term& t : terms_)
      if (t.radical == radical) return t.coefficient;
    return Gmpq(0);
  }

  /// returns the value in another number type. \param from_rational converts a `Gmpq` to that type
  template <class From_rational>
  auto value(const From_rational& from_rational) const {
    auto result = from_rational(Gmpq(0));
    for (const Term& t : terms_) {
      auto term = from_rational(t.coefficient);
      if (t.radical != 0) term = term * sqrt(from_rational(Gmpq(basis_->product(t.radical))));
      result = result + term;
    }
    return result;
  }

  /*!
  \brief returns the inverse.

  For x = a + b s, s^2 = d_g, 1 / x = (a - b s) / (a^2 - d_g b^2). The divisor is free of g and not
  zero, since changing the sign of s is an automorphism. Products of radicals of two of its terms
  are products of those of x: there are as many levels as these products have generators, no more.
  \pre the number is not zero
  */
  Multiquadratic_number inverse() const {
    CGAL_precondition(!is_zero());
    if (terms_.size() == 1) {
      const auto& [radical, q] = terms_.front();
      return {basis_, {{radical, Gmpq(1) / (radical == 0 ? q : q * basis_->product(radical))}}};
    }
    const Mask g = std::bit_floor(terms_.back().radical);
    Multiquadratic_number conjugate = *this, norm;
    for (Term& t : conjugate.terms_)
      if ((t.radical & g) != 0) t.coefficient = -t.coefficient;
    norm = *this * conjugate;
    return conjugate * norm.inverse();
  }

  /// returns the negated number.
  Multiquadratic_number operator-() const { return Multiquadratic_number() - *this; }

  /// adds.
  friend Multiquadratic_number operator+(const Multiquadratic_number& x,
                                         const Multiquadratic_number& y) {
    return sum(x, y, [](const Gmpq& q) { return q; });
  }
  /// subtracts.
  friend Multiquadratic_number operator-(const Multiquadratic_number& x,
                                         const Multiquadratic_number& y) {
    return sum(x, y, [](const Gmpq& q) { return -q; });
  }
  /// \throws std::length_error see `Square_class_basis::limit_products()`
  friend Multiquadratic_number operator*(const Multiquadratic_number& x,
                                         const Multiquadratic_number& y) {
    const Square_class_basis* basis = common_basis(x, y);
    if (basis != nullptr) basis->count_pairs(x.terms_.size() * y.terms_.size());
    std::vector<Term> all;
    all.reserve(x.terms_.size() * y.terms_.size());
    for (const Term& s : x.terms_)
      for (const Term& t : y.terms_) {
        const Mask common = s.radical & t.radical;
        const Gmpq q = s.coefficient * t.coefficient;
        all.push_back({s.radical ^ t.radical, common == 0 ? q : q * basis->product(common)});
      }
    std::sort(all.begin(), all.end(),
              [](const Term& s, const Term& t) { return s.radical < t.radical; });
    Multiquadratic_number result(basis, {});
    for (const Term& t : all) result.add(t);
    return result.normal();
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
    return std::equal(x.terms_.begin(), x.terms_.end(), y.terms_.begin(), y.terms_.end(),
                      [](const Term& s, const Term& t) {
                        return s.radical == t.radical && s.coefficient == t.coefficient;
                      });
  }

private:
  struct Term {
    Mask radical;
    Gmpq coefficient;
  };
  // by radical, none zero; one representative suffices for nearly all values: two terms
  using Terms = boost::container::small_vector<Term, 2>;

  Multiquadratic_number(const Square_class_basis* basis, const Terms& terms)
      : terms_(terms), basis_(basis) {}

  static const Square_class_basis* common_basis(const Multiquadratic_number& x,
                                                const Multiquadratic_number& y) {
    CGAL_precondition(x.basis_ == nullptr || y.basis_ == nullptr || x.basis_ == y.basis_);
    return x.basis_ != nullptr ? x.basis_ : y.basis_;
  }

  template <class Signed>
  static Multiquadratic_number sum(const Multiquadratic_number& x, const Multiquadratic_number& y,
                                   const Signed& with_sign) {
    Multiquadratic_number result(common_basis(x, y), {});
    result.terms_.reserve(x.terms_.size() + y.terms_.size());
    auto s = x.terms_.begin();
    for (const Term& t : y.terms_) {
      for (; s != x.terms_.end() && s->radical <= t.radical; ++s) result.add(*s);
      result.add({t.radical, with_sign(t.coefficient)});
    }
    for (; s != x.terms_.end(); ++s) result.add(*s);
    return result.normal();
  }

  // adds a term whose radical is not below those that are there
  void add(const Term& t) {
    if (terms_.empty() || terms_.back().radical != t.radical) {
      if (t.coefficient.sign() != ZERO) terms_.push_back(t);
      return;
    }
    terms_.back().coefficient += t.coefficient;
    if (terms_.back().coefficient.sign() == ZERO) terms_.pop_back();
  }

  // rational numbers belong to every basis
  Multiquadratic_number& normal() {
    if (is_rational()) basis_ = nullptr;
    return *this;
  }

  Terms terms_;
  const Square_class_basis* basis_ = nullptr; // null if rational
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MULTIQUADRATIC_NUMBER_H
