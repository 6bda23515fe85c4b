// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_CONCEPTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_CONCEPTS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

/*!
\file
The syntax of the concepts of the package. The page of each concept describes semantics, cost, and
which operation needs which function.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {
// The argument of a metric that decides by the input: see `Exact_values`.
struct Any_exact_values {
  using FT = Interval_nt<false>;
  Sign sign(const Diamond&, const Recorded_diamond_expression&, Diamond_values<FT>&,
            Predicate_statistics&) const;
  Sign sign(std::span<const Indexed_face>, const Recorded_face_expression&,
            std::vector<Face_values<FT>>&, Predicate_statistics&) const;
  unsigned for_each_enclosure(std::span<const Indexed_face>, unsigned, const auto& visit) const;
  FT first_squared_length(const Indexed_face&, unsigned) const;
  double nonzero_weight(const Diamond&, Predicate_statistics&) const;
};

// Decides predicates, with exact values if they are given.
template <class Metric, class... Exact>
concept Decides = requires(const Metric& c, const Diamond& d, const Exact&... exact) {
  { c.is_locally_delaunay(d, exact...) } -> std::same_as<bool>;
  { c.sign(d, Delaunay_expression(), exact...) } -> std::same_as<Sign>;
  { c.sign(d, Convexity_at_source_expression(), exact...) } -> std::same_as<Sign>;
  { c.sign(d, Convexity_at_target_expression(), exact...) } -> std::same_as<Sign>;
  { c.cotangent_weight(d, exact...) } -> std::convertible_to<double>;
};

template <class Metric>
concept Decides_by_input = Decides<Metric, Any_exact_values>;

} // namespace internal

/*!
\brief requires the storage of a metric that decides predicates.

Syntax of \ref ::IntrinsicMetric, which describes its meaning.
*/
template <class Metric>
concept IntrinsicMetric =
    (internal::Decides<Metric> || internal::Decides_by_input<Metric>)&&std::default_initializable<
        Metric>&& std::movable<Metric>&& std::default_initializable<typename Metric::Scope>&& std::
        constructible_from<Metric, const Gluing_map&, const Input_metric&>&& requires(
            Metric& m, const Metric& c, const Diamond& d, std::uint32_t i) {
  typename Metric::FT;
  { Metric::is_exact } -> std::convertible_to<bool>;
  { c.compute_flip(d) } -> std::same_as<std::optional<typename Metric::Flipped>>;
  { c.compute_flip_to_zero_area(d) } -> std::same_as<std::optional<typename Metric::Flipped>>;
  m.store_flip(d, *c.compute_flip(d));
  { c.cotangent_weight(i, i, i, i) } -> std::convertible_to<double>;
  { c.is_degenerate(i) } -> std::same_as<bool>;
  { c.is_zero_length(i) } -> std::same_as<bool>;
  { c.squared_length(i) } -> std::convertible_to<typename Metric::FT>;
  { c.quadruple_area(i) } -> std::convertible_to<typename Metric::FT>;
  { c.approximate_squared_length(i) } -> std::same_as<double>;
  { c.approximate_quadruple_area(i) } -> std::same_as<double>;
  { c.scale_exponent() } -> std::same_as<int>;
};

namespace internal {

// Returns the values that a flip will replace, and restores them.
template <class Metric>
concept Remembers_flips = requires(Metric& m, const Metric& c, const Diamond& d) {
  { c.before_flip(d) } -> std::same_as<typename Metric::Before_flip>;
  m.undo_flip(d, c.before_flip(d));
};

template <class Metric>
struct Known_before_flip {
  using type = void*; // nothing
};
template <Remembers_flips Metric>
struct Known_before_flip<Metric> {
  using type = typename Metric::Before_flip;
};
template <class Metric>
using Before_flip_of = typename Known_before_flip<Metric>::type;

// Computes the values of an insertion from stored ones.
template <class Metric>
concept Measures_insertions = requires(Metric& m, const Vertex_star& star,
                                       const Border_star& border,
                                       const std::array<double, 3>& weights, double parameter) {
  { m.insert_in_face(star, weights) } -> std::same_as<bool>;
  { m.insert_in_border_edge(border, parameter) } -> std::same_as<bool>;
};

// Receives the values of an insertion from the places of vertices on the input, and decides by
// those.
template <class Metric>
concept Defined_by_places = Decides_by_input<Metric> &&
    requires(Metric& m, const Vertex_star& star, const Border_star& border,
             const Vertex_move_values<typename Metric::FT>& values) {
  m.insert_in_face(star, values);
  m.insert_in_border_edge(border, values);
};

} // namespace internal

