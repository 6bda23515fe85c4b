// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_INTEGER_ONLY_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_INTEGER_ONLY_TRAITS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/nonnegative_intervals.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Interval_nt.h>

#include <optional>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief stores no values: a decider rebuilds those that a predicate needs from where edges run on the
input, see `Intrinsic_triangulation::decider()`.

All members but the constructors and `Scope` require a live `Scope`.
\cgalModels{IntrinsicMetric}
*/
class Integer_only_metric {
public:
  /// Number type of the filter.
  using FT = Interval_nt<false>;
  /// Keeps the floating point unit rounding upwards.
  using Scope = Protect_FPU_rounding<true>;
  /// Predicates are exact: algorithms end without a cap.
  static constexpr bool is_exact = true;
  /// A flip makes no values.
  struct Flipped {};

  /// constructs an empty metric.
  Integer_only_metric() = default;
  /// takes the scale of an input whose faces have positive areas.
  Integer_only_metric(const Gluing_map&, const Input_metric& input)
      : Integer_only_metric(input, true) {}
  /// takes the scale of the input. \param has_only_positive_areas whether all faces of the
  /// triangulation are known to have positive areas
  Integer_only_metric(const Input_metric& input, bool has_only_positive_areas)
      : scale_exponent_(input.scale_exponent()), has_only_positive_areas_(has_only_positive_areas) {
  }

  /// knows nothing of an edge.
  Certainty certain_delaunay(const Diamond&) const {
    ++statistics_.checks;
    return Certainty::open;
  }
  /// tells whether all faces are known to have positive areas: then diamonds of edges that are not
  /// locally Delaunay are convex.
  bool has_only_positive_areas() const { return has_only_positive_areas_; }
  /// computes nothing: flips of strictly convex diamonds are always done.
  static std::optional<Flipped> compute_flip(const Diamond&) { return Flipped(); }
  /// stores nothing.
  void store_flip(const Diamond&, const Flipped&) noexcept {}

  /// returns s, where coordinates are scaled by 2^s.
  int scale_exponent() const { return scale_exponent_; }
  /// returns how predicates were decided, which may be reset.
  Predicate_statistics& statistics() const { return statistics_; }

private:
  int scale_exponent_ = 0;
  bool has_only_positive_areas_ = false; // false: unknown
  mutable Predicate_statistics statistics_;
};

/*!
\brief lets an intrinsic triangulation store integers only; see `Integer_only_triangulation`.
\cgalModels{IntrinsicTriangulationTraits}
*/
struct Integer_only_traits {
  /// Number type of the filter.
  using FT = Interval_nt<false>;
  /// Stores no values.
  using Metric = Integer_only_metric;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_INTEGER_ONLY_TRAITS_H
