// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_CONCEPTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_CONCEPTS_H

#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/metric_concepts.h>

#include <CGAL/enum.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <concepts>
#include <cstdint>
#include <span>

/*!
\file
The syntax of the concepts of the package. The page of each concept describes semantics, cost, and
which operation needs which function.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Is asked before a move, when it must not change, makes room for it, and follows it, which cannot
// fail.
template <class Correspondence, class Triangulation, class Move>
concept Observes = requires(const Correspondence& asked, Correspondence& follows,
                            const Triangulation& t, const Move& move) {
  { asked.before(t, move) } -> std::same_as<bool>;
  follows.make_room(t, move);
  { follows.after(t, move) }
  noexcept;
};

// Stores rounded data of edges, which come back exactly when a flip is taken back.
template <class Correspondence>
concept Remembers_rounded_flips = requires(const Correspondence& c, Correspondence& follows,
                                           const Flip& move,
                                           const typename Correspondence::Flipped& values) {
  { c.before_flip(move) } -> std::same_as<typename Correspondence::Flipped>;
  { follows.store_flip(move, values) }
  noexcept;
};

} // namespace internal

/*!
\brief requires an observer of the moves of an intrinsic triangulation.

Syntax of \ref ::IntrinsicCorrespondence, which describes its meaning.
*/
template <class Correspondence, class Triangulation>
concept IntrinsicCorrespondence = std::default_initializable<Correspondence> &&
    std::movable<Correspondence> && internal::Observes<Correspondence, Triangulation, Flip> &&
    internal::Observes<Correspondence, Triangulation, Insertion_in_face> &&
    internal::Observes<Correspondence, Triangulation, Insertion_on_border> &&
    internal::Observes<Correspondence, Triangulation, Removal_from_face> &&
    internal::Observes<Correspondence, Triangulation, Removal_from_border> &&
    requires(Correspondence& c, const Triangulation& t) {
  c.start(t);
};

/*!
\brief requires an observer of vertices that move within their stars, too.

Syntax of \ref ::RepositioningCorrespondence, which describes its meaning.
*/
template <class Correspondence, class Triangulation>
concept RepositioningCorrespondence = IntrinsicCorrespondence<Correspondence, Triangulation> &&
    internal::Observes<Correspondence, Triangulation, Move_in_star>;

namespace internal {

template <class Correspondence, class Triangulation>
constexpr void expect_correspondence() {
  static_assert(IntrinsicCorrespondence<Correspondence, Triangulation>,
                "the third argument of Intrinsic_triangulation is a correspondence, such as "
                "Integer_coordinates; one of your own is a model of IntrinsicCorrespondence: it "
                "has start(), and before() const, make_room() and after() noexcept for each of "
                "the five moves; derive it from No_correspondence, which does nothing");
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
\brief requires elements with numbers, and names on the input.

Syntax of \ref ::IndexedTriangulation, which describes its meaning.
*/
template <class Triangulation>
concept IndexedTriangulation = internal::Has_triangulated_mesh<Triangulation> &&
    internal::Has_matrix_rows<Triangulation> &&
    requires(const Triangulation& t, typename Triangulation::vertex_descriptor v,
             typename Triangulation::halfedge_descriptor h,
             typename Triangulation::face_descriptor f, std::uint32_t i) {
  { t.index(f) } -> std::same_as<std::uint32_t>;
  { t.is_inserted(v) } -> std::same_as<bool>;
  { t.numbers().vertex(v) } -> std::same_as<std::uint32_t>;
  { t.numbers().halfedge(h) } -> std::same_as<std::uint32_t>;
  { t.numbers().face(f) } -> std::same_as<std::uint32_t>;
  { t.numbers().vertex_at(i) } -> std::same_as<typename Triangulation::vertex_descriptor>;
  { t.numbers().halfedge_at(i) } -> std::same_as<typename Triangulation::halfedge_descriptor>;
  { t.numbers().face_at(i) } -> std::same_as<typename Triangulation::face_descriptor>;
};

/*!
\brief requires elements with numbers, values by number, and names on the input: a triangulation
whose lengths and areas `Intrinsic_view` can read.

Syntax of \ref ::NumberedTriangulation, which describes its meaning.
*/
template <class Triangulation>
concept NumberedTriangulation =
    IndexedTriangulation<Triangulation> && internal::Has_approximate_values<Triangulation>;

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
