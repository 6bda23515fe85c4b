// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EUCLIDEAN_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EUCLIDEAN_TRAITS_H

#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/reserve_at_least.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>

#include <boost/config.hpp>
#include <boost/container/small_vector.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief stores squared lengths and quadruple areas as numbers of one type, and decides by computing
with them.

It is exact iff `FT` is. With an inexact type, rounding decides near ties, a flip is refused unless
the new areas are certainly positive, and a cap on the number of flips ends algorithms.
\tparam FT_ a CGAL number type: a field, with square root unless all areas of the input are rational
\cgalModels{EuclideanMetric}
*/
template <FieldNumber FT_>
class Euclidean_metric {
public:
  /// Number type of the stored values.
  using FT = FT_;
  /// Predicates need no special environment.
  struct Scope {};
  /// Whether predicates and constructions are exact, so that algorithms end without a cap.
  static constexpr bool is_exact =
      std::is_same_v<typename Algebraic_structure_traits<FT>::Is_exact, Tag_true>;

  /// constructs an empty metric.
  Euclidean_metric() = default;

  /*!
  \brief evaluates the input.
  \throws Invalid_input see `quadruple_area()`
  \complexity linear
  */
  Euclidean_metric(const Gluing_map& mesh, const Input_metric& input)
      : scale_exponent_(input.scale_exponent()),
        squared_length_(Intrinsic_triangulations::squared_lengths<FT>(input, mesh)),
        quadruple_area_(Intrinsic_triangulations::quadruple_areas<FT>(input)) {}

  /// restores a metric from its stored values.
  Euclidean_metric(int scale_exponent, std::vector<FT> squared_lengths,
                   std::vector<FT> quadruple_areas)
      : scale_exponent_(scale_exponent), squared_length_(std::move(squared_lengths)),
        quadruple_area_(std::move(quadruple_areas)) {}

  /// tells whether the angles opposite the edge sum to at most pi, or rounding hides it.
  BOOST_FORCEINLINE bool is_locally_delaunay(const Diamond& d) const {
    ++statistics_.checks;
    const auto [q_f, q_g] = numerators(d);
    // both angles at most a right one: areas do not matter
    if (q_f >= FT(0) && q_g >= FT(0)) return true;
    const FT value = q_f * quadruple_area_[d.g] + q_g * quadruple_area_[d.f];
    return !(value < FT(0)) || is_tie_of_rounding(d);
  }

  /// returns the sign of an expression in the values of a diamond.
  template <class Expression>
  Sign sign(const Diamond& d, const Expression& expression) const {
    return CGAL::sign(expression(values(d)));
  }

  /*!
  \brief returns the sign of `Delaunay_expression`, zero where rounding hides it.

  A flip changes the sign. If the sign from stored values is negative both before and after,
  rounding hides it, and both edges count as Delaunay: the new edge of every flip passes the test.
  */
  Sign sign(const Diamond& d, const Delaunay_expression& expression) const {
    const Sign s = CGAL::sign(expression(values(d)));
    return s == NEGATIVE && is_tie_of_rounding(d) ? ZERO : s;
  }

  /*!
  \brief returns the sign of an expression in the values of faces.
  \tparam Expression a functor with `operator()(std::span<const Face_values<FT>>)`
  */
  template <class Expression>
  Sign sign(std::span<const Indexed_face> faces, const Expression& expression) const {
    const auto v = values(faces);
    return CGAL::sign(expression(std::span<const Face_values<FT>>(v.data(), v.size())));
  }

  /// The new values of a flip.
  using Flipped = Flipped_values<FT>;

  /*!
  \brief computes a flip.
  \return nothing unless intervals show that areas are positive and lengths finite
  */
  std::optional<Flipped> compute_flip(const Diamond& d) const {
    const Flipped n = flipped(values(d));
    if (!certainly(n.area_f > FT(0)) || !certainly(n.area_g > FT(0)) || !is_length(n.km))
      return std::nullopt;
    return n;
  }

  /// computes a flip so that rounding does not add up, see `flipped_consistently()`; Use it for
  /// edges that may be Delaunay: on others errors do not grow, and it takes a quarter more time.
  /// \return see `compute_flip()`; also nothing if an area may be a mere rounding error
  std::optional<Flipped>
  compute_consistent_flip(const Diamond& d) const requires internal::has_precision<FT> {
    const Diamond_values<FT> v = values(d);
    const Flipped n = flipped_consistently(v);
    const FT error = flipped_area_error(v, 16 * std::numeric_limits<FT>::epsilon());
    const bool is_sure = n.area_f > error && n.area_g > error && is_length(n.km);
    return is_sure ? std::optional<Flipped>(n) : std::nullopt;
  }

  /*!
  \brief computes a flip that makes the right face, of the source of the edge, a face of zero area.
  \pre the diamond is a triangle with the source of the edge on a side, up to rounding
  */
  std::optional<Flipped> compute_flip_to_zero_area(const Diamond& d) const {
    const FT area = quadruple_area_[d.f] + quadruple_area_[d.g];
    const Flipped n{flipped(values(d)).km, area, FT(0)};
    return is_length(n.km) ? std::optional<Flipped>(n) : std::nullopt;
  }

