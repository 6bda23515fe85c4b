// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_DELAUNAY_REFINE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_DELAUNAY_REFINE_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Constrained_segments.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Delaunay_refiner.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_result.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <cstdint>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief inserts vertices until faces meet criteria, and keeps the triangulation Delaunay (§4.3 of the
course, Algorithms 3 to 5; with constraints, §4.4).

A face that does not meet them gets a vertex at its circumcenter. If a border edge or a constrained
edge is in between, that edge is split, and inserted vertices near it are removed, also those of an
earlier refinement or of the user, unless they lie on such edges. Some faces cannot meet a bound of
angles: those that wrap around a vertex whose total angle is too small, and those between border or
constrained edges that make too small an angle. These faces stay and are listed, and so are faces
where the triangulation refuses an insertion. All others meet the criteria, and every edge that is
not constrained is locally Delaunay; with exact traits this is certain. With inexact traits, areas,
lengths and topology are checked at the end: the status is `inaccurate` if rounding has spoilt them.

On a cover (see `make_domain()`), the copies of a vertex on all sheets are inserted together and
share a row of matrices, if the triangulation stores the places of vertices,
`Intrinsic_triangulation::places()`. Where copies would come too close to other vertices, a vertex
is inserted without them (`Refinement_counts::without_copies`). Seams, the edges with one face of
the user or more than two, are `conforming` segments where they make angles of at least 60 degrees
and no constrained edge crosses them; flips restore them first. If refinement stops early, they are
flipped like others: whatever the status, every edge that is not constrained is locally Delaunay.

\tparam Triangulation a model of `RefinableTriangulation`
\tparam NP a chain of named parameters
\param t the triangulation
\param np optional named parameters:
  - `minimum_angle(x)`: least angle of faces, in degrees; 0: any. Up to 30 degrees refinement ends
    by Chew's argument; up to about 34 it usually ends in practice. Default: 25.
  - `maximum_circumradius(x)`: largest circumradius of faces, in the units of the input. Default:
    any.
  - `maximum_edge_length(x)`: largest length of edges, in the units of the input. Default: any.
  - `maximum_insertions(n)`: cap on the number of insertions. Default: a million and ten per face.
  - `order(o)`: which face comes next, a `Refinement_order`. Default: `first_come`.
  - `conforming(b)`: whether constrained edges that are not locally Delaunay are split, so that all
    edges become locally Delaunay; if not, they may stay (the two variants of §4.4 of the course).
    Default: false.
  - `edge_is_constrained_map(m)`: a property map from edges to `bool`, or to labels that convert to
    it; constrained edges are never flipped. If it is writable, the parts of a constrained edge have
    its value in the end, and other edges that are new are not constrained. Default: none is.
  - `visitor(v)`: derived from `Refinement_visitor`
\return status, counts, and the faces that do not meet the criteria
\throws std::invalid_argument if a bound is out of range
\complexity usually linear in the number of vertices inserted
*/
template <RefinableTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Refinement_result<typename Triangulation::face_descriptor>
delaunay_refine(Triangulation& t, const NP& np = parameters::default_values()) {
  using namespace internal::tags;
  using Edge = typename Triangulation::edge_descriptor;
  internal::expect_names<minimum_angle, maximum_circumradius, maximum_edge_length,
                         maximum_insertions, internal::tags::order, conforming,
                         edge_is_constrained_map, visitor>(np);
  const auto constrained = internal::constrained_map<Edge>(np);
  auto stored_visitor = internal::object_or<visitor>(np, Refinement_visitor());
  auto& observed = internal::unwrapped(stored_visitor);
  static_assert(std::is_base_of_v<Refinement_visitor, std::remove_reference_t<decltype(observed)>>,
                "a visitor of refinement derives from Refinement_visitor");
  const internal::Constrained_parts parts(t, constrained);
  auto refined = internal::refine(t, internal::Refinement_settings(np), parts.marks(t),
                                  internal::Refinement_questions(t, observed));
  const Constrained_segments& segments = refined.segments;
  parts.write(t, [&](std::uint32_t e) {
    return segments.is_constrained(e) ? segments.whole(e) : Gluing::none;
  });
  return std::move(refined.result);
}

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MISTAKES(delaunay_refine, RefinableTriangulation,
                                              "minimum_angle(25)")
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_DELAUNAY_REFINE_H
