// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_FLIP_TO_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_FLIP_TO_DELAUNAY_H

#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/connectivity/parameters.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/Delaunay_flipper.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <boost/property_map/property_map.hpp>

#include <cstdint>
#include <iterator>
#include <limits>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief reports what flipping to Delaunay did.
*/
struct Flip_to_delaunay_result {
  /// `done`, `cap` or `cancelled`: all edges that may be flipped are locally Delaunay if it is `done`.
  Status status = Status::done;
  /// Number of edges flipped.
  std::uint64_t flips = 0;
  /// Number of edges tested.
  std::uint64_t checks = 0;
  /// Number of flips refused: the arithmetic made an area that is not positive, or an edge crosses too much of the
  /// input.
  std::uint64_t refused_flips = 0;
};

/*!
\brief observes flipping to Delaunay; the default visitor does nothing.
*/
struct Flip_to_delaunay_visitor {
  /*!
  \brief is called now and then, about every 65536 checks.
  \return whether to go on
  */
  bool progress(const Flip_to_delaunay_result&) { return true; }
};

namespace internal {

// Counts what a flipper does, and stops it.
template <class Triangulation, class Constrained, class Visitor>
class Flip_observer {
  using Halfedge = typename Triangulation::halfedge_descriptor;

public:
  Flip_observer(const Triangulation& t, const typename Triangulation::Session& session,
                Constrained constrained, Visitor& visitor, std::uint64_t cap)
      : t_(t), session_(session), constrained_(constrained), visitor_(visitor), cap_(cap) {}

  bool before_check() {
    if ((++result.checks & 0xffffU) != 0 ||
        session_.suspended([this] { return visitor_.progress(result); }))
      return true;
    result.status = Status::cancelled;
    return false;
  }
  bool is_constrained(Halfedge h) const { return get(constrained_, edge(h, t_.mesh())); }
  bool before_flip() {
    if (result.flips < cap_) return true;
    result.status = Status::cap;
    return false;
  }
  void after_flip(Halfedge) { ++result.flips; }
  void refused(Halfedge) { ++result.refused_flips; }

  Flip_to_delaunay_result result;

private:
  const Triangulation& t_;
  const typename Triangulation::Session& session_;
  Constrained constrained_;
  Visitor& visitor_;
  std::uint64_t cap_;
};

// Not inline, and without parameters by name: the library has it compiled for the usual triangulations.
template <class Triangulation, class EdgeRange, class Constrained, class Visitor>
Flip_to_delaunay_result flip_from(Triangulation& t, const EdgeRange& edges,
                                  const Constrained& constrained, Visitor& visitor,
                                  std::uint64_t cap) {
  typename Triangulation::Session session(t);
  Flip_observer<Triangulation, Constrained, Visitor> observer(t, session, constrained, visitor,
                                                              cap);
  Delaunay_flipper<Triangulation> flipper(t, session);
  for (const typename Triangulation::edge_descriptor e : edges) flipper.push(halfedge(e, t.mesh()));
  flipper.run(observer);
  return observer.result;
}

} // namespace internal

/*!
\brief flips edges until all are locally Delaunay, starting from a range of edges (§4.2 of the
course, Algorithm 1).

Edges whose neighbourhood changes are tested again, whether they are in the range or not. Only edges
that are strictly not Delaunay are flipped, never ties, so that with exact arithmetic the algorithm
ends (Bobenko and Springborn 2007, Proposition 12). With inexact arithmetic a cap on the number of
flips makes it end.

\tparam Triangulation a model of `IntrinsicTriangulation`
\tparam EdgeRange a range of `Triangulation::edge_descriptor`
\tparam NP a chain of named parameters
\param t the triangulation
\param edges the edges to start from
\param np optional named parameters:
  - `edge_is_constrained_map(m)`: a readable property map from edges to `bool`; constrained edges are
    never flipped. Default: none is.
  - `visitor(v)`: see `Flip_to_delaunay_visitor`
  - `maximum_number(n)`: cap on the number of flips. Default: none if the traits are exact, else 100
    per edge and a million.
\return status and counts
\complexity linear in the number of flips, which is linear in the mesh in practice (§4.2), quadratic
  on points of a parabola
*/
template <IntrinsicTriangulation Triangulation, class EdgeRange,
          NamedParameters NP = parameters::Parameters<>>
  requires(!NamedParameters<EdgeRange> &&
           requires(const EdgeRange& r) { std::begin(r), std::end(r); })
Flip_to_delaunay_result flip_to_delaunay(Triangulation& t, const EdgeRange& edges,
                                         const NP& np = parameters::default_values()) {
  using namespace internal::tags;
  using Edge = typename Triangulation::edge_descriptor;
  internal::expect_names<edge_is_constrained_map, visitor, maximum_number>(np);
  const auto constrained = internal::constrained_map<Edge>(np);
  auto stored_visitor = internal::object_or<visitor>(np, Flip_to_delaunay_visitor());
  auto& observed = internal::unwrapped(stored_visitor);
  static_assert(
      requires(const Flip_to_delaunay_result& r) { bool(observed.progress(r)); },
      "a visitor of flip_to_delaunay() derives from Flip_to_delaunay_visitor, or has its "
      "function progress()");
  const std::uint64_t cap = internal::value_or<maximum_number>(
      np, Triangulation::Metric::is_exact ? std::numeric_limits<std::uint64_t>::max()
                                          : 1000000 + 100 * std::uint64_t{num_edges(t.mesh())});
  return internal::flip_from(t, edges, constrained, observed, cap);
}

/*!
\brief flips edges until all are locally Delaunay.

See the overload with a range of edges.
*/
template <IntrinsicTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Flip_to_delaunay_result flip_to_delaunay(Triangulation& t,
                                         const NP& np = parameters::default_values()) {
  return flip_to_delaunay(t, edges(t.mesh()), np);
}

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MISTAKES(flip_to_delaunay, IntrinsicTriangulation,
                                              "maximum_number(1000)")
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_FLIP_TO_DELAUNAY_H
