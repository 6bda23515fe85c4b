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

#include <boost/config.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief stores the metric as intervals that contain the exact values, and decides exactly.

A predicate is evaluated in interval arithmetic (the filter). If the sign stays open, `Exact_values`
decides from where edges run on the input; all predicates take it as their last argument. Narrower
intervals found on the way replace the stored ones: they are a cache, so that predicates are const.
There are no locks: not even predicates of one metric may run in two threads at a time.

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

  /// tells whether the angles opposite the edge sum to at most pi.
  // the call would cost a tenth of the flips where compilers, by chance, do not inline it
  template <class Exact>
  BOOST_FORCEINLINE bool is_locally_delaunay(const Diamond& d, const Exact& exact) const {
    ++statistics().checks;
    const FT& ij = squared_length(d.ij);
    const FT q_f = squared_length(d.jk) + squared_length(d.ki) - ij;
    const FT q_g = squared_length(d.im) + squared_length(d.mj) - ij;
    // both angles at most a right one: areas do not matter
    if (q_f.inf() >= 0 && q_g.inf() >= 0) return true;
    const FT value = delaunay_value(q_f, quadruple_area(d.f), q_g, quadruple_area(d.g));
    if (value.inf() >= 0) return true;
    if (value.sup() < 0) return false;
    return exact_delaunay_sign(d, exact) != NEGATIVE;
  }

  /*!
  \brief returns the exact sign of an expression in the values of a diamond, of any degree.
  \tparam Expression a model of `DiamondExpression`
  */
  template <class Expression, class Exact>
  Sign sign(const Diamond& d, const Expression& expression, const Exact& exact) const {
    static_assert(DiamondExpression<Expression>);
    const std::optional<Sign> s = certain_sign(expression(enclosure(d)));
    return s ? *s : exact_sign(d, recorded(expression), exact);
  }

  /*!
  \brief returns the exact sign of an expression in the values of faces, of any degree.
  \tparam Expression a model of `FaceExpression`
  \complexity mostly linear in the number of faces; if the filter fails, in that of the input
  triangles under them
  */
  template <class Expression, class Exact>
  Sign sign(std::span<const Indexed_face> faces, const Expression& expression,
            const Exact& exact) const {
    static_assert(FaceExpression<Expression>);
    using Values = std::span<const Face_values<FT>>;
    if (faces.size() == 1) { // nearly always, and most of them end here
      const Face_values<FT> value = enclosure(faces.front());
      if (const auto s = certain_sign(expression(Values(&value, 1)))) return *s;
    }
    std::vector<Face_values<FT>> values;
    for (const Indexed_face& f : faces) values.push_back(enclosure(f));
    const std::optional<Sign> s = certain_sign(expression(Values(values)));
    return s ? *s
             : exact_sign(faces, values, Recorded_face_expression(expression, faces.size()), exact);
  }

  /*!
  \brief makes stored intervals of faces narrow, and the doubles beside them accurate: to 2^-41 of
  the value, except for areas of thin faces, which get as accurate as 4096 bits allow.
  \complexity constant per face if they are narrow, else linear in the number of input triangles
  under it
  */
  template <class Exact>
  void sharpen(std::span<const Indexed_face> faces, const Exact& exact) const;
  /// makes the interval of the squared length of the first side of a face narrow; see above.
  template <class Exact>
  void sharpen_length(const Indexed_face& face, const Exact& exact) const;

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

  /// tells whether an edge was found to be a tie since its faces changed.
  bool is_known_tie(const Diamond& d) const { return signs_.is_zero(d.ij); }

  /// stores what `compute_flip()` returned for a diamond.
  BOOST_FORCEINLINE void store_flip(const Diamond& d, const Flipped& n) {
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
  void insert_in_face(const Vertex_star& s, const Vertex_move_values<FT>& values);

  /// stores the values of a face from which a vertex is removed.
  void remove_from_face(const Vertex_star& s);

  /*!
  \brief stores the values at a vertex inserted on a border edge.
  \param s the star of the vertex; values of `ip`, `jk`, `ki` and `f` are stored, those of the whole
  edge and face
  \param values those at the vertex as if it were in the face: of ip, jp, kp, and of ijp, jkp, kip
  */
  void insert_in_border_edge(const Border_star& s, const Vertex_move_values<FT>& values);

  /// stores the values of a border edge and its face from which a vertex is removed.
  void remove_from_border_edge(const Border_star& s);

  /// returns s, where coordinates are scaled by 2^s.
  int scale_exponent() const { return scale_exponent_; }
  /// returns how predicates were decided, which may be reset.
  Predicate_statistics& statistics() const { return statistics_; }

  /*!
  \brief returns (cot k + cot m) / 2 for the angles opposite an edge between two faces.

  Zero exactly where the sum of the angles is pi, else of the right sign and not zero, with an error
  below 1e-12 of itself, or of min(1, E), where E is the least Dirichlet energy in the two faces of
  functions that change by one along the edge; see `stored_weight()`. If stored values are not
  accurate enough, the result is the double nearest to the exact weight.
  \pre both faces have an area
  \complexity usually constant; otherwise linear in the number of input triangles under the diamond
  */
  template <class Exact>
  double cotangent_weight(const Diamond& d, const Exact& exact) const;

  using Enclosed_values::cotangent_weight;
  using Enclosed_values::stored_weight;

private:
  // in which values are computed, one after the other until they are narrow
  static constexpr std::array<unsigned, 6> precisions{53, 106, 256, 1024, 2048, 4096};

  void forget_signs(const Vertex_star& s);
  void forget_signs(const Border_star& s);

  // rarely needed: the filter decides nearly always
  template <class Exact>
  Sign exact_sign(const Diamond& d, const Recorded_diamond_expression& expression,
                  const Exact& exact) const;
  template <class Exact>
  Sign exact_sign(std::span<const Indexed_face> faces, std::vector<Face_values<FT>>& values,
                  const Recorded_face_expression& expression, const Exact& exact) const;
  template <class Exact>
  Sign exact_delaunay_sign(const Diamond& d, const Exact& exact) const;

  int scale_exponent_ = 0;
  mutable Remembered_signs signs_; // of `Delaunay_expression`
  mutable Predicate_statistics statistics_;
};

