// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_EUCLIDEAN_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_EUCLIDEAN_TRAITS_H

#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/formulas/nonnegative_intervals.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/metric/Enclosed_values.h>
#include <CGAL/Intrinsic_triangulations/metric/Remembered_signs.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>

#include <boost/config.hpp>

#include <array>
#include <optional>
#include <span>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief stores the metric as intervals that contain the exact values, and answers what these prove.

A decider answers the rest: the triangulation that owns the metric has one, which knows where edges
run on the input, see `Intrinsic_triangulation::decider()`. Narrower intervals that it finds replace
the stored ones: these are a cache, so that `refine()` is const. There are no locks: not even
predicates of one metric may run in two threads at a time.

All members except the constructors and `Scope` require a live `Scope`, which sets the rounding mode
of interval arithmetic.
\cgalModels{EuclideanMetric}
*/
class Exact_euclidean_metric : public Enclosed_values {
public:
  /// Keeps the floating point unit rounding upwards.
  using Scope = Protect_FPU_rounding<true>;
  /// Predicates are exact: algorithms end without a cap.
  static constexpr bool is_exact = true;

  /// constructs an empty metric.
  Exact_euclidean_metric() = default;

  /*!
  \brief evaluates the input in interval arithmetic and keeps it for exact evaluation.
  \pre no face of the input has the edge of its halfedge twice
  \throws Invalid_input see `quadruple_area()`
  \complexity linear
  */
  Exact_euclidean_metric(const Gluing_map& mesh, const Input_metric& input);

  /// restores a metric. \pre the intervals contain the values that the input defines
  Exact_euclidean_metric(int scale_exponent, Enclosed_values values)
      : Enclosed_values(std::move(values)), scale_exponent_(scale_exponent) {}

  /// tells whether the angles opposite the edge sum to at most pi, if the intervals prove it.
  // the call would cost a tenth of the flips where compilers, by chance, do not inline it
  BOOST_FORCEINLINE Certainty certain_delaunay(const Diamond& d) const {
    ++statistics().checks;
    const auto [q_f, q_g] = numerators(d);
    return Intrinsic_triangulations::certain_delaunay(q_f, quadruple_area(d.f), q_g,
                                                      quadruple_area(d.g));
  }
  /// returns the sign of an expression in the values of a diamond, if the intervals prove it.
  /// \tparam Expression a model of `DiamondExpression`
  template <class Expression>
  std::optional<Sign> certain_sign(const Diamond& d, const Expression& expression) const {
    static_assert(DiamondExpression<Expression>);
    return Intrinsic_triangulations::certain_sign(expression(enclosure(d)));
  }
  /// returns the sign of an expression in the values of faces, if the intervals prove it.
  /// \tparam Expression a model of `FaceExpression`
  template <class Expression>
  std::optional<Sign> certain_sign(std::span<const Indexed_face> faces,
                                   const Expression& expression) const {
    static_assert(FaceExpression<Expression>);
    using Values = std::span<const Face_values<FT>>;
    if (faces.size() != 1)
      return Intrinsic_triangulations::certain_sign(expression(Values(enclosures(faces))));
    const Face_values<FT> value = enclosure(faces.front()); // nearly always
    return Intrinsic_triangulations::certain_sign(expression(Values(&value, 1)));
  }
  /// returns exact signs of `Delaunay_expression` for edges whose faces have not changed since: a
  /// cache.
  Remembered_signs& remembered_signs() const { return signs_; }

  /*!
  \brief computes a flip and changes nothing.
  \return the new values, always
  \pre the diamond is strictly convex
  */
  // inlined by force: passing what it returns takes a tenth of the time of a flip
  BOOST_FORCEINLINE std::optional<Flipped> compute_flip(const Diamond& d) const {
    return flipped_values(d);
  }

  /*!
  \brief computes a flip that makes the right face, of the source of the edge, a face of zero area.
  \pre the diamond is a triangle with the source of the edge on a side
  */
  std::optional<Flipped> compute_flip_to_zero_area(const Diamond& d) const;

  /// stores what `compute_flip()` returned for a diamond.
  BOOST_FORCEINLINE void store_flip(const Diamond& d, const Flipped& n) noexcept {
    store(d, n);
    signs_.forget(std::array{d.ij, d.jk, d.ki, d.im, d.mj});
  }

  /// returns what a flip of the edge will replace; storing it takes the flip back.
  Flipped before_flip(const Diamond& d) const { return stored(d); }

  /*!
  \brief stores the values at a vertex inserted in a face.
  \param s the star of the vertex; values of its sides and, in place of the first face, of the whole
  one are stored
  \param values of its spokes and faces, narrow
  */
  void insert_in_face(const Vertex_star& s, const Vertex_move_values<FT>& values) noexcept;

  /// returns the values that the removal of the vertex of a star makes, to be stored as those of a
  /// flip of the diamond `without_vertex(s)`.
  Flipped removed_values(const Vertex_star& s) const;

  /*!
  \brief stores the values at a vertex inserted on a border edge.
  \param s the star of the vertex; values of `ip`, `jk`, `ki` and `f` are stored, those of the whole
  edge and face
  \param values those at the vertex as if it were in the face: of ip, jp, kp, and of ijp, jkp, kip
  */
  void insert_in_border_edge(const Border_star& s, const Vertex_move_values<FT>& values) noexcept;

  /// returns the values that the removal of a vertex from the border makes; see above.
  Flipped removed_values(const Border_star& s) const;

  /// returns s, where coordinates are scaled by 2^s.
  int scale_exponent() const { return scale_exponent_; }
  /// returns how predicates were decided, which may be reset.
  Predicate_statistics& statistics() const { return statistics_; }

private:
  int scale_exponent_ = 0;
  mutable Remembered_signs signs_; // of `Delaunay_expression`
  mutable Predicate_statistics statistics_;
};

/*!
\brief lets an intrinsic triangulation decide every predicate exactly.
\cgalModels{IntrinsicTriangulationTraits}
*/
struct Exact_euclidean_traits {
  /// Number type of the stored values.
  using FT = Interval_nt<false>;
  /// Stores enclosures of the values.
  using Metric = Exact_euclidean_metric;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_EUCLIDEAN_TRAITS_H
