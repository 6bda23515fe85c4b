// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_ESCALATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_ESCALATION_H

#include <CGAL/Intrinsic_triangulations/metric/Diamond.h>
#include <CGAL/Intrinsic_triangulations/metric/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/metric/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/metric/Zero_answer.h>

#include <CGAL/Gmpfi.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <array>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

/*!
\file
Signs in multi-precision intervals, with more bits until they show.
*/

namespace CGAL::Intrinsic_triangulations {

/// sets the precision of `Gmpfi` for a lifetime.
class Gmpfi_precision {
public:
  /// sets the precision to `bits`.
  explicit Gmpfi_precision(unsigned bits) : previous_(Gmpfi::set_default_precision(bits)) {}
  /// restores the precision.
  ~Gmpfi_precision() { Gmpfi::set_default_precision(previous_); }
  Gmpfi_precision(const Gmpfi_precision&) = delete;
  Gmpfi_precision& operator=(const Gmpfi_precision&) = delete;

private:
  Gmpfi::Precision_type previous_;
};

namespace internal {

// precision at which a value that is probably zero is taken for zero
inline constexpr unsigned maximal_probable_bits = 1024;

// whether a value that may be zero is taken for zero instead of computing it in so many bits
inline bool gives_up(Zero_answer answer, unsigned bits) {
  if (answer == Zero_answer::probably_zero) return bits > maximal_probable_bits;
  if (bits <= (1U << 20)) return false;
  throw std::logic_error("a value that was proven not to be zero shows no sign at 2^20 bits; "
                         "please report this with the mesh");
}

// returns a functor from an input face to its squared lengths and quadruple area, in the default precision
inline auto gmpfi_input_values(const Input_metric& input) {
  return [&input](std::uint32_t f) {
    return std::pair<std::array<Gmpfi, 3>, Gmpfi>(
        {Gmpfi(input.squared_length<Gmpq>(f, 0)), Gmpfi(input.squared_length<Gmpq>(f, 1)),
         Gmpfi(input.squared_length<Gmpq>(f, 2))},
        Gmpfi(input.squared_quadruple_area<Gmpq>(f)).sqrt());
  };
}

inline Interval_nt<false> interval(const Gmpfi& x) {
  const std::pair<double, double> i = x.to_interval();
  return Interval_nt<false>(i.first, i.second);
}

inline Diamond_values<Interval_nt<false>> intervals(const Diamond_values<Gmpfi>& d) {
  return {interval(d.ij), interval(d.jk),     interval(d.ki),    interval(d.im),
          interval(d.mj), interval(d.area_f), interval(d.area_g)};
}

/*
Returns the sign of an expression in the values of a diamond, of which `answer` is known. `values()` computes
them in the default precision, which is `bits` first and is doubled until the sign shows, which must happen
if the value is proven not to be zero. `better` is set to intervals that contain the values, all reals
if nothing was computed.
*/
template <class Values, class Expression>
Sign escalated_sign(Zero_answer answer, unsigned bits, const Values& values,
                    const Expression& expression, Diamond_values<Interval_nt<false>>& better,
                    Predicate_statistics& statistics) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Interval_nt<false> unknown(-infinity, infinity);
  better = {unknown, unknown, unknown, unknown, unknown, unknown, unknown};
  if (answer == Zero_answer::zero) {
    ++statistics.certified_zero;
    return ZERO;
  }
  for (; !gives_up(answer, bits); bits *= 2) {
    const Gmpfi_precision precision(bits);
    const Diamond_values<Gmpfi> d = values();
    better = intervals(d);
    const Uncertain<Sign> s = expression(d).sign();
    if (is_certain(s)) {
      ++statistics.escalations[bits];
      return get_certain(s);
    }
  }
  ++statistics.probable_zero;
  return ZERO;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_ESCALATION_H
