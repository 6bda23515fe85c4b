// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_SLIVERS_H
#define INTRINSIC_TRIANGULATIONS_TEST_SLIVERS_H

#include <CGAL/Gmpq.h>

#include <mpfr.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

/*!
\file
Random triangles, needles and caps in doubles, and the exact values of what is computed from them.
*/

namespace slivers {

using CGAL::Gmpq;

inline constexpr double u = std::numeric_limits<double>::epsilon() / 2;
inline constexpr std::uint64_t seed = 20260711;

/// The sides ij, jk, ki: lengths or squared lengths.
using Sides = std::array<double, 3>;

inline Gmpq square(const Gmpq& x) { return x * x; }
inline Sides rotated(const Sides& s) { return {s[1], s[2], s[0]}; }

/// returns (4A)^2 from squared lengths.
inline Gmpq exact_d(const Gmpq& a, const Gmpq& b, const Gmpq& c) {
  return Gmpq(4) * a * c - square(a + c - b);
}
inline Gmpq exact_d_from_squares(const Sides& s) {
  return exact_d(Gmpq(s[0]), Gmpq(s[1]), Gmpq(s[2]));
}
inline Gmpq exact_d_from_lengths(const Sides& s) {
  return exact_d(square(Gmpq(s[0])), square(Gmpq(s[1])), square(Gmpq(s[2])));
}

/// returns p_i from squared lengths.
inline Gmpq exact_p_from_squares(const Sides& s) { return Gmpq(s[0]) + Gmpq(s[2]) - Gmpq(s[1]); }

/// returns the relative error of `x` as an approximation of `exact`.
inline double error(double x, const Gmpq& exact) {
  if (!std::isfinite(x)) return std::numeric_limits<double>::infinity();
  return std::abs(CGAL::to_double((Gmpq(x) - exact) / exact));
}

/// returns the relative error of `angle` as an approximation of atan2(sqrt(d), p).
inline double angle_error(double angle, const Gmpq& d, const Gmpq& p) {
  mpfr_t x, y;
  mpfr_init2(x, 400);
  mpfr_init2(y, 400);
  mpfr_set_q(y, d.mpq(), MPFR_RNDN);
  mpfr_sqrt(y, y, MPFR_RNDN);
  mpfr_set_q(x, p.mpq(), MPFR_RNDN);
  mpfr_atan2(y, y, x, MPFR_RNDN);
  mpfr_d_sub(x, angle, y, MPFR_RNDN);
  mpfr_div(x, x, y, MPFR_RNDN);
  const double result = std::abs(mpfr_get_d(x, MPFR_RNDN));
  mpfr_clear(x);
  mpfr_clear(y);
  return result;
}

enum class Shape { random, needle, cap };

/*!
\brief draws the lengths of a triangle of positive area.

The short side of a needle is about `width`; a cap's long side lacks about `width` to be as long as
the others together, so that its height is about the root of `width`.
*/
inline Sides draw_lengths(Shape shape, double width, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  while (true) {
    Sides s{0.5 + unit(random), 0.5 + unit(random), 0.5 + unit(random)};
    if (shape == Shape::needle) {
      s[2] *= width;
      s[1] = s[0] + (1.8 * unit(random) - 0.9) * s[2];
    }
    if (shape == Shape::cap) s[0] = (s[1] + s[2]) * (1 - width * (0.5 + unit(random)));
    for (auto turns = random() % 3; turns > 0; --turns) s = rotated(s);
    if (std::fabs(s[0] - s[1]) < s[2] && s[2] < s[0] + s[1] && exact_d_from_lengths(s) > Gmpq(0))
      return s;
  }
}

/// draws squared lengths, see `draw_lengths()`.
inline Sides draw_squares(Shape shape, double width, std::mt19937_64& random) {
  while (true) {
    Sides s = draw_lengths(shape, width, random);
    for (double& x : s) x *= x;
    if (exact_d_from_squares(s) > Gmpq(0)) return s;
  }
}

/// calls `check(shape, width)` for all shapes and the widths 1e-1 to 1e-15.
template <class Check>
void for_each_shape(const Check& check) {
  for (const Shape shape : {Shape::random, Shape::needle, Shape::cap})
    for (int k = 1; k <= 15; ++k) check(shape, std::pow(10.0, -k));
}

} // namespace slivers

#endif // INTRINSIC_TRIANGULATIONS_TEST_SLIVERS_H
