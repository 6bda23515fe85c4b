// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_EVALUATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_EVALUATION_H

#include <CGAL/Intrinsic_triangulations/metric/Diamond.h>
#include <CGAL/Intrinsic_triangulations/metric/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/metric/History_evaluator.h>
#include <CGAL/Intrinsic_triangulations/metric/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/metric/Multiquadratic_number.h>
#include <CGAL/Intrinsic_triangulations/metric/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/metric/Zero_test.h>

#include <CGAL/Gmpfi.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <array>
#include <cstddef>
#include <utility>

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

/*!
\brief decides signs that floating point intervals leave open.

Values are recomputed from the input in intervals of 128 bits. If the sign is still open, a
`Zero_test` tells whether the value is zero. If it is not, the precision is doubled until the sign
shows, which must happen.
*/
class Exact_evaluation {
public:
  /// A slot of a version of a face.
  using Side = Flip_history::Side;

  /*!
  \brief returns the sign of an expression in the values of the diamond between two sides.
  \param input the input
  \param history the flips since
  \param left side on the left
  \param right side on the right, glued to `left`
  \param expression the expression
  \param better set to intervals that contain the values, about as small as doubles allow
  \param statistics counts how the sign was decided
  */
  template <class Expression>
  Sign sign(const Input_metric& input, const Flip_history& history, Side left, Side right,
            const Expression& expression, Diamond_values<Interval_nt<false>>& better,
            Predicate_statistics& statistics) {
    if (values_.size() > maximal_memory) values_ = {};
    Uncertain<Sign> s =
        interval_sign(input, history, left, right, expression, better, values_, 128);
    unsigned bits = 128;
    if (!is_certain(s)) {
      switch (Zero_test(input, history, left, right)(expression)) {
      case Zero_test::Answer::zero:
        ++statistics.certified_zero;
        return ZERO;
      case Zero_test::Answer::probably_zero:
        ++statistics.probable_zero;
        return ZERO;
      case Zero_test::Answer::not_zero: break;
      }
    }
    while (!is_certain(s)) {
      bits *= 2;
      History_values<Gmpfi> fresh;
      s = interval_sign(input, history, left, right, expression, better, fresh, bits);
    }
    ++statistics.escalations[bits];
    return get_certain(s);
  }

private:
  // values that are kept between calls, about 400 bytes each
  static constexpr std::size_t maximal_memory = 100000;

  template <class Expression>
  static Uncertain<Sign> interval_sign(const Input_metric& input, const Flip_history& history,
                                       Side left, Side right, const Expression& expression,
                                       Diamond_values<Interval_nt<false>>& better,
                                       History_values<Gmpfi>& values, unsigned bits) {
    const Gmpfi_precision precision(bits);
    const auto face = [&input](std::uint32_t f) {
      return std::pair<std::array<Gmpfi, 3>, Gmpfi>(
          {Gmpfi(input.squared_length<Gmpq>(f, 0)), Gmpfi(input.squared_length<Gmpq>(f, 1)),
           Gmpfi(input.squared_length<Gmpq>(f, 2))},
          Gmpfi(input.squared_quadruple_area<Gmpq>(f)).sqrt());
    };
    History_evaluator<Gmpfi, decltype(face)> evaluator(history, face, values);
    const Diamond_values<Gmpfi> d = evaluator.diamond(left, right);
    better = {interval(d.ij), interval(d.jk),     interval(d.ki),    interval(d.im),
              interval(d.mj), interval(d.area_f), interval(d.area_g)};
    return expression(d).sign();
  }

  static Interval_nt<false> interval(const Gmpfi& x) {
    const std::pair<double, double> i = x.to_interval();
    return {i.first, i.second};
  }

  History_values<Gmpfi> values_; // at 128 bits
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_EVALUATION_H
