// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_INTEGER_ONLY_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_INTEGER_ONLY_TRAITS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/formulas/nonnegative_intervals.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>

#include <optional>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief stores no values: each predicate rebuilds those that it needs from where edges run on the
input.

Intervals of doubles, evaluated on the figure of `Exact_values`, decide nearly all signs; the same
figure decides the others exactly (see `Exact_ladder`). All predicates take `Exact_values` as their
last argument. All members but the constructors and `Scope` require a live `Scope`.
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

  /// tells whether the angles opposite the edge sum to at most pi.
  template <class Exact>
  bool is_locally_delaunay(const Diamond& d, const Exact& exact) const {
    ++statistics_.checks;
    Diamond_values<FT> v = exact.values(d);
    const bool are_right = left_cotangent_numerator(v).inf() >= 0 &&
                           right_cotangent_numerator(v).inf() >= 0; // areas do not matter
    return are_right || sign(d, Delaunay_expression(), exact, v) != NEGATIVE;
  }
  /// returns the exact sign of an expression in the values of a diamond, of any degree.
  /// \tparam Expression a model of `DiamondExpression`
  template <class Expression, class Exact>
  Sign sign(const Diamond& d, const Expression& expression, const Exact& exact) const {
    Diamond_values<FT> v = exact.values(d);
    return sign(d, expression, exact, v);
  }
  /// returns the exact sign of an expression in the values of faces, of any degree.
  /// \tparam Expression a model of `FaceExpression`
  template <class Expression, class Exact>
  Sign sign(std::span<const Indexed_face> faces, const Expression& expression,
            const Exact& exact) const {
    std::vector<Face_values<FT>> v = exact.values(faces);
    if (const auto s = certain_sign(expression(std::span<const Face_values<FT>>(v)))) return *s;
    ++statistics_.filter_failures;
    return exact.sign(faces, Recorded_face_expression(expression, faces.size()), v, statistics_);
  }

  /// tells whether all faces are known to have positive areas: then diamonds of edges that are not
  /// locally Delaunay are convex.
  bool has_only_positive_areas() const { return has_only_positive_areas_; }
  /// computes nothing: flips of strictly convex diamonds are always done.
  static std::optional<Flipped> compute_flip(const Diamond&) { return Flipped(); }
  /// stores nothing.
  void store_flip(const Diamond&, const Flipped&) {}

  /// returns s, where coordinates are scaled by 2^s.
  int scale_exponent() const { return scale_exponent_; }
  /// returns how predicates were decided, which may be reset.
  Predicate_statistics& statistics() const { return statistics_; }

private:
  template <class Expression, class Exact>
  Sign sign(const Diamond& d, const Expression& expression, const Exact& exact,
            Diamond_values<FT>& values) const {
    if (const std::optional<Sign> s = certain_sign(expression(values))) return *s;
    ++statistics_.filter_failures;
    return exact.sign(d, recorded(expression), values, statistics_);
  }

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
  /// Stores no values and decides.
  using Metric = Integer_only_metric;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_INTEGER_ONLY_TRAITS_H
