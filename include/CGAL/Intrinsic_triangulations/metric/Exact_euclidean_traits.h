// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_EUCLIDEAN_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_EUCLIDEAN_TRAITS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/metric/Diamond.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_evaluation.h>
#include <CGAL/Intrinsic_triangulations/metric/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/metric/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/metric/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/metric/initial_values.h>
#include <CGAL/Intrinsic_triangulations/metric/input_diamond_sign.h>
#include <CGAL/Intrinsic_triangulations/metric/nonnegative_intervals.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief stores the metric as intervals that contain the exact values, and decides exactly.

A predicate is evaluated in interval arithmetic (the filter). Where that leaves the sign open, the
values are recomputed from the input by the history of flips, in multi-precision intervals of 128,
256, ... bits, between which exact arithmetic tells whether the value is zero: see
`Exact_evaluation`. Better intervals found on the way replace the stored ones.

All members but the constructors and `Scope` ask for a live `Scope`, which sets the rounding mode
that interval arithmetic needs.
\cgalModels{IntrinsicMetric}
*/
class Exact_euclidean_metric {
public:
  /// Number type of the stored values.
  using FT = Interval_nt<false>;
  /// Keeps the floating point unit rounding upwards.
  using Scope = Protect_FPU_rounding<true>;
  /// Predicates are exact: algorithms end without a cap.
  static constexpr bool is_exact = true;
  /// Version of a face and the edge in its slot 0, which must not be in another slot too. If slots 1
  /// and 2 have the same edge, they may be taken for each other: they have the same length.
  using Version = std::pair<std::uint32_t, std::uint32_t>;

  /// constructs an empty metric.
  Exact_euclidean_metric() = default;

  /*!
  \brief evaluates the input in interval arithmetic and keeps it for exact evaluation.
  \pre no face of `mesh` has the edge of `halfedge(face)` twice
  \throws Invalid_input see `quadruple_area()`
  \complexity linear
  */
  Exact_euclidean_metric(const Gluing_map& mesh, std::shared_ptr<const Input_metric> input)
      : input_(std::move(input)), history_(input_->number_of_faces()) {
    const Scope scope;
    squared_length_ = Intrinsic_triangulations::squared_lengths<FT>(*input_, mesh);
    quadruple_area_ = Intrinsic_triangulations::quadruple_areas<FT>(*input_);
    length_.reserve(squared_length_.size());
    area_.reserve(quadruple_area_.size());
    for (const FT& x : squared_length_) length_.push_back(CGAL::to_double(x));
    for (const FT& x : quadruple_area_) area_.push_back(CGAL::to_double(x));
    sides_.reserve(input_->number_of_faces());
    for (std::uint32_t f = 0; f < input_->number_of_faces(); ++f)
      sides_.push_back({f, mesh.halfedge(Gluing_map::Face{f}).index / 2});
  }

  /*!
  \brief restores a metric from what its accessors return.
  \pre the intervals contain the values that `input` and `history` define
  */
  Exact_euclidean_metric(std::shared_ptr<const Input_metric> input, Flip_history history,
                         std::vector<Version> versions, std::vector<FT> squared_lengths,
                         std::vector<FT> quadruple_areas, std::vector<double> lengths,
                         std::vector<double> areas)
      : squared_length_(std::move(squared_lengths)), quadruple_area_(std::move(quadruple_areas)),
        length_(std::move(lengths)), area_(std::move(areas)), sides_(std::move(versions)),
        input_(std::move(input)), history_(std::move(history)) {}

  /// tells whether the angles opposite the edge sum to at most pi.
  bool is_locally_delaunay(const Diamond& d) {
    ++statistics_.checks;
    const FT& ij = squared_length_[d.ij];
    const FT q_f = squared_length_[d.jk] + squared_length_[d.ki] - ij;
    const FT q_g = squared_length_[d.im] + squared_length_[d.mj] - ij;
    // both angles at most a right one: areas do not matter
    if (q_f.inf() >= 0 && q_g.inf() >= 0) return true;
    const FT value = delaunay_value(q_f, quadruple_area_[d.f], q_g, quadruple_area_[d.g]);
    if (value.inf() >= 0) return true;
    if (value.sup() < 0) return false;
    return exact_sign(d, Delaunay_expression()) != NEGATIVE;
  }

