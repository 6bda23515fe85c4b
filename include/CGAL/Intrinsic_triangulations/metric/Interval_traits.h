// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_INTERVAL_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_INTERVAL_TRAITS_H

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/nonnegative_intervals.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>

#include <CGAL/Interval_nt.h>

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief stores the metric as intervals that contain the exact values, and decides where they can.

This is only the filter of `Exact_euclidean_metric`. Its decisions are right; an edge that intervals
leave open is not flipped, and `statistics().undecided` counts it. So flipping to Delaunay ends, as
with exact traits. Undecided edges may be ties, close to ties, or far from them once intervals have
grown wide. A flip is refused unless intervals show that the new areas are positive.

All members except the constructors and `Scope` require a live `Scope`, which sets the rounding mode
of interval arithmetic.
\cgalModels{EuclideanMetric}
*/
class Interval_metric : public Euclidean_metric<Interval_nt<false>> {
  using Base = Euclidean_metric<Interval_nt<false>>;

public:
  /// Number type of the stored values.
  using FT = Interval_nt<false>;
  /// Keeps the floating point unit rounding upwards.
  using Scope = Protect_FPU_rounding<true>;
  /// Some predicates stay open.
  static constexpr bool is_exact = false;

  /// constructs an empty metric.
  Interval_metric() = default;

  /*!
  \brief encloses the input.
  \throws Invalid_input see `quadruple_area()`
  \complexity linear
  */
  Interval_metric(const Gluing_map& mesh, const Input_metric& input)
      : Base(evaluate(mesh, input)) {}

  /// restores a metric from its stored values.
  Interval_metric(int scale_exponent, std::vector<FT> squared_lengths,
                  std::vector<FT> quadruple_areas)
      : Base(scale_exponent, std::move(squared_lengths), std::move(quadruple_areas)) {}

  /// tells whether the angles opposite the edge sum to at most pi, or intervals leave it open.
  bool is_locally_delaunay(const Diamond& d) const {
    ++statistics().checks;
    const auto [q_f, q_g] = numerators(d);
    const Certainty c = certain_delaunay(q_f, quadruple_area(d.f), q_g, quadruple_area(d.g));
    if (c == Certainty::open) ++statistics().undecided; // as where a bound is not a number
    return c != Certainty::no;
  }

  /// returns the sign of an expression in the values of a diamond; zero, too, if intervals leave it
  /// open.
  template <class Expression>
  Sign sign(const Diamond& d, const Expression& expression) const {
    return sign_of(expression(values(d)));
  }

  /// returns the sign of an expression in the values of faces; zero, too, if intervals leave it
  /// open.
  template <class Expression>
  Sign sign(std::span<const Indexed_face> faces, const Expression& expression) const {
    const auto v = values(faces);
    return sign_of(expression(std::span<const Face_values<FT>>(v.data(), v.size())));
  }

  /*!
  \brief computes a flip.
  \return nothing unless bounds are finite and intervals show that both areas are positive
  */
  std::optional<Flipped> compute_flip(const Diamond& d) const {
    std::optional<Flipped> n = Base::compute_flip(d);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (n && !(n->km.sup() < infinity && n->area_f.sup() < infinity && n->area_g.sup() < infinity))
      n.reset();
    return n;
  }

private:
  static Base evaluate(const Gluing_map& mesh, const Input_metric& input) {
    const Scope scope;
    return Base(mesh, input);
  }

  Sign sign_of(const FT& value) const {
    const std::optional<Sign> s = certain_sign(value);
    if (!s) ++statistics().undecided;
    return s.value_or(ZERO);
  }
};

/*!
\brief lets an intrinsic triangulation compute in intervals of doubles only.
\cgalModels{IntrinsicTriangulationTraits}
*/
struct Interval_traits {
  /// Number type of the stored values.
  using FT = Interval_nt<false>;
  /// Stores the values and decides.
  using Metric = Interval_metric;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_INTERVAL_TRAITS_H