  /// stores a flip. \param d the diamond \param n what `compute_flip()` returned for it
  void store_flip(const Diamond& d, Flipped&& n) noexcept {
    squared_length_[d.ij] = std::move(n.km);
    quadruple_area_[d.f] = std::move(n.area_f);
    quadruple_area_[d.g] = std::move(n.area_g);
  }

  /// returns what a flip of the edge will replace; storing it takes the flip back.
  Flipped before_flip(const Diamond& d) const {
    return {squared_length_[d.ij], quadruple_area_[d.f], quadruple_area_[d.g]};
  }

  /*!
  \brief computes the values at a vertex inserted in a face.
  \param s the star of the vertex, without spokes: the sides and the first face are stored
  \param weights barycentric coordinates of the vertex
  \return nothing if a length would be zero or infinite
  */
  std::optional<Vertex_move_values<FT>>
  inserted_values(const Vertex_star& s, const std::array<double, 3>& weights) const {
    const FT area = quadruple_area_[s.faces[0]];
    Vertex_move_values<FT> n{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto side = [&](std::size_t l) { return squared_length_[s.sides[(k + l) % 3]]; };
      n.squared_lengths[k] = squared_distance_from_corner(
          side(0), side(1), side(2), area, FT(weights[(k + 1) % 3]), FT(weights[(k + 2) % 3]));
      n.quadruple_areas[k] = FT(weights[(k + 2) % 3]) * area;
      if (!is_length(n.squared_lengths[k])) return std::nullopt;
    }
    return n;
  }

  /// makes room for values of so many edges and faces.
  void make_room(std::uint32_t edges, std::uint32_t faces) {
    reserve_at_least(squared_length_, edges);
    reserve_at_least(quadruple_area_, faces);
  }

  /// stores the values at a vertex inserted in a face. \param s its star \param n the values
  void insert_in_face(const Vertex_star& s, Vertex_move_values<FT>&& n) noexcept {
    for (std::size_t k = 0; k < 3; ++k) {
      store(squared_length_, s.spokes[k], std::move(n.squared_lengths[k]));
      store(quadruple_area_, s.faces[k], std::move(n.quadruple_areas[k]));
    }
  }

  /// returns the values that the removal of the vertex of a star makes, to be stored as those of a
  /// flip of the diamond `without_vertex(s)`.
  Flipped removed_values(const Vertex_star& s) const {
    const FT area =
        quadruple_area_[s.faces[0]] + quadruple_area_[s.faces[1]] + quadruple_area_[s.faces[2]];
    return {squared_length_[s.sides[0]], area, area};
  }

  /*!
  \brief computes the values at a vertex inserted on a border edge.
  \param s the star of the vertex, where `ip` is the whole edge and `f` the whole face
  \param parameter weight of `j`
  \return nothing if a length would be zero or infinite
  */
  std::optional<Vertex_move_values<FT>> inserted_values(const Border_star& s,
                                                        double parameter) const {
    const FT ij = squared_length_[s.ip], area = quadruple_area_[s.f], t(parameter), rest(FT(1) - t);
    const FT kp = squared_distance_from_corner(squared_length_[s.ki], ij, squared_length_[s.jk],
                                               area, rest, t);
    const FT ip = t * t * ij, jp = rest * rest * ij;
    if (!is_length(kp) || !is_length(ip) || !is_length(jp)) return std::nullopt;
    return Vertex_move_values<FT>{{ip, jp, kp}, {FT(0), rest * area, t * area}};
  }

  /// stores the values at a vertex inserted on a border edge. \param s its star \param n the values
  /// as if it were in the face: of ip, jp, kp, and of ijp, jkp, kip
  void insert_in_border_edge(const Border_star& s, Vertex_move_values<FT>&& n) noexcept {
    const std::array edges{s.ip, s.pj, s.pk};
    for (std::size_t k = 0; k < 3; ++k)
      store(squared_length_, edges[k], std::move(n.squared_lengths[k]));
    store(quadruple_area_, s.f, std::move(n.quadruple_areas[2]));
    store(quadruple_area_, s.g, std::move(n.quadruple_areas[1]));
  }

  /// returns the values that the removal of a vertex from the border makes; see above.
  Flipped removed_values(const Border_star& s) const {
    return removed_from_border_edge(values(Diamond{s.pk, s.ki, s.ip, s.pj, s.jk, s.f, s.g}));
  }

