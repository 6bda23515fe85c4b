// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_FLIP_TO_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_FLIP_TO_DELAUNAY_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Proof_watch.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/Delaunay_flipper.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/caps.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/enum.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief reports which edges are locally Delaunay.
\tparam Edge an edge descriptor
*/
template <std::semiregular Edge>
struct Delaunay_report {
  /// Number of edges whose opposite angles sum to more than pi.
  std::size_t non_delaunay_edges = 0;
  /// Edges whose opposite angles sum to exactly pi: in a Delaunay triangulation, those that are not
  /// edges of the Delaunay tessellation, whose cells are the unions of faces across them.
  std::vector<Edge> cocircular_edges;
};

/*!
\brief tests every edge for the Delaunay property.

With exact traits the answer is exact. If there are no edges that are not Delaunay, removing
the cocircular ones leaves the Delaunay tessellation, which is unique (Bobenko and Springborn 2007).
Edges on the border, or with the same face on both sides, are locally Delaunay.
\tparam Triangulation a model of `IntrinsicTriangulation`
\complexity linear
*/
template <IntrinsicTriangulation Triangulation>
Delaunay_report<typename Triangulation::edge_descriptor> check_delaunay(const Triangulation& t) {
  using Edge = typename Triangulation::edge_descriptor;
  using Halfedge = typename Triangulation::halfedge_descriptor;
  const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
  const auto& mesh = t.mesh();
  const typename Triangulation::Const_session session(t);
  Delaunay_report<Edge> report;
  for (const Edge e : edges(mesh)) {
    const Halfedge h = halfedge(e, mesh), o = opposite(h, mesh);
    if (face(h, mesh) == null || face(o, mesh) == null || face(h, mesh) == face(o, mesh)) continue;
    const Sign s = session.delaunay_sign(h);
    if (s == NEGATIVE) ++report.non_delaunay_edges;
    if (s == ZERO) report.cocircular_edges.push_back(e);
  }
  return report;
}

/*!
\brief tells whether all edges are locally Delaunay.
\tparam Triangulation a model of `IntrinsicTriangulation`
\complexity linear
*/
template <IntrinsicTriangulation Triangulation>
bool is_delaunay(const Triangulation& t) {
  const typename Triangulation::Const_session session(t);
  for (const typename Triangulation::edge_descriptor e : edges(t.mesh()))
    if (!session.is_locally_delaunay(halfedge(e, t.mesh()))) return false;
  return true;
}

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(is_delaunay)
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(check_delaunay)
/// \endcond

/*!
\brief reports what flipping to Delaunay did.
*/
struct Flip_to_delaunay_result {
  /// `done`, `cap` or `cancelled`; after `done`, all edges that may be flipped are locally
  /// Delaunay.
  Status status = Status::done;
  /// Number of edges flipped.
  std::uint64_t flips = 0;
  /// Number of edges tested.
  std::uint64_t checks = 0;
  /// Number of flips refused: a computed area was not positive, or an edge would cross too much of
  /// the input.
  std::uint64_t refused_flips = 0;
};

/*!
\brief observes flipping to Delaunay; the default visitor does nothing.
*/
struct Flip_to_delaunay_visitor {
  /*!
  \brief is called about every 65536 checks, and by proofs that take long.
  \return whether to go on
  */
  bool progress(const Flip_to_delaunay_result&) { return true; }
};

namespace internal {

// Asks a visitor of any type whether to go on.
using Flip_progress = std::function<bool(const Flip_to_delaunay_result&)>;

// Counts what a flipper does, and stops it.
template <class Triangulation, class Constrained>
class Flip_observer {
  using Halfedge = typename Triangulation::halfedge_descriptor;

public:
  Flip_observer(const Triangulation& t, const typename Triangulation::Session& session,
                Constrained constrained, const Flip_progress& progress, std::uint64_t cap)
      : t_(t), session_(session), constrained_(constrained), progress_(progress), cap_(cap) {}

  bool before_check() {
    if ((++result.checks & 0xffffU) != 0 && !watch_.is_stopped()) return true;
    if (!watch_.is_stopped() && session_.suspended([this] { return progress_(result); }))
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
  const Flip_progress& progress_;
  std::uint64_t cap_;
  Proof_watch watch_{[this] { return progress_(result); }};
};

// Not inline, and without parameters by name: the library has it compiled for the usual
// triangulations.
template <class Triangulation, class EdgeRange, class Constrained>
Flip_to_delaunay_result flip_from(Triangulation& t, const EdgeRange& edges,
                                  const Constrained& constrained, const Flip_progress& progress,
                                  std::uint64_t cap) {
  typename Triangulation::Session session(t);
  Flip_observer<Triangulation, Constrained> observer(t, session, constrained, progress, cap);
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
  - `edge_is_constrained_map(m)`: a readable property map from edges to `bool`; constrained edges
    are never flipped. Default: none is.
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
                                          : internal::flip_cap(num_edges(t.mesh())));
  return internal::flip_from(
      t, edges, constrained,
      [&observed](const Flip_to_delaunay_result& r) { return bool(observed.progress(r)); }, cap);
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
