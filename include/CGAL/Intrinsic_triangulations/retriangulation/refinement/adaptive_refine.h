// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_ADAPTIVE_REFINE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_ADAPTIVE_REFINE_H

#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_result.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/defaults.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Finds the positions of the fewest numbers whose squares sum to a share of the sum of all squares
// (the bulk criterion of Dörfler 1996), the largest first; none where all are zero. Throws
// std::invalid_argument if the share is out of range, or a number negative or not finite.
inline std::vector<std::size_t> mark_bulk(const std::vector<double>& indicators, double bulk) {
  if (!(bulk > 0 && bulk <= 1))
    throw std::invalid_argument("the bulk must be above 0 and at most 1");
  std::vector<std::size_t> order;
  double all = 0;
  for (std::size_t i = 0; i < indicators.size(); ++i) {
    if (!(indicators[i] >= 0) || !std::isfinite(indicators[i]))
      throw std::invalid_argument("the error indicator of face " + std::to_string(i) +
                                  " is negative or not finite; check the solution");
    all += indicators[i] * indicators[i];
    if (indicators[i] > 0) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return indicators[i] != indicators[j] ? indicators[i] > indicators[j] : i < j;
  });
  double sum = 0;
  std::size_t n = 0;
  while (n < order.size() && sum < bulk * all) {
    sum += indicators[order[n]] * indicators[order[n]];
    ++n;
  }
  order.resize(n);
  return order;
}

// A visitor of `delaunay_refine()` that stores faces and has them refined.
//
// A flip gives the number of a face to another one, so that corners and area identify a face. It is
// bad while it is there: until its circumcenter is inserted, or a vertex close by. A later face
// between the same vertices is bad, too, if it is not smaller. All bad faces have at least the area
// of the smallest marked one, and with it a circumradius bounded from below: refinement ends.
template <RefinableTriangulation Triangulation>
class Marked_faces : public Refinement_visitor {
public:
  Marked_faces(const Triangulation& t, const std::vector<std::size_t>& numbers) {
    faces_.reserve(numbers.size());
    for (const std::size_t i : numbers) {
      const auto f = t.numbers().face_at(static_cast<std::uint32_t>(i));
      // predicates may sharpen the area by some roundings
      faces_.push_back({corners(t, f), (1 - 0x1p-20) * t.area(f)});
    }
    std::sort(faces_.begin(), faces_.end());
  }
  // Whether a face is marked, or has replaced a marked one and is as large.
  bool is_bad(const Triangulation& t, typename Triangulation::face_descriptor f) const {
    const Corners c = corners(t, f);
    const auto least =
        std::lower_bound(faces_.begin(), faces_.end(), c,
                         [](const Mark& m, const Corners& k) { return m.first < k; });
    return least != faces_.end() && least->first == c && t.area(f) >= least->second;
  }

private:
  using Corners = std::array<std::uint32_t, 3>;
  using Mark = std::pair<Corners, double>; // and the least area

  static Corners corners(const Triangulation& t, typename Triangulation::face_descriptor f) {
    const auto& mesh = t.mesh();
    const auto h = halfedge(f, mesh), n = next(h, mesh);
    Corners c{t.index(source(h, mesh)), t.index(target(h, mesh)), t.index(target(n, mesh))};
    std::sort(c.begin(), c.end());
    return c;
  }

  std::vector<Mark> faces_;
};

} // namespace internal

/*!
\brief describes a triangulation on which the error was estimated.
*/
struct Adaptive_refinement_round {
  /// Vertices of the triangulation, copies on the sheets of a cover counted once.
  std::size_t vertices = 0;
  /// Root of the sum of the squares of the indicators.
  double estimated_error = 0;
  /// Number of faces with the bulk of the error.
  std::size_t marked_faces = 0;
};

