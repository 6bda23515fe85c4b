// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_CORRESPONDINGTRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_CORRESPONDINGTRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/enum.h>

#include <concepts>
#include <span>
#include <type_traits>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

template <class Triangulation>
using Correspondence_of =
    std::remove_cvref_t<decltype(std::declval<const Triangulation&>().correspondence())>;

// The correspondence is by curves: integer coordinates, explicit crossings.
template <class Triangulation>
concept Has_curves = CurveCoordinates<Correspondence_of<Triangulation>>;

// A correspondence that answers queries. It constrains the model alone, since the triangulation may
// be incomplete there.
template <class Correspondence>
concept Answers_queries = requires(const Correspondence& c) {
  { c.input() } -> std::same_as<const Input&>;
};

} // namespace internal

/*!
\brief requires a correspondence that answers queries itself, see `Curve_queries`.

Syntax of \ref ::QueriedCorrespondence, which describes its meaning.
*/
template <class Correspondence, class Triangulation>
concept QueriedCorrespondence = internal::Answers_queries<Correspondence> &&
    requires(const Correspondence& c, const Triangulation& t) {
  c.queries(t);
};

/*!
\brief requires a triangulation whose correspondence stores where it lies on its input.

Syntax of \ref ::CorrespondingTriangulation, which describes its meaning.
*/
template <class Triangulation>
concept CorrespondingTriangulation = NumberedTriangulation<Triangulation> &&
    std::default_initializable<typename Triangulation::Metric::Scope> &&
    requires(const Triangulation& t, std::span<const Indexed_face> faces) {
  { Triangulation::Metric::is_exact } -> std::convertible_to<bool>;
  { t.sign(faces, Long_side_expression()) } -> std::same_as<Sign>;
  t.sharpen(faces);
  requires internal::Has_curves<Triangulation> ||
      QueriedCorrespondence<internal::Correspondence_of<Triangulation>, Triangulation>;
};

namespace internal {

// Says what to do if no correspondence can answer queries, before the compiler reports the failed
// concept.
template <class Triangulation>
consteval bool expect_correspondence() {
  if constexpr (requires(const Triangulation& t) { t.correspondence(); })
    static_assert(
        requires(const Triangulation& t) { t.correspondence().input(); },
        "a triangulation without correspondence does not store where edges run on the input; use "
        "Integer_coordinates as third argument of Intrinsic_triangulation");
  return true;
}

} // namespace internal

/*!
\brief requires a `CorrespondingTriangulation`, as all queries do, and says what to do for one that
has no correspondence.

Syntax of \ref ::QueriedTriangulation, where its meaning is described.
*/
template <class Triangulation>
concept QueriedTriangulation =
    internal::expect_correspondence<Triangulation>() && CorrespondingTriangulation<Triangulation>;

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_CORRESPONDINGTRIANGULATION_H
