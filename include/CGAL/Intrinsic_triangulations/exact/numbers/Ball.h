// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_BALL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_BALL_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <cmath>
#include <limits>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief encloses a real number by a center and a radius.

What overflows, or is divided by what may be zero, gets a radius that is infinite or not a number. All operations ask for
rounding to the nearest, but for `interval()`. Radii have as wide a range of exponents as `Center::Magnitude`: centers of thousands of
bits have errors that no double tells.
\tparam Center `Double_double` or `Mpfr_number`
\cgalModels{Field}
*/
template <class Center>
class Ball {
public:
  /// Number type of radii.
  using Magnitude = typename Center::Magnitude;

  /// constructs zero.
  Ball() = default;
  /// converts a number exactly.
  Ball(double x) : center_(x), magnitude_(std::abs(x)) {} // NOLINT(google-explicit-constructor)
  /// encloses what is no farther from a center than a radius.
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
  /// returns the square root of what is not negative. |sqrt(x) - sqrt(X)| <= |x - X| / sqrt(X)
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

namespace internal {

// Calls a function with rounding to the nearest.
template <class Function, class... Arguments>
auto to_nearest(const Function& f, Arguments&... arguments) {
  const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  return f(arguments...);
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_BALL_H
