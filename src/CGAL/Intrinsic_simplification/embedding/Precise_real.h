// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_PRECISE_REAL_H
#define CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_PRECISE_REAL_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>

#include <Eigen/Core>

#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// A number of 106 bits with all operations that matrices of Eigen need.
class Precise_real {
public:
  Precise_real() = default;
  Precise_real(double x) : value_(x) {} // NOLINT(google-explicit-constructor)
  explicit Precise_real(const Double_double& x) : value_(x) {}
  explicit operator double() const { return value_.to_double(); }

  Precise_real& operator+=(const Precise_real& x) { return *this = *this + x; }
  Precise_real& operator-=(const Precise_real& x) { return *this = *this - x; }
  Precise_real& operator*=(const Precise_real& x) { return *this = *this * x; }
  Precise_real& operator/=(const Precise_real& x) { return *this = *this / x; }
  friend Precise_real operator+(const Precise_real& a, const Precise_real& b) {
    return Precise_real(a.value_ + b.value_);
  }
  friend Precise_real operator-(const Precise_real& a, const Precise_real& b) {
    return Precise_real(a.value_ - b.value_);
  }
  friend Precise_real operator-(const Precise_real& a) { return Precise_real(-a.value_); }
  friend Precise_real operator*(const Precise_real& a, const Precise_real& b) {
    return Precise_real(a.value_ * b.value_);
  }
  friend Precise_real operator/(const Precise_real& a, const Precise_real& b) {
    return Precise_real(a.value_ / b.value_);
  }
  friend bool operator==(const Precise_real& a, const Precise_real& b) = default;
  friend bool operator<(const Precise_real& a, const Precise_real& b) {
    return (a.value_ - b.value_).to_double() < 0;
  }
  friend bool operator>(const Precise_real& a, const Precise_real& b) { return b < a; }
  friend bool operator<=(const Precise_real& a, const Precise_real& b) {
    return (a.value_ - b.value_).to_double() <= 0;
  }
  friend Precise_real sqrt(const Precise_real& x) {
    return x.value_.to_double() == 0 ? x : Precise_real(sqrt(x.value_));
  }
  friend Precise_real abs(const Precise_real& x) { return x.value_.to_double() < 0 ? -x : x; }

private:
  Double_double value_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

// More than the relative error of an operation. Eigen asks for it where it compares.
template <>
struct Eigen::NumTraits<CGAL::Intrinsic_triangulations::internal::Precise_real>
    : Eigen::GenericNumTraits<CGAL::Intrinsic_triangulations::internal::Precise_real> {
  using Number = CGAL::Intrinsic_triangulations::internal::Precise_real;
  enum { IsSigned = 1, RequireInitialization = 1, ReadCost = 2, AddCost = 20, MulCost = 10 };
  static Number epsilon() {
    return {2 * CGAL::Intrinsic_triangulations::Double_double::rounding()};
  }
  static Number dummy_precision() { return epsilon(); }
  static Number highest() { return {std::numeric_limits<double>::max()}; }
  static Number lowest() { return {-std::numeric_limits<double>::max()}; }
  static int digits10() { return 31; }
};

#endif // CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_PRECISE_REAL_H
