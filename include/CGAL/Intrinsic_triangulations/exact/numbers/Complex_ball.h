// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_COMPLEX_BALL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_COMPLEX_BALL_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// What encloses a real number, taken apart. `unit` bounds the relative error of an operation on centers.
template <class FT>
struct Enclosure_parts;

// rounding is upwards
template <>
struct Enclosure_parts<Interval_nt<false>> {
  using FT = Interval_nt<false>;
  using Center = double;
  using Magnitude = double;
  static constexpr double unit() { return 0x1p-52; }
  static double center(const FT& x) { return (x.inf() + x.sup()) / 2; }
  static double radius(const FT& x, double center) {
    return std::max(x.sup() - center, -(x.inf() - center));
  }
  static FT make(double center, double radius) {
    return radius < std::numeric_limits<double>::infinity() ? FT(center) + FT(-radius, radius)
                                                            : FT::largest();
  }
};

template <class Number>
struct Enclosure_parts<Ball<Number>> {
  using FT = Ball<Number>;
  using Center = Number;
  using Magnitude = typename Number::Magnitude;
  static Magnitude unit() { return Number::rounding(); }
  static const Center& center(const FT& x) { return x.center(); }
  static Magnitude radius(const FT& x, const Center&) { return x.radius(); }
  static FT make(const Center& center, Magnitude radius) { return FT::around(center, radius); }
};

inline double magnitude(double x) { return std::abs(x); }
template <class Number>
typename Number::Magnitude magnitude(const Number& x) {
  return std::abs(x.magnitude());
}

} // namespace internal

/*!
\brief encloses a complex number that is not zero by a center and a *relative* radius.

The radius of a product is the sum of the radii, and little more, whatever their arguments are: an error grows linearly along
a chain of rotations. Between intervals of real and imaginary part it grows exponentially.
\tparam FT encloses real numbers: `Interval_nt<false>` or a `Ball`; rounding is as it asks for
*/
template <class FT>
class Complex_ball {
  using Parts = internal::Enclosure_parts<FT>;
  using Center = typename Parts::Center;
  using Magnitude = typename Parts::Magnitude;
  static constexpr Magnitude infinity = std::numeric_limits<Magnitude>::infinity();

public:
  /// constructs one.
  Complex_ball() = default;
  /*!
  \brief encloses (x + i y) / d.
  \pre d > 0, and x or y is not zero
  */
  Complex_ball(const FT& x, const FT& y, const FT& d) {
    const Center p = Parts::center(x), q = Parts::center(y), c = Parts::center(d);
    const Center r = Center(1) / c;
    x_ = p * r;
    y_ = q * r;
    const Magnitude error = Parts::radius(x, p) + Parts::radius(y, q);
    const Magnitude size = std::max(internal::magnitude(p), internal::magnitude(q)) * (1 - slack);
    const Magnitude error_d = Parts::radius(d, c),
                 least = internal::magnitude(c) * (1 - slack) - error_d;
    radius_ = least > 0 ? product(error / size, error_d / least) : infinity;
    check();
  }

  /// returns the product.
  friend Complex_ball operator*(const Complex_ball& a, const Complex_ball& b) {
    Complex_ball c;
    c.x_ = a.x_ * b.x_ - a.y_ * b.y_;
    c.y_ = a.x_ * b.y_ + a.y_ * b.x_;
    c.radius_ = product(a.radius_, b.radius_);
    c.check();
    return c;
  }
  /// returns the negative.
  Complex_ball operator-() const {
    Complex_ball c = *this;
    c.x_ = Center(0) - x_;
    c.y_ = Center(0) - y_;
    return c;
  }

  /// returns the real part.
  FT real() const { return Parts::make(x_, absolute_radius()); }
  /// returns the imaginary part.
  FT imaginary() const { return Parts::make(y_, absolute_radius()); }

private:
  // more than a few operations on radii, and than rounding to a double
  static constexpr double slack = 0x1p-40;
  // what underflows, in radii
  static constexpr Magnitude tiny = 0x1p14 * std::numeric_limits<Magnitude>::denorm_min();

  // Relative errors of factors, and of the operations. Each part of a product of centers has an error below 2 u (1 + u) of the sum
  // of magnitudes of its terms; the squares of these sums add up to 2 |a b|^2 at most: 2 sqrt(2) u of the product. A quotient takes two
  // operations.
  static Magnitude product(Magnitude a, Magnitude b) {
    return (a + b + a * b + 3 * Parts::unit()) * (1 + slack);
  }
  Magnitude absolute_radius() const {
    return radius_ * (internal::magnitude(x_) + internal::magnitude(y_)) * (1 + slack) + tiny;
  }
  // products that may have underflowed are not relative to what they should be
  void check() {
    const Magnitude size = internal::magnitude(x_) + internal::magnitude(y_);
    if (!(size > 0x1p-800 && size < 0x1p800)) radius_ = infinity;
  }

  Center x_{1}, y_{0};
  Magnitude radius_ = 0; // of the modulus
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_COMPLEX_BALL_H