/*!
\brief reports what adaptive refinement did.
*/
struct Adaptive_refinement_result {
  /// `done`: the estimated error is at most the tolerance; `cap`: the cap on vertices or rounds was
  /// reached; `stalled`: no vertex could be inserted in the faces of large error; `cancelled`;
  /// `inaccurate`: do not use the triangulation.
  Status status = Status::done;
  /// The triangulations: first the one before refinement, last the one at the end.
  std::vector<Adaptive_refinement_round> rounds;
  /// Damage by rounding, if it is `inaccurate`.
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
        angle(value_or<tags::minimum_angle>(np, defaults::min_angle)),
        vertices(value_or<tags::maximum_vertices>(np, std::size_t{100000})),
        rounds(value_or<tags::maximum_rounds>(np, std::size_t{100})) {
    if (!(error >= 0)) throw std::invalid_argument("the tolerance must not be negative");
  }
};

// the vertices; copies on a cover count once where the triangulation stores them
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
\brief refines where a function that is computed on the triangulation has large errors, until its
estimated error is small enough (§4.6 of the course; Sharp, Soliman, Crane 2019, §5.4).

Every round computes the function and an indicator of its error per face, marks the faces that have
the bulk of the error, and makes them smaller by Delaunay refinement. Before the first round the
triangulation is made Delaunay and brought to the least angle, on which constants of error estimates
depend. The estimate is the user's: `residual_indicators()` has some.

\tparam Triangulation a model of `RefinableTriangulation`
\tparam Estimate a functor called with `Triangulation&`, which may only change the precision of its
  values; it returns a `std::vector<double>` of error indicators, at the numbers of faces, of size
  `t.numbers().face_capacity(t.mesh())`. Their squares sum to that of the error.
\tparam NP a chain of named parameters
\param t the triangulation
\param estimate computes the function, and indicators of its error
\param np optional named parameters: - `tolerance(x)`: estimated error at which it is done. Default:
  0. - `bulk(x)`: share of the squared estimated error that the faces refined in a round have at
  least (Dörfler 1996): the larger, the fewer rounds; the smaller, the fewer vertices. Above 0, at
  most 1. Default: 0.5. - `minimum_angle(x)`: least angle of faces, in degrees; see
  `delaunay_refine()`. Default: 25. - `maximum_vertices(n)`: cap on the number of vertices, those of
  the input included, copies on a cover counted once. Default: 100000. - `maximum_rounds(n)`: cap on
  the number of rounds of refinement. Default: 100. - `edge_is_constrained_map(m)`: see
  `delaunay_refine()` - `visitor(v)`: see `Adaptive_refinement_visitor`
\return status, and what was reached in every round; the last call of `estimate` was with the
  triangulation as it is in the end, unless that is `inaccurate`
\throws std::invalid_argument if an option is out of range, an indicator is negative or not finite,
  or there are not as many as numbers of faces
\complexity that of the functor and of `delaunay_refine()`, per round
*/
template <RefinableTriangulation Triangulation, class Estimate,
          NamedParameters NP = parameters::Parameters<>>
requires std::is_invocable_r_v<std::vector<double>, Estimate&, Triangulation&>
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
  // with no more insertions, those of copies included, than the cap on vertices allows; tells how
  // to go on
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
    const std::vector<std::size_t> marked = internal::mark_bulk(indicators, limit.share);
    const double error = internal::root_of_squares(indicators);
    result.rounds.push_back({internal::number_of_rows(t), error, marked.size()});
    if (!observed.progress(result.rounds.back())) return end(Status::cancelled);
    if (error <= limit.error) return end(Status::done);
    if (internal::number_of_rows(t) >= limit.vertices || result.rounds.size() > limit.rounds)
      return end(Status::cap);
    internal::Marked_faces<Triangulation> faces(t, marked);
    if (const Status s = refine(std::ref(faces)); s != Status::done) return end(s);
  }
}

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(adaptive_refine)
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_ADAPTIVE_REFINE_H
