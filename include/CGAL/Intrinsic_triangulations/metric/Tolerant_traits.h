// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_TOLERANT_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_TOLERANT_TRAITS_H

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>

#include <ratio>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief decides as `Euclidean_metric`, but takes edges for Delaunay that miss it by a tolerance.

An edge counts as Delaunay unless cot k + cot m < -tolerance for the angles opposite it, that is
unless q_f a_g + q_g a_f < -tolerance a_f a_g: cotangents are free of units, so that the scale of
the mesh does not matter. This is what programs in floating point commonly do in order not to flip
ties back and forth. The result may have edges that are not Delaunay; `sign()` and
`check_delaunay()` have no tolerance and count them, up to the precision of `FT`.
\tparam FT_ see `Euclidean_metric`
\tparam Tolerance the tolerance, a positive `std::ratio`; without one, take `Euclidean_metric`
\cgalModels{EuclideanMetric}
*/
template <FieldNumber FT_, class Tolerance>
  requires std::ratio_greater_v<Tolerance, std::ratio<0>>
class Tolerant_metric : public Euclidean_metric<FT_> {
  using Base = Euclidean_metric<FT_>;

public:
  /// Number type of the stored values.
  using FT = FT_;
  /// Whatever the number type, predicates are not exact.
  static constexpr bool is_exact = false;

  using Base::Base;

  /// tells whether the cotangents of the angles opposite the edge sum to at least -tolerance.
  bool is_locally_delaunay(const Diamond& d) const {
    ++this->statistics().checks;
    const auto [q_f, q_g] = this->numerators(d);
    // both angles at most a right one: areas do not matter
    if (q_f >= FT(0) && q_g >= FT(0)) return true;
    const FT &a_f = this->quadruple_area(d.f), &a_g = this->quadruple_area(d.g);
    return !(q_f * a_g + q_g * a_f < -(tolerance() * a_f * a_g));
  }

  /// returns the tolerance, rounded if `FT` is inexact.
  static FT tolerance() {
    return FT(static_cast<double>(Tolerance::num)) / FT(static_cast<double>(Tolerance::den));
  }
};

/*!
\brief lets an intrinsic triangulation compute in one number type and tolerate edges that are not
quite Delaunay.
\tparam FT_ see `Euclidean_metric`
\tparam Tolerance see `Tolerant_metric`; `std::micro` is what several programs take
\cgalModels{IntrinsicTriangulationTraits}
*/
template <FieldNumber FT_, class Tolerance>
  requires std::ratio_greater_v<Tolerance, std::ratio<0>>
struct Tolerant_traits {
  /// Number type of the stored values.
  using FT = FT_;
  /// Stores the values and decides.
  using Metric = Tolerant_metric<FT_, Tolerance>;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_TOLERANT_TRAITS_H
