// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_IDEAL_HYPERBOLIC_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_IDEAL_HYPERBOLIC_TRAITS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Penner_coordinates.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/metric/Lambda_values.h>
#include <CGAL/Intrinsic_triangulations/metric/nearest_lengths.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/long_double.h>
#include <CGAL/number_utils.h>

#include <boost/config.hpp>

#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief stores an ideal hyperbolic metric with horocycles: one lambda length per edge, see
`Penner_coordinates.h`.

The lambda lengths of the input are its edge lengths, each rounded to the nearest double: they
define the metric exactly. They need not satisfy triangle inequalities. Every edge between two faces
can be flipped, and there are no areas.

It is exact iff `FT` is. With an inexact type, rounding decides near ties, and a cap on the number
of flips ends algorithms. Lambda lengths must be in the range of the type after scaling.
\tparam FT_ a CGAL number type: a field. With `Interval_nt<false>`, all members but the constructors
and `Scope` require a live `Scope`; an edge that intervals leave open counts as Delaunay
\cgalModels{IntrinsicMetric}
*/
template <FieldNumber FT_>
class Ideal_hyperbolic_metric : public Lambda_values<FT_> {
  using Base = Lambda_values<FT_>;
  struct No_scope {};

public:
  /// Number type of the stored values.
  using FT = FT_;
  /// Keeps the floating point unit rounding upwards, if the number type requires it.
  using Scope = std::conditional_t<std::is_same_v<FT, Interval_nt<false>>,
                                   Protect_FPU_rounding<true>, No_scope>;
  /// Whether predicates and constructions are exact, so that algorithms end without a cap.
  static constexpr bool is_exact =
      std::is_same_v<typename Algebraic_structure_traits<FT>::Is_exact, Tag_true>;

  /// constructs an empty metric.
  Ideal_hyperbolic_metric() = default;

  /*!
  \brief takes the lengths of the input, rounded to doubles.
  \throws Invalid_input naming an edge of length zero
  \complexity linear
  */
  Ideal_hyperbolic_metric(const Gluing_map& mesh, const Input_metric& input)
      : Base(input.scale_exponent(), lengths(mesh, input)) {}

  /// takes lambda lengths. \param scale_exponent, lambdas see `scale_exponent()`, `lambda()`
  Ideal_hyperbolic_metric(int scale_exponent, std::vector<FT> lambdas)
      : Base(scale_exponent, std::move(lambdas)) {}

  /// tells whether an edge is ideal Delaunay, or rounding hides that it is not.
  BOOST_FORCEINLINE bool is_locally_delaunay(const Diamond& d) const {
    ++this->statistics().checks;
    const Ideal_diamond_values<FT> v = this->values(d);
    const FT outer = Ideal_delaunay_expression::outer(v),
             inner = Ideal_delaunay_expression::inner(v);
    if constexpr (std::floating_point<FT>)
      if (!(outer < largest && inner < largest && outer > smallest && inner > smallest))
        return delaunay_sign(d) != NEGATIVE;
    return !certainly(outer < inner) || is_tie_of_rounding(v);
  }

  /// returns the sign of `Ideal_delaunay_expression`, zero where rounding hides it.
  Sign delaunay_sign(const Diamond& d) const {
    const Ideal_diamond_values<FT> v = this->values(d);
    const Sign s = sign_of(v);
    return s == NEGATIVE && is_tie_of_rounding(v) ? ZERO : s;
  }

  /// The new values of a flip.
  using Flipped = typename Base::Flipped;
  /*!
  \brief computes a flip.
  \return nothing if a lambda length is out of the range of an inexact type
  */
  std::optional<Flipped> compute_flip(const Diamond& d) const {
    const FT lambda = ptolemy_flip(this->values(d));
    const FT unscaled = this->is_scaled() ? ptolemy_flip(this->unscaled_values(d)) : lambda;
    if (!is_length(lambda) || !is_length(unscaled)) return std::nullopt;
    return Flipped{lambda, unscaled};
  }
  /// stores what `compute_flip()` returned for a diamond.
  void store_flip(const Diamond& d, Flipped&& n) noexcept { this->store(d.ij, std::move(n)); }

private:
  // where products of four lambda lengths are accurate
  static constexpr double largest = 0x1p1000, smallest = 0x1p-900;

  static std::vector<FT> lengths(const Gluing_map& mesh, const Input_metric& input) {
    const std::vector<double> nearest = nearest_lengths(input, mesh);
    return {nearest.begin(), nearest.end()};
  }

  // zero, too, if intervals leave it open; floating point has a greater range here
  static Sign sign_of(const Ideal_diamond_values<FT>& v) {
    if constexpr (std::floating_point<FT>) {
      using Wide = long double;
      return CGAL::sign(Ideal_delaunay_expression()(
          Ideal_diamond_values<Wide>{Wide(v.ij), Wide(v.jk), Wide(v.ki), Wide(v.im), Wide(v.mj)}));
    } else {
      const FT outer = Ideal_delaunay_expression::outer(v),
               inner = Ideal_delaunay_expression::inner(v);
      return certainly(outer < inner) ? NEGATIVE : certainly(outer > inner) ? POSITIVE : ZERO;
    }
  }

  // Whether the flipped edge seems not to be Delaunay.
  static bool is_tie_of_rounding(const Ideal_diamond_values<FT>& v) {
    if constexpr (is_exact) return false;
    return sign_of({ptolemy_flip(v), v.mj, v.jk, v.ki, v.im}) == NEGATIVE;
  }

  static bool is_length(const FT& lambda) {
    if constexpr (std::numeric_limits<FT>::has_infinity)
      if (!certainly(lambda < std::numeric_limits<FT>::infinity())) return false;
    return certainly(lambda > FT(0));
  }
};

/*!
\brief lets an intrinsic triangulation store an ideal hyperbolic metric in one number type.
\tparam FT_ see `Ideal_hyperbolic_metric`
\cgalModels{IntrinsicTriangulationTraits}
*/
template <FieldNumber FT_>
struct Ideal_hyperbolic_traits {
  /// Number type of the stored values.
  using FT = FT_;
  /// Stores the values and decides.
  using Metric = Ideal_hyperbolic_metric<FT_>;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_IDEAL_HYPERBOLIC_TRAITS_H
