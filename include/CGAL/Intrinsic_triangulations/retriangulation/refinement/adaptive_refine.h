// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_ADAPTIVE_REFINE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_ADAPTIVE_REFINE_H

#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/connectivity/parameters.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Marked_faces.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_result.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>
#include <CGAL/Intrinsic_triangulations/triangulation/RefinableTriangulation.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief describes a triangulation on which the error was estimated.
*/
struct Adaptive_refinement_round {
  /// Vertices of the triangulation, copies on the sheets of a cover counted once.
  std::size_t vertices = 0;
  /// Root of the sum of the squares of the indicators.
  double estimated_error = 0;
  /// Faces that have the bulk of the error.
  std::size_t marked_faces = 0;
};

/*!
\brief reports what adaptive refinement did.
*/
struct Adaptive_refinement_result {
  /// `done`: the estimated error is at most the tolerance; `cap`: that on the number of vertices or of
  /// rounds was reached; `stalled`: no vertex could be inserted in the faces of large error; `cancelled`;
  /// `inaccurate`: the triangulation must not be used.
  Status status = Status::done;
  /// The triangulations, the one refinement started from first; the last one is that in the end.
  std::vector<Adaptive_refinement_round> rounds;
  /// What rounding has spoilt, if it is `inaccurate`.
  std::optional<Inaccuracy> inaccuracy = std::nullopt;
};

/*!
\brief observes adaptive refinement; the default visitor does nothing.
*/
struct Adaptive_refinement_visitor {
  /*!
  \brief is called after every estimate.
  \return whether to go on
  */
  bool progress(const Adaptive_refinement_round&) { return true; }
};

namespace internal {

// the indicators of faces, with zeros at numbers that no face has
template <class Triangulation>
std::vector<double> checked_indicators(const Triangulation& t, const std::vector<double>& all) {
  if (all.size() != t.numbers().face_capacity(t.mesh()))
    throw std::invalid_argument("there must be an error indicator at the number of every face");
  std::vector<double> indicators(all.size(), 0);
  for (const typename Triangulation::face_descriptor f : faces(t.mesh()))
    indicators[t.index(f)] = all[t.index(f)];
  return indicators;
}

// the numbers among the named parameters
struct Adaptive_limits {
  double error, share, angle;
  std::size_t vertices, rounds;

  template <class NP>
  explicit Adaptive_limits(const NP& np)
      : error(value_or<tags::tolerance>(np, 0.)), share(value_or<tags::bulk>(np, 0.5)),
        angle(value_or<tags::minimum_angle>(np, 25.)),
        vertices(value_or<tags::maximum_vertices>(np, std::size_t{100000})),
        rounds(value_or<tags::maximum_rounds>(np, std::size_t{100})) {
    if (!(error >= 0)) throw std::invalid_argument("the tolerance must not be negative");
  }
};

// the vertices, copies on a cover counted once where the triangulation knows them
template <class Triangulation>
std::size_t number_of_rows(const Triangulation& t) {
  if constexpr (requires { t.number_of_vertices(); })
    return t.number_of_vertices();
  else
    return num_vertices(t.mesh());
}

inline double root_of_squares(const std::vector<double>& values) {
  double sum = 0;
  for (const double x : values) sum += x * x;
  return std::sqrt(sum);
}

} // namespace internal

