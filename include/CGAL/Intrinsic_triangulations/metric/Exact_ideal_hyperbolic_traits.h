// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_IDEAL_HYPERBOLIC_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_IDEAL_HYPERBOLIC_TRAITS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Penner_coordinates.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/formulas/nonnegative_intervals.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/metric/Lambda_values.h>
#include <CGAL/Intrinsic_triangulations/metric/Remembered_signs.h>
#include <CGAL/Intrinsic_triangulations/metric/nearest_lengths.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief stores an ideal hyperbolic metric as intervals that contain the exact lambda lengths, and
decides exactly.

Where intervals leave a sign open, the lambda lengths of the diamond are computed anew from where
its edges run on the input, see `lambdas_along_strip()`: in intervals first, which replace the
stored ones, then in balls of 106 bits, then in rational numbers. There are no square roots: the
double nearest to a length defines the lambda length of an input edge, and factors of vertices are
doubles.

Stored intervals are a cache, so that predicates are const. There are no locks: not even predicates
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

  /// tells whether an edge is ideal Delaunay.
  template <class Exact>
  BOOST_FORCEINLINE bool is_locally_delaunay(const Diamond& d, const Exact& exact) const {
    ++statistics().checks;
    const std::optional<Sign> s = filtered_sign(values(d));
    return (s ? *s : exact_sign(d, exact)) != NEGATIVE;
  }
  /// returns the exact sign of `Ideal_delaunay_expression`.
  template <class Exact>
  Sign delaunay_sign(const Diamond& d, const Exact& exact) const {
    const std::optional<Sign> s = filtered_sign(values(d));
    return s ? *s : exact_sign(d, exact);
  }
  /// computes a flip. \return the new values, always
  std::optional<Flipped> compute_flip(const Diamond& d) const {
    const FT lambda = flipped(values(d));
    return Flipped{lambda, is_scaled() ? flipped(unscaled_values(d)) : lambda};
  }
  /// stores what `compute_flip()` returned for a diamond.
  void store_flip(const Diamond& d, const Flipped& n) {
    store(d.ij, n);
    signs_.forget(edges(d));
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
  /// makes the interval of an edge as narrow as its strip of input triangles allows.
  template <class Exact>
  void sharpen(std::uint32_t e, const Exact& exact) const {
    ++statistics().sharpenings[53];
    const FT better = exact.template lambdas<FT>(std::array{e})[0];
    const auto [from, to] = exact.rows(e);
    store(e, {scaled(better, from, to), better});
  }
  /*!
  \brief computes lambda lengths in any number type from where edges run on the input, with factors
  of vertices.
  \tparam Number a model of `FieldNumber`
  \complexity linear in the numbers of crossings
  */
  template <FieldNumber Number, std::size_t n, class Exact>
  std::array<Number, n> lambdas(const std::array<std::uint32_t, n>& edges,
                                const Exact& exact) const {
    std::array<Number, n> result = exact.template lambdas<Number>(edges);
    for (std::size_t k = 0; k < n; ++k) {
      const auto [from, to] = exact.rows(edges[k]);
      result[k] = scaled(result[k], from, to);
    }
    return result;
  }

private:
  using Edges = std::array<std::uint32_t, 5>;
  static Edges edges(const Diamond& d) { return {d.ij, d.jk, d.ki, d.im, d.mj}; }

  Exact_ideal_hyperbolic_metric(int scale_exponent, std::vector<double> lengths)
      : Base(scale_exponent, {lengths.begin(), lengths.end()}), input_lambda_(std::move(lengths)) {}

  static FT flipped(const Ideal_diamond_values<FT>& v) {
    return (product_with_nonnegative(v.jk, v.im) + product_with_nonnegative(v.ki, v.mj)) / v.ij;
  }

  // the two terms of `Ideal_delaunay_expression`, faster
  static std::optional<Sign> filtered_sign(const Ideal_diamond_values<FT>& v) {
    const auto times = [](const FT& a, const FT& b) { return product_with_nonnegative(a, b); };
    const FT outer =
        times(times(v.jk, v.im) + times(v.ki, v.mj), times(v.jk, v.mj) + times(v.ki, v.im));
    const FT inner = times(times(v.ij, v.ij), times(v.jk, v.ki) + times(v.im, v.mj));
    if (outer.inf() > inner.sup()) return POSITIVE;
    if (outer.sup() < inner.inf()) return NEGATIVE;
    return std::nullopt;
  }

  // The power of two that takes the largest lambda length of a diamond near one: the expression, of
  // degree four, overflows in doubles beyond 1e77.
  static double unit(const Ideal_diamond_values<FT>& v) {
    const double most = std::max({v.ij.sup(), v.jk.sup(), v.ki.sup(), v.im.sup(), v.mj.sup()});
    if (!(most <= std::numeric_limits<double>::max())) return 1; // out of range already
    int exponent = 0;
    std::frexp(most, &exponent);
    return std::ldexp(1., std::clamp(-exponent, -1000, 1000));
  }
  template <class Number>
  static Ideal_diamond_values<Number> multiplied(const Ideal_diamond_values<Number>& v, double by) {
    const Number x(by);
    return {v.ij * x, v.jk * x, v.ki * x, v.im * x, v.mj * x};
  }

  // not within the loop that flips
  template <class Exact>
  BOOST_NOINLINE Sign exact_sign(const Diamond& d, const Exact& exact) const {
    ++statistics().filter_failures;
    if (const auto known = signs_.find(d.ij)) {
      if (known->sign == ZERO) ++statistics().certified_zero;
      return known->sign;
    }
    for (const std::uint32_t e : edges(d))
      if (!is_narrow(e)) sharpen(e, exact);
    const Ideal_diamond_values<FT> sharp = values(d);
    if (const std::optional<Sign> s = filtered_sign(multiplied(sharp, unit(sharp)))) {
      ++statistics().escalations[53];
      return *s;
    }
    if (const Uncertain<Sign> s = precise_sign(d, exact); is_certain(s)) {
      ++statistics().escalations[106];
      signs_.remember(d.ij, {s.make_certain(), false});
      return s.make_certain();
    }
    const Sign s = CGAL::sign(Ideal_delaunay_expression()(exact_values<Gmpq>(d, exact)));
    ++(s == ZERO ? statistics().certified_zero : statistics().integer);
    signs_.remember(d.ij, {s, false});
    return s;
  }

  // decides what nearly is a tie because input lengths were rounded
  template <class Exact>
  Uncertain<Sign> precise_sign(const Diamond& d, const Exact& exact) const {
    const double by = unit(values(d));
    const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
    return Ideal_delaunay_expression()(multiplied(exact_values<Ball<Double_double>>(d, exact), by))
        .sign();
  }

  // by strips
  template <class Number, class Exact>
  Ideal_diamond_values<Number> exact_values(const Diamond& d, const Exact& exact) const {
    const std::array<Number, 5> l = lambdas<Number>(edges(d), exact);
    return {l[0], l[1], l[2], l[3], l[4]};
  }

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
  /// Stores the values and decides.
  using Metric = Exact_ideal_hyperbolic_metric;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_IDEAL_HYPERBOLIC_TRAITS_H
