// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_WIDE_NUMBERS_H
#define TEST_INTRINSIC_TRIANGULATIONS_WIDE_NUMBERS_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Multiquadratic_number.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

// Numbers of many bits, see `Mpfr_precision`, with a bound on their error: `Ball` is tested against rational numbers.

namespace wide_numbers {

namespace IT = CGAL::Intrinsic_triangulations;
using Wide = IT::Ball<IT::Mpfr_number>;

inline Wide wide(const CGAL::Gmpq& x) {
  return x == CGAL::Gmpq(0) ? Wide() : Wide::around(IT::Mpfr_number::nearest(x), 0);
}
inline Wide wide(const IT::Multiquadratic_number& x) {
  return x.value([](const CGAL::Gmpq& q) { return wide(q); });
}

inline bool may_be_zero(const Wide& x) {
  const CGAL::Uncertain<CGAL::Sign> s = x.sign();
  return !CGAL::is_certain(s) || CGAL::get_certain(s) == CGAL::ZERO;
}
inline bool may_be_below(const Wide& x, const Wide& y) {
  const CGAL::Uncertain<CGAL::Sign> s = (y - x).sign();
  return !CGAL::is_certain(s) || CGAL::get_certain(s) != CGAL::NEGATIVE;
}

} // namespace wide_numbers

#endif // TEST_INTRINSIC_TRIANGULATIONS_WIDE_NUMBERS_H
