// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_LAMBDA_VALUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_LAMBDA_VALUES_H

#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Penner_coordinates.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds the lambda length that a flip makes.
\tparam FT a model of `FieldNumber`
*/
template <FieldNumber FT>
struct Flipped_lambda {
  FT lambda;   ///< the lambda length
  FT unscaled; ///< without factors of vertices; the same if there are none
};

/*!
\brief stores one lambda length per edge, with and without factors of vertices.

A vertex is scaled by moving its horocycle, which multiplies the lambda lengths of its edges by a
factor. Flips change the lambda lengths without factors, too. So errors do not add up from one
scaling to the next, and with exact numbers, factors of one restore all values.

A power of two that all factors share goes to the exponent of the unit, which is exact: products of
scaled lengths overflow only where factors differ from each other, not where all are large.
\tparam FT a model of `FieldNumber`
*/
template <FieldNumber FT>
class Lambda_values {
public:
  /// constructs no values.
  Lambda_values() = default;
  /// takes lambda lengths. \param scale_exponent, lambdas see `scale_exponent()`, `lambda()`
  Lambda_values(int scale_exponent, std::vector<FT> lambdas)
      : lambda_(std::move(lambdas)), scale_exponent_(scale_exponent) {}

  /// The new values of a flip.
  using Flipped = Flipped_lambda<FT>;
  /// returns what a flip of the edge will replace; storing it takes the flip back.
  Flipped before_flip(const Diamond& d) const { return {lambda_[d.ij], unscaled_lambda(d.ij)}; }

  /// tells whether an edge can be flipped: always.
  static bool is_flippable(const Diamond&) { return true; }

  /// sets the factors of vertices, by row. Call `scale()` for all edges next.
  /// \param rests what rounding took from each factor; none: nothing
  void set_factors(std::span<const double> factors, std::span<const double> rests = {}) {
    factors_.assign(factors.begin(), factors.end());
    rests_.assign(rests.begin(), rests.end());
    shared_exponent_ = 0;
    if (factors_.empty()) return;
    const auto [least, most] = std::minmax_element(factors_.begin(), factors_.end());
    shared_exponent_ = (std::ilogb(*least) + std::ilogb(*most)) / 2;
    for (std::vector<double>* values : {&factors_, &rests_})
      for (double& x : *values) x = std::ldexp(x, -shared_exponent_);
  }
  /// multiplies the lambda length of an edge by the factors of its ends, given by row.
  void scale(std::uint32_t e, std::uint32_t from, std::uint32_t to) {
    if (unscaled_.empty()) unscaled_ = lambda_;
    lambda_[e] = scaled(unscaled_[e], from, to);
  }
  /// returns the factor of a vertex, by row, rounded.
  double factor(std::uint32_t row) const {
    return factors_.empty() ? 1 : std::ldexp(factors_[row], shared_exponent_);
  }

  /// returns the factors of vertices, by row, up to a power of two; none: all one.
  const std::vector<double>& relative_factors() const { return factors_; }
  /// returns what rounding took from them; none: nothing.
  const std::vector<double>& rests() const { return rests_; }

  /// returns the lambda length of an edge, in scaled units: lengths times 2^scale_exponent().
  const FT& lambda(std::uint32_t e) const { return lambda_[e]; }
  /// returns the lambda length of an edge without factors of vertices, in the scaled units of the
  /// input.
  const FT& unscaled_lambda(std::uint32_t e) const {
    return is_scaled() ? unscaled_[e] : lambda_[e];
  }
  /// returns the lambda lengths of a diamond.
  Ideal_diamond_values<FT> values(const Diamond& d) const { return gather(d, lambda_); }
  /// returns a double near the lambda length of an edge, in scaled units.
  double approximate_lambda(std::uint32_t e) const { return CGAL::to_double(lambda_[e]); }
  /// returns s, where lengths are scaled by 2^s: those of the input, until there are factors.
  int scale_exponent() const { return scale_exponent_ - 2 * shared_exponent_; }

  /// returns how predicates were decided, which may be reset.
  Predicate_statistics& statistics() const { return statistics_; }

  /// multiplies a lambda length by the factors of its ends, given by row, in the units of
  /// `lambda()`.
  template <class Number>
  Number scaled(const Number& lambda, std::uint32_t from, std::uint32_t to) const {
    if (factors_.empty()) return lambda;
    if (rests_.empty()) return lambda * (Number(factors_[from]) * Number(factors_[to]));
    return lambda * ((Number(factors_[from]) + Number(rests_[from])) *
                     (Number(factors_[to]) + Number(rests_[to])));
  }

protected:
  /// tells whether factors were ever set.
  bool is_scaled() const { return !unscaled_.empty(); }
  /// returns the lambda lengths of a diamond without factors of vertices. \pre `is_scaled()`
  Ideal_diamond_values<FT> unscaled_values(const Diamond& d) const { return gather(d, unscaled_); }
  /// stores the lambda lengths of an edge; a better enclosure of the same value is no change.
  void store(std::uint32_t e, Flipped n) const noexcept {
    lambda_[e] = std::move(n.lambda);
    if (is_scaled()) unscaled_[e] = std::move(n.unscaled);
  }

private:
  static Ideal_diamond_values<FT> gather(const Diamond& d, const std::vector<FT>& of) {
    return {of[d.ij], of[d.jk], of[d.ki], of[d.im], of[d.mj]};
  }

  // mutable: of an exact metric, they are enclosures
  mutable std::vector<FT> lambda_;
  mutable std::vector<FT> unscaled_; // empty before the first factors
  std::vector<double> factors_;      // by row, without what they share; empty: all one
  std::vector<double> rests_;        // of them; empty: none
  int shared_exponent_ = 0;
  int scale_exponent_ = 0;
  mutable Predicate_statistics statistics_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_LAMBDA_VALUES_H