/*!
\brief requires a metric that follows the insertion and removal of vertices.

Syntax of \ref ::RefinableMetric, which describes its meaning.
*/
template <class Metric>
concept RefinableMetric = IntrinsicMetric<Metric> &&
    (internal::Measures_insertions<Metric> ||
     internal::Defined_by_places<Metric>)&&requires(Metric& m, const Vertex_star& star,
                                                    const Border_star& border) {
  m.remove_from_face(star);
  m.remove_from_border_edge(border);
};

/*!
\brief requires the arithmetic of an intrinsic triangulation.

Syntax of \ref ::IntrinsicTriangulationTraits, which describes its meaning.
*/
template <class Traits>
concept IntrinsicTriangulationTraits = requires {
  typename Traits::FT;
  typename Traits::Metric;
}
&&IntrinsicMetric<typename Traits::Metric>&&
    std::same_as<typename Traits::FT, typename Traits::Metric::FT>;

/*!
\brief requires an observer of the moves of an intrinsic triangulation.

Syntax of \ref ::IntrinsicCorrespondence, which describes its meaning.
*/
template <class Correspondence, class Triangulation>
concept IntrinsicCorrespondence = std::default_initializable<Correspondence> &&
    std::movable<Correspondence> &&
    requires(Correspondence& c, const Triangulation& t, const Flip& flip,
             const Insertion_in_face& insertion, const Insertion_on_border& border_insertion,
             const Removal_from_face& removal, const Removal_from_border& border_removal) {
  c.start(t);
  { c.before(t, flip) } -> std::same_as<bool>;
  c.after(t, flip);
  { c.before(t, insertion) } -> std::same_as<bool>;
  c.after(t, insertion);
  { c.before(t, border_insertion) } -> std::same_as<bool>;
  c.after(t, border_insertion);
  { c.before(t, removal) } -> std::same_as<bool>;
  c.after(t, removal);
  { c.before(t, border_removal) } -> std::same_as<bool>;
  c.after(t, border_removal);
};

namespace internal {

template <class Correspondence, class Triangulation>
constexpr void expect_correspondence() {
  static_assert(IntrinsicCorrespondence<Correspondence, Triangulation>,
                "the third argument of Intrinsic_triangulation is a model of "
                "IntrinsicCorrespondence: it has start(), and before() and after() each of the "
                "five moves; derive it from No_correspondence, which does nothing");
}

// Has a mesh, and numbers for its edges.
template <class Triangulation>
concept Has_triangulated_mesh = requires(const Triangulation& t,
                                         typename Triangulation::halfedge_descriptor,
                                         typename Triangulation::edge_descriptor e) {
  requires Has_mesh_elements<typename Triangulation::Mesh>;
  requires Has_connectivity<typename Triangulation::Mesh>;
  { t.mesh() } -> std::same_as<const typename Triangulation::Mesh&>;
  { t.index(e) } -> std::convertible_to<std::uint32_t>;
};

// Has areas of faces, and doubles near the values of its metric, by number, in scaled units.
template <class Triangulation>
concept Has_approximate_values = requires(const Triangulation& t,
                                          typename Triangulation::face_descriptor f,
                                          std::uint32_t i) {
  { t.index(f) } -> std::same_as<std::uint32_t>;
  { t.area(f) } -> std::same_as<double>;
  { t.metric() } -> std::same_as<const typename Triangulation::Metric&>;
  { t.metric().approximate_squared_length(i) } -> std::same_as<double>;
  { t.metric().approximate_quadruple_area(i) } -> std::same_as<double>;
  { t.metric().scale_exponent() } -> std::same_as<int>;
};

// Has the rows of its vertices in matrices, their number, and the user's names of elements.
template <class Triangulation>
concept Has_matrix_rows = requires(const Triangulation& t,
                                   typename Triangulation::vertex_descriptor v) {
  { t.index(v) } -> std::same_as<std::uint32_t>;
  { t.input() } -> std::convertible_to<const Input_definition&>;
  { t.input_vertex(v) } -> std::same_as<std::uint32_t>;
  { t.number_of_vertices() } -> std::same_as<std::uint32_t>;
  { t.numbers().edge_capacity(t.mesh()) } -> std::same_as<std::uint32_t>;
  { t.numbers().face_capacity(t.mesh()) } -> std::same_as<std::uint32_t>;
};

} // namespace internal