/*!
\brief refines where a function that is computed on the triangulation has large errors, until its estimated
error is small enough (§4.6 of the course; Sharp, Soliman, Crane 2019, §5.4).

Every round computes the function and an indicator of its error per face, marks the faces that have the
bulk of the error, and makes them smaller by Delaunay refinement. Before the first round the triangulation is
made Delaunay and brought to the least angle, on which constants of error estimates depend. The estimate is
the user's: `residual_indicators()` has some.

\tparam Triangulation a model of `RefinableTriangulation`
\tparam Estimate a functor called with `Triangulation&`, of which it changes nothing but the precision of
  values; it returns a `std::vector<double>` of error indicators, at the numbers of faces, of size
  `t.numbers().face_capacity(t.mesh())`. Their squares sum to that of the error.
\tparam NP a chain of named parameters
\param t the triangulation
\param estimate computes the function, and indicators of its error
\param np optional named parameters:
  - `tolerance(x)`: estimated error at which it is done. Default: 0.
  - `bulk(x)`: share of the squared estimated error that the faces refined in a round have at least
    (Dörfler 1996): the larger, the fewer rounds; the smaller, the fewer vertices. Above 0, at most 1.
    Default: 0.5.
  - `minimum_angle(x)`: least angle of faces, in degrees; see `delaunay_refine()`. Default: 25.
  - `maximum_vertices(n)`: cap on the number of vertices, those of the input included, copies on a cover counted once.
    Default: 100000.
  - `maximum_rounds(n)`: cap on the number of rounds of refinement. Default: 100.
  - `edge_is_constrained_map(m)`: see `delaunay_refine()`
  - `visitor(v)`: see `Adaptive_refinement_visitor`
\return status, and what was reached in every round; the last call of `estimate` was with the triangulation as
  it is in the end, unless that is `inaccurate`
\throws std::invalid_argument if an option makes no sense, an indicator is negative or not finite, or there are
  not as many as numbers of faces
\complexity that of the functor and of `delaunay_refine()`, per round
*/
template <RefinableTriangulation Triangulation, class Estimate,
          NamedParameters NP = parameters::Parameters<>>
Adaptive_refinement_result adaptive_refine(Triangulation& t, Estimate estimate,
                                           const NP& np = parameters::default_values()) {
  using namespace internal::tags;
  using Edge = typename Triangulation::edge_descriptor;
  internal::expect_names<internal::tags::tolerance, bulk, minimum_angle, maximum_vertices,
                         maximum_rounds, edge_is_constrained_map, visitor>(np);
  const internal::Adaptive_limits limit(np);
  const auto constrained = internal::constrained_map<Edge>(np);
  auto stored_visitor = internal::object_or<visitor>(np, Adaptive_refinement_visitor());
  auto& observed = internal::unwrapped(stored_visitor);
  Adaptive_refinement_result result;
  const auto end = [&result](Status status) {
    result.status = status;
    return result;
  };
  // with no more insertions, those of copies included, than the cap on vertices allows; tells how to go on
  const auto refine = [&](auto marks) {
    const std::size_t n = internal::number_of_rows(t);
    const std::uint64_t left = n < limit.vertices ? limit.vertices - n : 0;
    const auto done = delaunay_refine(t, parameters::minimum_angle(limit.angle)
                                             .maximum_insertions(left)
                                             .edge_is_constrained_map(constrained)
                                             .visitor(marks));
    result.inaccuracy = done.inaccuracy;
    if (result.inaccuracy) return Status::inaccurate;
    return done.counts.circumcenters + done.counts.segment_splits > 0 ? Status::done
                                                                      : Status::stalled;
  };
  if (refine(Refinement_visitor()) == Status::inaccurate) return end(Status::inaccurate);
  for (;;) {
    const std::vector<double> indicators = internal::checked_indicators(t, estimate(t));
    const std::vector<std::size_t> marked = mark_bulk(indicators, limit.share);
    const double error = internal::root_of_squares(indicators);
    result.rounds.push_back({internal::number_of_rows(t), error, marked.size()});
    if (!observed.progress(result.rounds.back())) return end(Status::cancelled);
    if (error <= limit.error) return end(Status::done);
    if (internal::number_of_rows(t) >= limit.vertices || result.rounds.size() > limit.rounds)
      return end(Status::cap);
    Marked_faces<Triangulation> faces(t, marked);
    if (const Status s = refine(std::ref(faces)); s != Status::done) return end(s);
  }
}

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(adaptive_refine)
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_ADAPTIVE_REFINE_H
