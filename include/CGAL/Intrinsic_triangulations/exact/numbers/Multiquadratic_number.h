// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MULTIQUADRATIC_NUMBER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MULTIQUADRATIC_NUMBER_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.h>

#include <CGAL/Gmpq.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>

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
  Gmpq coefficient(Mask radical) const;

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
  Multiquadratic_number inverse() const;

  /// returns the negated number.
  Multiquadratic_number operator-() const { return Multiquadratic_number() - *this; }

  /// adds.
  friend Multiquadratic_number operator+(const Multiquadratic_number& x,
                                         const Multiquadratic_number& y);
  /// subtracts.
  friend Multiquadratic_number operator-(const Multiquadratic_number& x,
                                         const Multiquadratic_number& y);
  /// \throws std::length_error see `Square_class_basis::limit_products()`
  friend Multiquadratic_number operator*(const Multiquadratic_number& x,
                                         const Multiquadratic_number& y);
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
  friend bool operator==(const Multiquadratic_number& x, const Multiquadratic_number& y);

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
                                                const Multiquadratic_number& y);

  template <class Signed>
  static Multiquadratic_number sum(const Multiquadratic_number& x, const Multiquadratic_number& y,
                                   const Signed& with_sign);

  // of all coefficients
  std::size_t number_of_words() const;

  // adds a term whose radical is not below those that are there
  void add(const Term& t);

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
