// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_IDEAL_HYPERBOLIC_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_IDEAL_HYPERBOLIC_TRAITS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Penner_coordinates.h>
#include <CGAL/Intrinsic_triangulations/formulas/nonnegative_intervals.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/metric/Lambda_values.h>
#include <CGAL/Intrinsic_triangulations/metric/Remembered_signs.h>
#include <CGAL/Intrinsic_triangulations/metric/nearest_lengths.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>

#include <boost/config.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief stores an ideal hyperbolic metric as intervals that contain the exact lambda lengths, and
answers what these prove.

A decider answers the rest: the triangulation that owns the metric has one, which knows where edges
run on the input, see `Intrinsic_triangulation::decider()`. There are no square roots: the double
nearest to a length defines the lambda length of an input edge, and factors of vertices are doubles.

Stored intervals are a cache, so that `refine()` is const. There are no locks: not even predicates
of one metric may run in two threads at a time. All members except the constructors and `Scope`
require a live `Scope`.
\cgalModels{IntrinsicMetric}
*/
class Exact_ideal_hyperbolic_metric : public Lambda_values<Interval_nt<false>> {
  using Base = Lambda_values<Interval_nt<false>>;

public:
  /// Number type of the stored values.
  using FT = Interval_nt<false>;
  /// Keeps the floating point unit rounding upwards.
  using Scope = Protect_FPU_rounding<true>;
  /// Predicates are exact: algorithms end without a cap.
  static constexpr bool is_exact = true;

  /// constructs an empty metric.
  Exact_ideal_hyperbolic_metric() = default;

  /*!
  \brief takes the lengths of the input, rounded to doubles.
  \throws Invalid_input naming an edge of length zero
  \complexity linear
  */
  Exact_ideal_hyperbolic_metric(const Gluing_map& mesh, const Input_metric& input)
      : Exact_ideal_hyperbolic_metric(input.scale_exponent(), nearest_lengths(input, mesh)) {}

  /// tells whether an edge is ideal Delaunay, if the intervals prove it.
  BOOST_FORCEINLINE Certainty certain_delaunay(const Diamond& d) const {
    ++statistics().checks;
    const std::optional<Sign> s = certain_delaunay_sign(values(d));
    return !s ? Certainty::open : *s == NEGATIVE ? Certainty::no : Certainty::yes;
  }
  /// returns the sign of `Ideal_delaunay_expression`, if intervals prove it: of its two terms,
  /// which is faster.
  static std::optional<Sign> certain_delaunay_sign(const Ideal_diamond_values<FT>& v) {
    const Times_nonnegative times;
    const FT outer = Ideal_delaunay_expression::outer(v, times),
             inner = Ideal_delaunay_expression::inner(v, times);
    if (outer.inf() > inner.sup()) return POSITIVE;
    if (outer.sup() < inner.inf()) return NEGATIVE;
    return std::nullopt;
  }
  /// computes a flip. \return the new values, always
  std::optional<Flipped> compute_flip(const Diamond& d) const {
    const Times_nonnegative times;
    const FT lambda = ptolemy_flip(values(d), times);
    return Flipped{lambda, is_scaled() ? ptolemy_flip(unscaled_values(d), times) : lambda};
  }
  /// stores what `compute_flip()` returned for a diamond.
  void store_flip(const Diamond& d, const Flipped& n) noexcept {
    store(d.ij, n);
    signs_.forget(std::array{d.ij, d.jk, d.ki, d.im, d.mj});
  }

  /// sets the factors of vertices, by row. Call `scale()` for all edges next.
  /// \param rests see `Lambda_values`
  void set_factors(std::span<const double> factors, std::span<const double> rests = {}) {
    Base::set_factors(factors, rests);
    signs_ = {};
  }

  /// returns the lambda lengths of the edges of the input, in scaled units.
  const std::vector<double>& input_lambdas() const { return input_lambda_; }
  /// tells whether the interval of an edge is as narrow as `Enclosed_values::narrow`.
  bool is_narrow(std::uint32_t e) const {
    return lambda(e).sup() - lambda(e).inf() <= 0x1p-41 * lambda(e).inf();
  }
  /// replaces the intervals of the lambda length of an edge. \pre the new ones contain its value
  void refine(std::uint32_t e, const Flipped& better) const { store(e, better); }
  /// returns exact signs of `Ideal_delaunay_expression` for edges whose faces have not changed
  /// since: a cache for deciders. A wrong sign makes predicates wrong.
  Remembered_signs& remembered_signs() const { return signs_; }

private:
  Exact_ideal_hyperbolic_metric(int scale_exponent, std::vector<double> lengths)
      : Base(scale_exponent, {lengths.begin(), lengths.end()}), input_lambda_(std::move(lengths)) {}

  std::vector<double> input_lambda_; // of the edges of the input
  mutable Remembered_signs signs_;
};

/*!
\brief lets an intrinsic triangulation store an ideal hyperbolic metric and decide exactly.
\cgalModels{IntrinsicTriangulationTraits}
*/
struct Exact_ideal_hyperbolic_traits {
  /// Number type of the stored values.
  using FT = Interval_nt<false>;
  /// Stores enclosures of the values.
  using Metric = Exact_ideal_hyperbolic_metric;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_IDEAL_HYPERBOLIC_TRAITS_H