  /*!
  \brief returns the exact sign of an expression in the values of a diamond.
  \tparam Expression a functor with a template `operator()(const Diamond_values<Number>&)`
  */
  template <class Expression>
  Sign sign(const Diamond& d, const Expression& expression) {
    const FT value = expression(values(d));
    if (value.inf() > 0) return POSITIVE;
    if (value.sup() < 0) return NEGATIVE;
    if (value.inf() == 0 && value.sup() == 0) return ZERO;
    return exact_sign(d, expression);
  }

  /// What a flip makes: intervals, and the doubles that are kept beside them.
  struct Flipped {
    Flipped_values<FT> enclosure;         ///< intervals that contain the values
    Flipped_values<double> approximation; ///< values in floating point
  };

  /*!
  \brief computes a flip and changes nothing.
  \return the new values, always
  \pre the diamond is strictly convex
  */
  std::optional<Flipped> compute_flip(const Diamond& d) const {
    return Flipped{flipped_nonnegative(values(d)), flipped(approximations(d))};
  }

  /*!
  \brief computes a flip that makes the right face, of the source of the edge, a face of zero area.
  \pre the diamond is a triangle with the source of the edge on a side
  */
  std::optional<Flipped> compute_flip_to_zero_area(const Diamond& d) const {
    std::optional<Flipped> n = compute_flip(d);
    n->enclosure.area_f = quadruple_area_[d.f] + quadruple_area_[d.g];
    n->enclosure.area_g = FT(0);
    n->approximation.area_f = area_[d.f] + area_[d.g];
    n->approximation.area_g = 0;
    return n;
  }

  /*!
  \brief stores a flip and records it in the history.
  \param d the diamond
  \param n what `compute_flip()` returned for it
  */
  void store_flip(const Diamond& d, const Flipped& n) {
    const auto& [enclosure, approximation] = n;
    squared_length_[d.ij] = positive_part(enclosure.km);
    quadruple_area_[d.f] = positive_part(enclosure.area_f);
    quadruple_area_[d.g] = positive_part(enclosure.area_g);
    length_[d.ij] = nearest(approximation.km, squared_length_[d.ij]);
    area_[d.f] = nearest(approximation.area_f, quadruple_area_[d.f]);
    area_[d.g] = nearest(approximation.area_g, quadruple_area_[d.g]);
    const std::uint32_t version = history_.record_flip(left_side(d), right_side(d));
    sides_[d.f] = {version, d.ij};
    sides_[d.g] = {version + 1, d.ij};
  }

  /// tells whether the area of a face is zero; exact for an input face.
  bool is_degenerate(std::uint32_t f) const { return quadruple_area_[f].sup() <= 0; }
  /// tells whether the length of an edge is zero; exact for an input edge.
  bool is_zero_length(std::uint32_t e) const { return squared_length_[e].sup() <= 0; }
  /// returns an interval that contains the squared length of an edge, in scaled units.
  const FT& squared_length(std::uint32_t e) const { return squared_length_[e]; }
  /// returns an interval that contains the quadruple area of a face, in scaled units.
  const FT& quadruple_area(std::uint32_t f) const { return quadruple_area_[f]; }
  /// returns a double near the squared length of an edge, in scaled units.
  double approximate_squared_length(std::uint32_t e) const { return length_[e]; }
  /// returns a double near the quadruple area of a face, in scaled units.
  double approximate_quadruple_area(std::uint32_t f) const { return area_[f]; }
  /// returns s, where coordinates are scaled by 2^s.
  int scale_exponent() const { return input_->scale_exponent(); }
  /// returns the input, which defines all values exactly.
  const Input_metric& input() const { return *input_; }
  /// returns the version of face `f`.
  const Version& version(std::uint32_t f) const { return sides_[f]; }
  /// returns the flips done so far.
  const Flip_history& history() const { return history_; }
  /// returns how predicates were decided.
  const Predicate_statistics& statistics() const { return statistics_; }
  /// returns how predicates were decided, to be reset.
  Predicate_statistics& statistics() { return statistics_; }

  /*!
  \brief returns (cot k + cot m) / 2 for the angles opposite an edge between two faces.

  Zero exactly where the sum of the angles is pi, and of the right sign everywhere.
  \pre both faces have an area
  */
  double cotangent_weight(const Diamond& d) {
    const Sign s = sign(d, Delaunay_expression());
    if (s == ZERO) return 0;
    if (is_vague(quadruple_area_[d.f]) || is_vague(quadruple_area_[d.g])) sharpen(d);
    const double weight =
        cotangent_weight(d.ij, d.jk, d.ki, d.f) + cotangent_weight(d.ij, d.im, d.mj, d.g);
    return s == POSITIVE ? std::max(weight, 0.0) : std::min(weight, 0.0);
  }

