// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_BALL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_BALL_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief encloses a real number by a center and a radius.

Overflow, or division by a possible zero, gives a radius that is infinite or not a number. All
operations except `interval()` require rounding to the nearest. Radii have the exponents of
`Center::Magnitude`, since errors of centers of thousands of bits are outside the range of doubles.
\tparam Center `Double_double` or `Mpfr_number`
\cgalModels{Field}
*/
template <FieldNumber Center>
class Ball {
public:
  /// Number type of radii.
  using Magnitude = typename Center::Magnitude;

  /// constructs zero.
  Ball() = default;
  /// converts a number exactly.
  Ball(double x) : center_(x), magnitude_(std::abs(x)) {} // NOLINT(google-explicit-constructor)
  /// encloses the numbers within a radius of a center.
  static Ball around(const Center& center, Magnitude radius) { return {center, radius}; }

  /// returns the sum.
  friend Ball operator+(const Ball& a, const Ball& b) {
    return {a.center_ + b.center_, a.radius_ + b.radius_};
  }
  /// returns the difference.
  friend Ball operator-(const Ball& a, const Ball& b) {
    return {a.center_ - b.center_, a.radius_ + b.radius_};
  }
  /// returns the negated number.
  friend Ball operator-(const Ball& a) { return Ball() - a; }
  /// returns the product.
  friend Ball operator*(const Ball& a, const Ball& b) {
    return {a.center_ * b.center_,
            a.size() * b.radius_ + b.size() * a.radius_ + a.radius_ * b.radius_};
  }
  /// returns the quotient. a / b - A / B = ((a - A) - A / B (b - B)) / b
  friend Ball operator/(const Ball& a, const Ball& b) {
    const Center q = a.center_ / b.center_;
    const Magnitude least = b.magnitude_ * (1 - slack) - b.radius_;
    if (!(least > 0)) return {q, infinity};
    return {q, (a.radius_ + std::abs(q.magnitude()) * (1 + slack) * b.radius_) / least};
  }
  /// returns the square.
  friend Ball square(const Ball& x) { return x * x; }
  /// returns the square root of a nonnegative number. |sqrt(x) - sqrt(X)| <= |x - X| / sqrt(X)
  friend Ball sqrt(const Ball& x) {
    if (!(x.center_.magnitude() > 0))
      return {Center(0), std::sqrt(x.size() + x.radius_) * (1 + slack)};
    const Center s = sqrt(x.center_);
    return {s, x.radius_ / (s.magnitude() * (1 - slack))};
  }

  /// returns the center.
  const Center& center() const { return center_; }
  /// returns the radius.
  Magnitude radius() const { return radius_; }
  /// returns the sign, if it is certain.
  Uncertain<Sign> sign() const {
    if (magnitude_ * (1 - slack) > radius_) return center_.magnitude() > 0 ? POSITIVE : NEGATIVE;
    return magnitude_ == 0 && radius_ == 0 ? Uncertain<Sign>(ZERO)
                                           : Uncertain<Sign>::indeterminate();
  }

  /// tells whether `to_double()` has at most a relative error, whichever number of it is meant.
  /// \param error below 1/2
  bool is_narrow(double error) const {
    // neither infinite nor so small that it is rounded more
    return radius_ <= magnitude_ * (error / 2) && magnitude_ < 0x1p1000 && magnitude_ > 0x1p-900;
  }

  /// tells whether center and radius are the same.
  bool is_identical(const Ball& other) const {
    return center_ == other.center_ && radius_ == other.radius_;
  }

  /// returns a double near the center.
  double to_double() const { return center_.to_double(); }

  /// returns an interval that contains the number. \pre rounding is upwards
  Interval_nt<false> interval() const {
    using Interval = Interval_nt<false>;
    // whatever the rounding of magnitudes
    const double c = center_.to_double(), r = static_cast<double>(radius_ * (1 + slack));
    if (!(std::abs(c) + r < std::numeric_limits<double>::infinity())) return Interval::largest();
    const double error = std::abs(c) * 0x1p-53 + 0x1p-1060 + r;
    return Interval(c) + Interval(-error, error);
  }

private:
  // more than rounding to a double, and a few operations on radii
  static constexpr double slack = 0x1p-48;
  static constexpr Magnitude infinity = std::numeric_limits<Magnitude>::infinity();
  // what underflows, in radii
  static constexpr Magnitude tiny = 0x1p14 * std::numeric_limits<Magnitude>::denorm_min();

  // adds rounding errors to a radius: of the operation, of the radius, of what underflows
  Ball(const Center& c, Magnitude radius)
      : center_(c), magnitude_(std::abs(c.magnitude())),
        radius_((radius + magnitude_ * Center::rounding()) * (1 + slack) + tiny) {}

  Magnitude size() const { return magnitude_ * (1 + slack); }

  Center center_{0};
  Magnitude magnitude_ = 0; // of the center, rounded
  Magnitude radius_ = 0;
};

/// A ball of double-doubles.
using Short_ball = Ball<Double_double>;
/// A ball of as many bits as `Mpfr_precision` sets.
using Long_ball = Ball<Mpfr_number>;

namespace internal {

// Calls a function with rounding to the nearest.
template <class Function, class... Arguments>
auto to_nearest(const Function& f, Arguments&... arguments) {
  const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  return f(arguments...);
}

} // namespace internal

/*!
\brief returns the double nearest to all numbers of a ball, if there is one that is neither zero nor
infinite. Every ball that decides it gives the same one, so that results do not depend on the way of
computation.
\pre rounding is to the nearest
*/
template <FieldNumber Center>
std::optional<double> nearest_double(const Ball<Center>& x) {
  const double c = x.to_double();
  const Ball<Center> rest = x - Ball<Center>(c);
  // the factors cover the rounding of this expression
  const double r = rest.to_double();
  const double radius =
      static_cast<double>((rest.radius() + std::abs(r) * 0x1p-50) * (1 + 0x1p-50));
  const double low = c + (r - radius), high = c + (r + radius);
  return low == high && low != 0 && std::isfinite(low) ? std::optional(low) : std::nullopt;
}

namespace internal {

// Center and radius of an enclosure of a real number. `unit` bounds the relative error of an
// operation on centers.
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

The radius of a product is the sum of the radii, and little more, for all arguments: an error grows
linearly along a chain of rotations. Between intervals of real and imaginary part it grows
exponentially.
\tparam FT encloses real numbers: `Interval_nt<false>` or a `Ball`; rounding is as it requires
*/
template <FieldNumber FT>
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

  // Relative errors of factors, and of the operations. Each part of a product of centers has an
  // error below 2 u (1 + u) of the sum of magnitudes of its terms; the squares of these sums add up
  // to 2 |a b|^2 at most: 2 sqrt(2) u of the product. A quotient takes two operations.
  static Magnitude product(Magnitude a, Magnitude b) {
    return (a + b + a * b + 3 * Parts::unit()) * (1 + slack);
  }
  Magnitude absolute_radius() const {
    return radius_ * (internal::magnitude(x_) + internal::magnitude(y_)) * (1 + slack) + tiny;
  }
  // products that may have underflowed have no relative error bound
  void check() {
    const Magnitude size = internal::magnitude(x_) + internal::magnitude(y_);
    if (!(size > 0x1p-800 && size < 0x1p800)) radius_ = infinity;
  }

  Center x_{1}, y_{0};
  Magnitude radius_ = 0; // of the modulus
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_BALL_H