template <class Exact>
void Exact_euclidean_metric::sharpen(std::span<const Indexed_face> faces,
                                     const Exact& exact) const {
  const auto is_narrow = [this](const Indexed_face& f) { return Enclosed_values::is_narrow(f); };
  std::vector<Indexed_face> wide(faces.begin(), faces.end());
  std::erase_if(wide, is_narrow);
  for (unsigned last = 0; const unsigned bits : precisions)
    if (bits > last && !wide.empty()) {
      last = exact.for_each_enclosure(
          wide, bits, [&](std::size_t i, const auto& better) { refine(wide[i], better); });
      statistics().sharpenings[last] += wide.size();
      std::erase_if(wide, is_narrow);
    }
}

template <class Exact>
void Exact_euclidean_metric::sharpen_length(const Indexed_face& face, const Exact& exact) const {
  for (const unsigned bits : precisions) {
    if (is_narrow(face.edges[0])) return;
    ++statistics().sharpenings[bits];
    refine_length(face.edges[0], exact.first_squared_length(face, bits));
  }
}

template <class Exact>
double Exact_euclidean_metric::cotangent_weight(const Diamond& d, const Exact& exact) const {
  if (const std::optional<double> weight = stored_weight(d)) return *weight;
  if (sign(d, Delaunay_expression(), exact) == ZERO) return 0;
  return exact.nonzero_weight(d, statistics_);
}

template <class Exact>
Sign Exact_euclidean_metric::exact_sign(const Diamond& d,
                                        const Recorded_diamond_expression& expression,
                                        const Exact& exact) const {
  const bool is_remembered = expression.zero_meaning() == Zero_meaning::cocircular;
  ++statistics().filter_failures;
  std::uint64_t& probable = statistics().probable_zero;
  if (is_remembered)
    if (const auto known = signs_.find(d.ij)) {
      if (known->sign == ZERO) ++(known->is_probable ? probable : statistics().certified_zero);
      return known->sign;
    }
  const std::uint64_t before = probable;
  Diamond_values<FT> better = enclosure(d);
  const Sign s = exact.sign(d, expression, better, statistics_);
  refine(d, better);
  if (is_remembered) signs_.remember(d.ij, {s, probable != before});
  return s;
}

// not within the loop that flips
template <class Exact>
BOOST_NOINLINE Sign Exact_euclidean_metric::exact_delaunay_sign(const Diamond& d,
                                                                const Exact& exact) const {
  return exact_sign(d, recorded(Delaunay_expression()), exact);
}

template <class Exact>
Sign Exact_euclidean_metric::exact_sign(std::span<const Indexed_face> faces,
                                        std::vector<Face_values<FT>>& values,
                                        const Recorded_face_expression& expression,
                                        const Exact& exact) const {
  ++statistics().filter_failures;
  const Sign s = exact.sign(faces, expression, values, statistics_);
  refine(faces, values);
  return s;
}

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