  /// returns half the cotangent of the angle opposite side `ij` of face `f` with sides ij, jk, ki.
  double cotangent_weight(std::uint32_t ij, std::uint32_t jk, std::uint32_t ki,
                          std::uint32_t f) const {
    return (length_[jk] + length_[ki] - length_[ij]) / (2 * area_[f]);
  }

private:
  Diamond_values<FT> values(const Diamond& d) const {
    return {squared_length_[d.ij], squared_length_[d.jk], squared_length_[d.ki],
            squared_length_[d.im], squared_length_[d.mj], quadruple_area_[d.f],
            quadruple_area_[d.g]};
  }

  Diamond_values<double> approximations(const Diamond& d) const {
    return {length_[d.ij], length_[d.jk], length_[d.ki], length_[d.im],
            length_[d.mj], area_[d.f],    area_[d.g]};
  }

  Flip_history::Side left_side(const Diamond& d) const { return side(d.f, d.ij, d.jk); }
  Flip_history::Side right_side(const Diamond& d) const { return side(d.g, d.ij, d.im); }
  Flip_history::Side side(std::uint32_t f, std::uint32_t edge, std::uint32_t next_edge) const {
    const auto& [version, first] = sides_[f];
    return {version, first == edge ? 0U : first == next_edge ? 2U : 1U};
  }

  // Lengths and areas are never negative, whatever rounding makes of the lower bound.
  static FT positive_part(const FT& x) { return {std::max(x.inf(), 0.0), x.sup()}; }

  template <class Expression>
  Sign exact_sign(const Diamond& d, const Expression& expression) {
    ++statistics_.filter_failures;
    const Flip_history::Side left = left_side(d), right = right_side(d);
    if (history_.is_input(left.version) && history_.is_input(right.version))
      if (const std::optional<Sign> s = input_diamond_sign(*input_, left, right, expression)) {
        ++(*s == ZERO ? statistics_.certified_zero : statistics_.integer);
        return *s;
      }
    Diamond_values<FT> better;
    const Sign s =
        evaluation_.sign(*input_, history_, left, right, expression, better, statistics_);
    refine(d, better);
    return s;
  }

  // too wide for its approximation to be worth anything
  static bool is_vague(const FT& x) { return x.sup() - x.inf() > 0x1p-10 * x.sup(); }

  void sharpen(const Diamond& d) {
    refine(d, evaluation_.enclosure(*input_, history_, left_side(d), right_side(d)));
  }

  void refine(const Diamond& d, const Diamond_values<FT>& better) {
    refine(squared_length_[d.ij], length_[d.ij], better.ij);
    refine(squared_length_[d.jk], length_[d.jk], better.jk);
    refine(squared_length_[d.ki], length_[d.ki], better.ki);
    refine(squared_length_[d.im], length_[d.im], better.im);
    refine(squared_length_[d.mj], length_[d.mj], better.mj);
    refine(quadruple_area_[d.f], area_[d.f], better.area_f);
    refine(quadruple_area_[d.g], area_[d.g], better.area_g);
  }

  static void refine(FT& stored, double& approximation, const FT& better) {
    stored = FT(std::max(stored.inf(), better.inf()), std::min(stored.sup(), better.sup()));
    approximation = nearest(approximation, stored);
  }

  static double nearest(double x, const FT& interval) {
    return std::min(std::max(x, interval.inf()), interval.sup());
  }

  std::vector<FT> squared_length_;
  std::vector<FT> quadruple_area_;
  // The middle of an interval that has grown wide is a poor approximation; doubles that are computed
  // beside it, and kept within it, are a good one.
  std::vector<double> length_; // squared
  std::vector<double> area_;   // quadruple
  std::vector<Version> sides_;
  std::shared_ptr<const Input_metric> input_; // immutable, shared by copies
  Flip_history history_;
  Exact_evaluation evaluation_;
  Predicate_statistics statistics_;
};

/*!
\brief lets an intrinsic triangulation decide every predicate exactly.
\cgalModels{IntrinsicTriangulationTraits}
*/
struct Exact_euclidean_traits {
  /// Number type of the stored values.
  using FT = Interval_nt<false>;
  /// Stores the values and decides.
  using Metric = Exact_euclidean_metric;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_EUCLIDEAN_TRAITS_H
