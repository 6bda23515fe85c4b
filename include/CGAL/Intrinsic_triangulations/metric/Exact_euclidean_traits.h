// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_EUCLIDEAN_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_EUCLIDEAN_TRAITS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/exact/Exact_evaluation.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/input_diamond_sign.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_move_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/formulas/nonnegative_intervals.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>

#include <CGAL/Interval_nt.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief stores the metric as intervals that contain the exact values, and decides exactly.

A predicate is evaluated in interval arithmetic (the filter). Where that leaves the sign open, the
values are recomputed from the input by the history of moves, in multi-precision intervals of 128,
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
  \pre no face of the input has the edge of its halfedge twice
  \throws Invalid_input see `quadruple_area()`
  \complexity linear
  */
  explicit Exact_euclidean_metric(const std::shared_ptr<const Input>& input)
      : input_(input, &input->metric()), history_(input->number_of_faces()) {
    const Scope scope;
    squared_length_ = Intrinsic_triangulations::squared_lengths<FT>(*input_, input->mesh());
    quadruple_area_ = Intrinsic_triangulations::quadruple_areas<FT>(*input_);
    length_.reserve(squared_length_.size());
    area_.reserve(quadruple_area_.size());
    for (const FT& x : squared_length_) length_.push_back(CGAL::to_double(x));
    for (const FT& x : quadruple_area_) area_.push_back(CGAL::to_double(x));
    sides_.reserve(input_->number_of_faces());
    for (std::uint32_t f = 0; f < input_->number_of_faces(); ++f)
      sides_.push_back({f, input->halfedge_of_face(f) / 2});
  }

  /*!
  \brief restores a metric from what its accessors return.
  \pre the intervals contain the values that `input` and `history` define
  */
  Exact_euclidean_metric(const std::shared_ptr<const Input>& input, Flip_history history,
                         std::vector<Version> versions, std::vector<FT> squared_lengths,
                         std::vector<FT> quadruple_areas, std::vector<double> lengths,
                         std::vector<double> areas)
      : squared_length_(std::move(squared_lengths)), quadruple_area_(std::move(quadruple_areas)),
        length_(std::move(lengths)), area_(std::move(areas)), sides_(std::move(versions)),
        input_(input, &input->metric()), history_(std::move(history)) {}

  /// tells whether the angles opposite the edge sum to at most pi.
  // the call would cost a tenth of the flips where compilers, by chance, do not inline it
  BOOST_FORCEINLINE bool is_locally_delaunay(const Diamond& d) const {
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
  Sign sign(const Diamond& d, const Expression& expression) const {
    const FT value = expression(values(d));
    if (value.inf() > 0) return POSITIVE;
    if (value.sup() < 0) return NEGATIVE;
    if (value.inf() == 0 && value.sup() == 0) return ZERO;
    return exact_sign(d, expression);
  }

  /*!
  \brief returns the exact sign of an expression in the values of faces.
  \tparam Expression a functor with a template `operator()(std::span<const Face_values<Number>>)`
  \complexity mostly linear in the number of faces; if the filter fails, in that of the moves that
  made them
  */
  template <class Expression>
  Sign sign(std::span<const Indexed_face> faces, const Expression& expression) const {
    std::vector<Face_values<FT>> values;
    for (const Indexed_face& f : faces) values.push_back(enclosure(f));
    const FT value = expression(std::span<const Face_values<FT>>(values));
    if (value.inf() > 0) return POSITIVE;
    if (value.sup() < 0) return NEGATIVE;
    if (value.inf() == 0 && value.sup() == 0) return ZERO;
    return exact_sign(faces, values, expression);
  }

  /*!
  \brief makes stored intervals of faces narrow, and the doubles beside them accurate: to 2^-40 of the
  value, except for areas of thin faces, which get as accurate as 2048 bits allow.
  \complexity constant per face if they are narrow, else linear in the number of moves that made them
  */
  void sharpen(std::span<const Indexed_face> faces) const {
    const auto are_narrow = [&] {
      return std::all_of(faces.begin(), faces.end(),
                         [this](const Indexed_face& f) { return is_narrow(enclosure(f)); });
    };
    for (unsigned bits = 512; bits <= 2048 && !are_narrow(); bits *= 2)
      refine(faces, evaluation_.enclosures(*input_, history_, sides(faces), bits));
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
  // inlined by force: passing what it returns takes a tenth of the time of a flip
  BOOST_FORCEINLINE std::optional<Flipped> compute_flip(const Diamond& d) const {
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
  BOOST_FORCEINLINE void store_flip(const Diamond& d, const Flipped& n) {
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

  /*!
  \brief computes the values at a vertex inserted in a face, and stores them.
  \param s the star of the vertex; values of its sides and, in place of the first face, of the whole one
  are stored
  \param weights barycentric coordinates of the vertex, see `representable_weights()`
  \return whether it was done: refused if a length would be zero, as it can be in faces without area
  */
  bool insert_in_face(const Vertex_star& s, const std::array<double, 3>& weights) {
    const Indexed_face whole{s.faces[0], s.sides};
    const auto values =
        new_values(whole, [&](const auto& face) { return inserted_in_face(face, weights); });
    if (!values) return false;
    const auto& [enclosure, approximation] = *values;
    const std::uint32_t version = history_.record_vertex_move(
        Flip_history::Vertex_move::Kind::insert_in_face, {side(whole)}, weights);
    for (std::uint32_t k = 0; k < 3; ++k) {
      store_length(s.spokes[k], enclosure.squared_lengths[k], approximation.squared_lengths[k]);
      store_area(s.faces[k], enclosure.quadruple_areas[k], approximation.quadruple_areas[k]);
      store_version(s.faces[k], {version + k, s.sides[k]});
    }
    return true;
  }

  /// stores the values of a face from which a vertex is removed.
  void remove_from_face(const Vertex_star& s) {
    const auto [ij, jk, ki] = s.sides;
    const std::uint32_t first = ij == jk ? 2 : ij == ki ? 1 : 0; // a side unlike the others
    std::array<Flip_history::Side, 3> parents;
    for (std::uint32_t k = 0; k < 3; ++k) parents[k] = star_side(s, (first + k) % 3);
    const std::uint32_t version =
        history_.record_vertex_move(Flip_history::Vertex_move::Kind::remove_from_face, parents);
    const auto [f, g, h] = s.faces;
    store_area(f,
               removed_from_face(quadruple_area_[f], quadruple_area_[g], quadruple_area_[h])
                   .quadruple_areas[0],
               removed_from_face(area_[f], area_[g], area_[h]).quadruple_areas[0]);
    store_version(f, {version, s.sides[first]});
  }

  /*!
  \brief computes the values at a vertex inserted on a border edge, and stores them.
  \param s the star of the vertex; values of `ip`, `jk`, `ki` and `f` are stored, those of the whole edge
  and face
  \param parameter weight of `j`
  \return whether it was done: refused if a length would be zero
  */
  bool insert_in_border_edge(const Border_star& s, double parameter) {
    const Indexed_face whole{s.f, {s.ip, s.jk, s.ki}};
    const auto values = new_values(
        whole, [&](const auto& face) { return inserted_in_border_edge(face, parameter); });
    if (!values) return false;
    const auto& [enclosure, approximation] = *values;
    const std::uint32_t version =
        history_.record_vertex_move(Flip_history::Vertex_move::Kind::insert_in_border_edge,
                                    {side(whole)}, {1 - parameter, parameter, 0});
    const std::array<std::uint32_t, 3> edges{s.ip, s.pj, s.pk};
    const std::array<std::uint32_t, 2> faces{s.f, s.g};
    for (std::size_t k = 0; k < 3; ++k)
      store_length(edges[k], enclosure.squared_lengths[k], approximation.squared_lengths[k]);
    for (std::uint32_t k = 0; k < 2; ++k) {
      store_area(faces[k], enclosure.quadruple_areas[k], approximation.quadruple_areas[k]);
      store_version(faces[k], {version + k, edges[k]});
    }
    return true;
  }

  /// stores the values of a border edge and its face from which a vertex is removed.
  void remove_from_border_edge(const Border_star& s) {
    const Diamond d{s.pk, s.ki, s.ip, s.pj, s.jk, s.f, s.g};
    const auto enclosure = removed_from_border_edge(values(d));
    const auto approximation = removed_from_border_edge(approximations(d));
    const std::uint32_t version = history_.record_vertex_move(
        Flip_history::Vertex_move::Kind::remove_from_border_edge, {left_side(d), right_side(d)});
    store_length(s.ip, enclosure.squared_lengths[0], approximation.squared_lengths[0]);
    store_area(s.f, enclosure.quadruple_areas[0], approximation.quadruple_areas[0]);
    store_version(s.f, {version, s.ip});
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
  /// returns the moves done so far.
  const Flip_history& history() const { return history_; }
  /// returns how predicates were decided, which may be reset.
  Predicate_statistics& statistics() const { return statistics_; }

  /*!
  \brief returns (cot k + cot m) / 2 for the angles opposite an edge between two faces.

  Zero exactly where the sum of the angles is pi, and of the right sign everywhere.
  \pre both faces have an area
  */
  double cotangent_weight(const Diamond& d) const {
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

  Face_values<FT> enclosure(const Indexed_face& f) const {
    return {{squared_length_[f.edges[0]], squared_length_[f.edges[1]], squared_length_[f.edges[2]]},
            quadruple_area_[f.face]};
  }

  Face_values<double> approximation(const Indexed_face& f) const {
    return {{length_[f.edges[0]], length_[f.edges[1]], length_[f.edges[2]]}, area_[f.face]};
  }

  using New_values = std::pair<Vertex_move_values<FT>, Vertex_move_values<double>>;

  // what a function makes of a face, if lengths are not zero
  template <class Function>
  std::optional<New_values> new_values(const Indexed_face& face, const Function& function) {
    const Face_values<FT> old = enclosure(face);
    if (is_vague(old.quadruple_area) ||
        std::any_of(old.squared_lengths.begin(), old.squared_lengths.end(), is_vague))
      sharpen(std::span(&face, 1));
    const New_values result{function(enclosure(face)), function(approximation(face))};
    for (std::size_t k = 0; k < 3; ++k) {
      if (result.first.squared_lengths[k].inf() > 0) continue;
      const auto length = [&](const auto& faces) { return function(faces[0]).squared_lengths[k]; };
      if (sign(std::span(&face, 1), length) != POSITIVE) return std::nullopt;
    }
    return result;
  }

  template <class T>
  static void store(std::vector<T>& values, std::uint32_t i, const T& value) {
    if (i >= values.size()) values.resize(i + 1);
    values[i] = value;
  }

  void store_length(std::uint32_t e, const FT& enclosure, double approximation) {
    store(squared_length_, e, positive_part(enclosure));
    store(length_, e, nearest(approximation, squared_length_[e]));
  }

  void store_area(std::uint32_t f, const FT& enclosure, double approximation) {
    store(quadruple_area_, f, positive_part(enclosure));
    store(area_, f, nearest(approximation, quadruple_area_[f]));
  }

  void store_version(std::uint32_t f, const Version& version) { store(sides_, f, version); }

  std::vector<Flip_history::Side> sides(std::span<const Indexed_face> faces) const {
    std::vector<Flip_history::Side> result;
    for (const Indexed_face& f : faces) result.push_back(side(f));
    return result;
  }

  Flip_history::Side side(const Indexed_face& f) const {
    return side(f.face, f.edges[0], f.edges[1]);
  }

  // the side of a face opposite the vertex of a star
  Flip_history::Side star_side(const Vertex_star& s, std::uint32_t k) const {
    return side(s.faces[k], s.sides[k], s.spokes[(k + 1) % 3]);
  }

  Flip_history::Side left_side(const Diamond& d) const { return side(d.f, d.ij, d.jk); }
  Flip_history::Side right_side(const Diamond& d) const { return side(d.g, d.ij, d.im); }
  Flip_history::Side side(std::uint32_t f, std::uint32_t edge, std::uint32_t next_edge) const {
    const auto& [version, first] = sides_[f];
    return {version, first == edge ? 0U : first == next_edge ? 2U : 1U};
  }

  // Lengths and areas are never negative, whatever rounding makes of the lower bound.
  static FT positive_part(const FT& x) { return {std::max(x.inf(), 0.0), x.sup()}; }

  // Not inline: what the filter cannot decide is rare, and takes long to compile; see `extern template`.
  template <class Expression>
  Sign exact_sign(const Diamond& d, const Expression& expression) const;
  template <class Expression>
  Sign exact_sign(std::span<const Indexed_face> faces, std::vector<Face_values<FT>>& values,
                  const Expression& expression) const;

  // too wide for its approximation to be worth anything
  static bool is_vague(const FT& x) { return x.sup() - x.inf() > 0x1p-10 * x.sup(); }

  // precise enough to place points by it; lengths are those of an ordinary face
  static bool is_narrow(const Face_values<FT>& f) {
    const auto is = [](const FT& x, double size) { return x.sup() - x.inf() <= 0x1p-40 * size; };
    double longest = 0;
    for (const FT& x : f.squared_lengths) {
      if (!is(x, x.sup())) return false;
      longest = std::max(longest, x.sup());
    }
    // zero never gets narrow relative to itself
    return is(f.quadruple_area, std::max(f.quadruple_area.sup(), 0x1p-200 * longest));
  }

  void sharpen(const Diamond& d) const {
    refine(d, evaluation_.enclosure(*input_, history_, left_side(d), right_side(d)));
  }

  void refine(const Diamond& d, const Diamond_values<FT>& better) const {
    refine(squared_length_[d.ij], length_[d.ij], better.ij);
    refine(squared_length_[d.jk], length_[d.jk], better.jk);
    refine(squared_length_[d.ki], length_[d.ki], better.ki);
    refine(squared_length_[d.im], length_[d.im], better.im);
    refine(squared_length_[d.mj], length_[d.mj], better.mj);
    refine(quadruple_area_[d.f], area_[d.f], better.area_f);
    refine(quadruple_area_[d.g], area_[d.g], better.area_g);
  }

  void refine(std::span<const Indexed_face> faces,
              const std::vector<Face_values<FT>>& better) const {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t e = faces[i].edges[k];
        refine(squared_length_[e], length_[e], better[i].squared_lengths[k]);
      }
      const std::uint32_t f = faces[i].face;
      refine(quadruple_area_[f], area_[f], better[i].quadruple_area);
    }
  }

  static void refine(FT& stored, double& approximation, const FT& better) {
    const double inf = std::max(stored.inf(), better.inf());
    const double sup = std::min(stored.sup(), better.sup());
    stored = inf > sup ? better : FT(inf, sup); // apart only if a file had wrong digits
    approximation = nearest(approximation, stored);
  }

  // the lower bound if x is not a number
  static double nearest(double x, const FT& interval) {
    return x >= interval.inf() ? std::min(x, interval.sup()) : interval.inf();
  }

  // What predicates learn: better enclosures and how they were found. A cache, so mutable; threads that share
  // a metric need a lock of their own.
  mutable std::vector<FT> squared_length_;
  mutable std::vector<FT> quadruple_area_;
  // The middle of an interval that has grown wide is a poor approximation; doubles that are computed
  // beside it, and kept within it, are a good one.
  mutable std::vector<double> length_; // squared
  mutable std::vector<double> area_;   // quadruple
  std::vector<Version> sides_;
  std::shared_ptr<const Input_metric> input_; // immutable, shared by copies
  Flip_history history_;
  mutable Exact_evaluation evaluation_;
  mutable Predicate_statistics statistics_;
};

template <class Expression>
Sign Exact_euclidean_metric::exact_sign(const Diamond& d, const Expression& expression) const {
  ++statistics_.filter_failures;
  const Flip_history::Side left = left_side(d), right = right_side(d);
  if (history_.is_input(left.version) && history_.is_input(right.version))
    if (const std::optional<Sign> s = input_diamond_sign(*input_, left, right, expression)) {
      ++(*s == ZERO ? statistics_.certified_zero : statistics_.integer);
      return *s;
    }
  Diamond_values<FT> better;
  const Sign s = evaluation_.sign(*input_, history_, left, right, expression, better, statistics_);
  refine(d, better);
  return s;
}

template <class Expression>
Sign Exact_euclidean_metric::exact_sign(std::span<const Indexed_face> faces,
                                        std::vector<Face_values<FT>>& values,
                                        const Expression& expression) const {
  ++statistics_.filter_failures;
  const Sign s = evaluation_.sign(*input_, history_, sides(faces), expression, values, statistics_);
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