/*!
\brief requires of a triangulation what algorithms that flip edges need.

Syntax of \ref ::IntrinsicTriangulation, which describes its meaning.
*/
template <class Triangulation>
concept IntrinsicTriangulation = internal::Has_triangulated_mesh<Triangulation> &&
    std::constructible_from<typename Triangulation::Session, Triangulation&> &&
    std::constructible_from<typename Triangulation::Const_session, const Triangulation&> &&
    requires(typename Triangulation::Session& s, const typename Triangulation::Const_session& c,
             typename Triangulation::halfedge_descriptor h) {
  { Triangulation::Metric::is_exact } -> std::convertible_to<bool>;
  { c.is_locally_delaunay(h) } -> std::same_as<bool>;
  { c.delaunay_sign(h) } -> std::same_as<Sign>;
  { s.is_locally_delaunay(h) } -> std::same_as<bool>;
  { s.flip_non_delaunay_edge(h) } -> std::same_as<Move_status>;
  {
    c.suspended([] { return true; })
    } -> std::same_as<bool>;
};

/*!
\brief requires elements with numbers, values by number, and names on the input: a triangulation
that `Intrinsic_view` can read.

Syntax of \ref ::NumberedTriangulation, which describes its meaning.
*/
template <class Triangulation>
concept NumberedTriangulation = internal::Has_triangulated_mesh<Triangulation> &&
    internal::Has_approximate_values<Triangulation> && internal::Has_matrix_rows<Triangulation> &&
    requires(const Triangulation& t, typename Triangulation::vertex_descriptor v,
             typename Triangulation::halfedge_descriptor h,
             typename Triangulation::face_descriptor f, std::uint32_t i) {
  { t.is_inserted(v) } -> std::same_as<bool>;
  { t.numbers().vertex(v) } -> std::same_as<std::uint32_t>;
  { t.numbers().halfedge(h) } -> std::same_as<std::uint32_t>;
  { t.numbers().face(f) } -> std::same_as<std::uint32_t>;
  { t.numbers().vertex_at(i) } -> std::same_as<typename Triangulation::vertex_descriptor>;
  { t.numbers().halfedge_at(i) } -> std::same_as<typename Triangulation::halfedge_descriptor>;
  { t.numbers().face_at(i) } -> std::same_as<typename Triangulation::face_descriptor>;
};

/*!
\brief requires of a triangulation what measures and assembly of matrices need.

Syntax of \ref ::MeasuredTriangulation, which describes its meaning.
*/
template <class Triangulation>
concept MeasuredTriangulation = internal::Has_triangulated_mesh<Triangulation> &&
    internal::Has_approximate_values<Triangulation> && internal::Has_matrix_rows<Triangulation> &&
    std::constructible_from<typename Triangulation::Const_session, const Triangulation&> &&
    requires(const Triangulation& t, const typename Triangulation::Const_session& c,
             typename Triangulation::edge_descriptor e, typename Triangulation::face_descriptor f,
             std::uint32_t i, double x) {
  { t.metric().is_degenerate(i) } -> std::same_as<bool>;
  { t.squared_length(e) } -> std::same_as<double>;
  { c.cotangent_weight(e) } -> std::same_as<double>;
  { c.cotangent_weight(e, x) } -> std::same_as<double>;
};

/*!
\brief requires of a triangulation what algorithms that insert, remove and move vertices need.

Syntax of \ref ::RefinableTriangulation, which describes its meaning.
*/
template <class Triangulation>
concept RefinableTriangulation = IntrinsicTriangulation<Triangulation> &&
    MeasuredTriangulation<Triangulation> && NumberedTriangulation<Triangulation> &&
    requires(const Triangulation& t, typename Triangulation::Session& s,
             typename Triangulation::vertex_descriptor v,
             typename Triangulation::halfedge_descriptor h, const std::array<double, 3>& weights,
             std::span<const Indexed_face> faces, double x) {
  { t.sign(faces, Long_side_expression()) } -> std::same_as<Sign>;
  { s.insert_vertex(h, weights).status } -> std::convertible_to<Move_status>;
  { s.insert_vertex(h, weights).vertex } -> std::convertible_to<decltype(v)>;
  { s.split_edge(h, x).status } -> std::convertible_to<Move_status>;
  { s.split_edge(h, x).vertex } -> std::convertible_to<decltype(v)>;
  { s.remove_vertex(v) } -> std::same_as<Move_status>;
  { s.reposition_vertex(v, h, weights).vertex } -> std::convertible_to<decltype(v)>;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_CONCEPTS_H