  /// computes the values of a star whose vertex moves in it, see `moved_in_star()`; nothing if an
  /// area would not be positive, or a length be zero or infinite
  std::optional<Whole_star_values<FT>> moved_values(const Whole_star& s, double b, double c) const {
    auto v = moved_in_star(gather(squared_length_, quadruple_area_, s), FT(b), FT(c));
    for (std::size_t k = 0; k < s.faces.size(); ++k)
      if (!certainly(v.areas[k] > FT(0)) || !is_length(v.spokes[k])) return std::nullopt;
    return v;
  }
  /// stores them.
  void store_star(const Whole_star& s, Whole_star_values<FT>&& v) noexcept {
    for (std::size_t k = 0; k < s.faces.size(); ++k) {
      squared_length_[s.spokes[k]] = std::move(v.spokes[k]);
      quadruple_area_[s.faces[k]] = std::move(v.areas[k]);
    }
  }

  /// tells whether the area of a face is zero.
  bool is_degenerate(std::uint32_t f) const { return certainly(quadruple_area_[f] == FT(0)); }
  /// tells whether the length of an edge is zero.
  bool is_zero_length(std::uint32_t e) const { return certainly(squared_length_[e] == FT(0)); }
  /// returns the squared length of an edge, in scaled units.
  const FT& squared_length(std::uint32_t e) const { return squared_length_[e]; }
  /// returns the quadruple area of a face, in scaled units.
  const FT& quadruple_area(std::uint32_t f) const { return quadruple_area_[f]; }
  /// returns a double near the squared length of an edge, in scaled units.
  double approximate_squared_length(std::uint32_t e) const {
    return CGAL::to_double(squared_length_[e]);
  }
  /// returns a double near the quadruple area of a face, in scaled units.
  double approximate_quadruple_area(std::uint32_t f) const {
    return CGAL::to_double(quadruple_area_[f]);
  }
  /// returns s, where coordinates are scaled by 2^s.
  int scale_exponent() const { return scale_exponent_; }
  /// returns how predicates were decided, which may be reset.
  Predicate_statistics& statistics() const { return statistics_; }

  /*!
  \brief returns (cot k + cot m) / 2 for the angles opposite an edge between two faces.
  \pre both faces have an area
  */
  double cotangent_weight(const Diamond& d) const {
    return cotangent_weight(d.ij, d.jk, d.ki, d.f) + cotangent_weight(d.ij, d.im, d.mj, d.g);
  }

  /// returns half the cotangent of the angle opposite side `ij` of face `f` with sides ij, jk, ki.
  double cotangent_weight(std::uint32_t ij, std::uint32_t jk, std::uint32_t ki,
                          std::uint32_t f) const {
    return CGAL::to_double((squared_length_[jk] + squared_length_[ki] - squared_length_[ij]) /
                           (FT(2) * quadruple_area_[f]));
  }

protected:
  /// returns `cotangent_numerators()`.
  BOOST_FORCEINLINE std::pair<FT, FT> numerators(const Diamond& d) const {
    return cotangent_numerators(squared_length_, d);
  }
  /// returns the values of a diamond.
  Diamond_values<FT> values(const Diamond& d) const {
    return {squared_length_[d.ij], squared_length_[d.jk], squared_length_[d.ki],
            squared_length_[d.im], squared_length_[d.mj], quadruple_area_[d.f],
            quadruple_area_[d.g]};
  }

  /// returns the values of faces.
  auto values(std::span<const Indexed_face> faces) const {
    boost::container::small_vector<Face_values<FT>, 2> result; // no allocation for a face or two
    for (const Indexed_face& f : faces)
      result.push_back(
          {{squared_length_[f.edges[0]], squared_length_[f.edges[1]], squared_length_[f.edges[2]]},
           quadruple_area_[f.face]});
    return result;
  }

private:
  // Whether the flipped edge seems not to be Delaunay. Inlined: a flip computes the same values.
  BOOST_FORCEINLINE bool is_tie_of_rounding(const Diamond& d) const {
    if constexpr (is_exact) return false;
    const Diamond_values<FT> v = values(d);
    const Flipped n = flipped(v);
    const Diamond_values<FT> after{n.km, v.mj, v.jk, v.ki, v.im, n.area_f, n.area_g};
    return certainly(Delaunay_expression()(after) < FT(0));
  }

  static bool is_length(const FT& squared) {
    if constexpr (std::numeric_limits<FT>::has_infinity)
      if (!(squared < std::numeric_limits<FT>::infinity())) return false;
    return certainly(squared > FT(0));
  }

  // numbers of new elements have no gaps
  static void store(std::vector<FT>& values, std::uint32_t i, FT&& value) noexcept {
    i < values.size() ? void(values[i] = std::move(value)) : values.push_back(std::move(value));
  }

  int scale_exponent_ = 0;
  std::vector<FT> squared_length_;
  std::vector<FT> quadruple_area_;
  mutable Predicate_statistics statistics_;
};

/*!
\brief lets an intrinsic triangulation compute in one number type.
\tparam FT_ see `Euclidean_metric`
\cgalModels{IntrinsicTriangulationTraits}
*/
template <FieldNumber FT_>
struct Euclidean_traits {
  /// Number type of the stored values.
  using FT = FT_;
  /// Stores the values and decides.
  using Metric = Euclidean_metric<FT_>;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EUCLIDEAN_TRAITS_H
