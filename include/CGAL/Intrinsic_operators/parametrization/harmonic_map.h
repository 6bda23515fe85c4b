// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_HARMONIC_MAP_H
#define CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_HARMONIC_MAP_H

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_operators/parametrization/disk_border.h>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/boost/graph/helpers.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief maps a disk, or several, to the plane by harmonic functions with given values on the border
(§4.10, Fig. 30 of the course).

Each inner vertex is the mean of its neighbours, weighted by cotangents. On a Delaunay triangulation
no weight is negative: if the border is convex, no inner vertex leaves it, and no face turns over
(Tutte, Floater). Faces may be *degenerate* where the triangulation without its edges of weight zero
is not 3-connected (two vertices separate a part from the border, or a face has three vertices on
one side of a polygon), or where the map is smaller than rounding. `certify_map()` finds them
exactly, and `injective_harmonic_map()` refines the triangulation until there are none.

Without `flip_to_delaunay()` the map exists too, but without that guarantee.

\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\param t the triangulation
\param border the positions of the border, see `circular_border()` and `polygonal_border()`; inner
vertices may be fixed too
\param solver how to solve the linear problem
\return a point, x and y, per row of `t.input_vertex()`; given positions stay exactly; isolated
  vertices are at (0, 0)
\throws Invalid_input if a face has no area
\throws std::invalid_argument if rows and positions do not fit, or no value is fixed on a component
\throws Indefinite_matrix (a `std::runtime_error`) if rounding makes the matrix indefinite; it names
a row
\throws No_convergence if you asked for an iteration, and it does not converge
\complexity that of a sparse factorization, or linear for each step of an iteration
*/
template <MeasuredTriangulation Triangulation>
Eigen::MatrixX2d harmonic_map(const Triangulation& t, const Border_map& border,
                              Linear_solver solver = Linear_solver::automatic) {
  const Eigen::SparseMatrix<double> laplacian = cotangent_laplacian(t);
  std::vector<char> has_faces(static_cast<std::size_t>(laplacian.rows()), 0);
  for (const typename Triangulation::halfedge_descriptor h : halfedges(t.mesh()))
    has_faces[t.input_vertex(target(h, t.mesh()))] = 1;
  if (border.positions.rows() != static_cast<Eigen::Index>(border.rows.size()))
    throw std::invalid_argument("there must be a position per row of the border");
  std::vector<std::uint32_t> rows = border.rows;
  for (const std::uint32_t r : border.rows)
    if (r < has_faces.size()) has_faces[r] = 1; // has a place, isolated or not
  for (std::uint32_t r = 0; r < has_faces.size(); ++r)
    if (has_faces[r] == 0) rows.push_back(r);
  Eigen::MatrixX2d values = Eigen::MatrixX2d::Zero(static_cast<Eigen::Index>(rows.size()), 2);
  values.topRows(border.positions.rows()) = border.positions;
  return solve_with_fixed_values(laplacian, Eigen::MatrixX2d::Zero(laplacian.rows(), 2), rows,
                                 values, solver);
}

/// maps a disk to the unit disk by harmonic functions, and several to disks beside each other: to
/// the `circular_border()`.
template <MeasuredTriangulation Triangulation>
  requires NumberedTriangulation<Triangulation> Eigen::MatrixX2d
  harmonic_map(const Triangulation& t, Linear_solver solver = Linear_solver::automatic) {
    return harmonic_map(t, circular_border(t), solver);
  }

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(harmonic_map)
/// \endcond

/*!
\brief holds a harmonic map of a triangulation that was refined for it.
*/
struct Injective_map {
  /// `done`: the map is injective; `cap`: the rounds did not suffice; `inaccurate`: all faces that
  /// do not turn counterclockwise are so small that rounding decides; `stalled`: larger ones
  /// remain, but none of their edges can be split; `cancelled`: the visitor has ended it.
  Status status = Status::done;
  Eigen::MatrixX2d uv;         ///< a point per row, see `harmonic_map()`
  Map_certificate certificate; ///< of that map
  std::size_t inserted = 0;    ///< number of vertices that were inserted
  std::size_t rounds = 0;      ///< number of maps that were not injective
};

namespace internal {

// Keeps the faces whose image is large enough: half of the digits of doubles suffice for its
// orientation, also after a split.
template <class Triangulation>
std::vector<std::uint32_t> large_faces(const Triangulation& t,
                                       const std::vector<std::uint32_t>& faces,
                                       const Eigen::MatrixX2d& uv) {
  const double least = 0x1p-28 * uv.cwiseAbs().maxCoeff();
  std::vector<std::uint32_t> result;
  for (const std::uint32_t f : faces) {
    const auto h = halfedge(t.numbers().face_at(f), t.mesh());
    const auto at = [&](auto side) { return uv.row(t.input_vertex(target(side, t.mesh()))); };
    const auto g = next(h, t.mesh());
    if ((at(g) - at(h)).norm() > least || (at(next(g, t.mesh())) - at(h)).norm() > least)
      result.push_back(f);
  }
  return result;
}

// Where to split the longest edge of a face whose sides, from that edge on, have squared lengths a,
// b and c: in the middle, or in a needle at the geometric mean of its lengths from the short side.
// So a ratio q of sizes takes log log q rounds, not log q.
inline double split_parameter(double a, double b, double c) {
  const double from_end = std::sqrt(std::sqrt(std::min(b, c) / a));
  if (!(from_end < 0.5)) return 0.5;
  return b < c ? 1 - from_end : from_end;
}

// Splits the longest edge of each face that is not at the border. \return the number of edges that
// were split
template <class Triangulation>
std::size_t split_longest_inner_edges(Triangulation& t, const std::vector<std::uint32_t>& faces) {
  using Halfedge = typename Triangulation::halfedge_descriptor;
  const auto& mesh = t.mesh();
  const auto length = [&](Halfedge h) { return t.squared_length(edge(h, mesh)); };
  std::vector<char> is_listed(t.numbers().edge_capacity(mesh), 0);
  std::vector<std::pair<Halfedge, double>> longest; // and where to split it
  for (const std::uint32_t f : faces) {
    double greatest = 0;
    Halfedge best{}, h = halfedge(t.numbers().face_at(f), mesh);
    for (int k = 0; k < 3; ++k, h = next(h, mesh)) {
      if (CGAL::is_border(opposite(h, mesh), mesh) || length(h) <= greatest) continue;
      greatest = length(h);
      best = h;
    }
    if (!(greatest > 0)) continue;
    char& is_there = is_listed[t.index(edge(best, mesh))];
    const Halfedge after = next(best, mesh);
    if (is_there == 0)
      longest.push_back(
          {best, split_parameter(greatest, length(after), length(next(after, mesh)))});
    is_there = 1;
  }
  typename Triangulation::Session session(t);
  std::size_t split = 0;
  for (const auto& [h, parameter] : longest)
    if (session.split_edge(h, parameter).status == Move_status::done) ++split;
  return split;
}

} // namespace internal

/*!
\brief makes a triangulation of a disk, or of several, Delaunay, maps it to the plane by harmonic
functions, and refines it where faces do not turn counterclockwise, until the map is certified to be
injective.

In an intrinsic Delaunay triangulation, two vertices may separate a part from the border: two edges
with the same ends, or a vertex of degree one or two. A map by means of neighbours takes that part
to a line, and also a face with all corners on one side of a polygon. A split of the longest edge
connects the part with others. The split is in the middle, or nearer to the short side of a needle,
so that few rounds suffice. The surface itself does not change.

**What it cannot do.** The tip of a cone of less than 60 degrees has one neighbour only in every
Delaunay triangulation, however fine: then the status is `cap` or `inaccurate`. Maps of long parts
shrink exponentially along them: to 10^-27 at ten times their width. Faces whose image is less than
2^-28 of the whole (needles of 10^-8) have less than half of the digits of doubles, and are not
split: then the status is `inaccurate`. Splits would not help, since rounding decides how their
parts turn: on a rough grid with needles of 10^-9, splits down to 2^-40 inserted more than 2600
vertices in 20 rounds and left at least 100 wrong faces; the limit leaves 27.
\tparam Triangulation a model of `RefinableTriangulation`
\param t the triangulation; it stays refined for every status, and if an exception is
thrown
\param border the positions of the border, a convex polygon; see `circular_border()` and
`polygonal_border()`
\param solver how to solve the linear problems
\param np optional named parameters:
  - `maximum_rounds(n)`: cap on the number of rounds of refinement. Default: 20.
  - `visitor(v)`: `v.progress(map)` is called in each round after flips, and with the new map, and
    returns whether to go on
\return the map, its certificate and status
\throws Invalid_input if a face has no area, or a component is not a disk
\throws std::invalid_argument as `harmonic_map()` does
\throws Indefinite_matrix as `harmonic_map()` does
\complexity that of a harmonic map per round; most inputs need few or none
*/
template <RefinableTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Injective_map injective_harmonic_map(Triangulation& t, const Border_map& border,
                                     Linear_solver solver,
                                     const NP& np = parameters::default_values()) {
  internal::expect_names<internal::tags::maximum_rounds, internal::tags::visitor>(np);
  const std::size_t cap = internal::value_or<internal::tags::maximum_rounds>(np, std::size_t{20});
  auto stored_visitor =
      internal::object_or<internal::tags::visitor>(np, internal::Silent_visitor());
  auto& observed = internal::unwrapped(stored_visitor);
  Injective_map result;
  for (;; ++result.rounds) {
    flip_to_delaunay(t);
    if (!observed.progress(result)) break;
    result.uv = harmonic_map(t, border, solver);
    const Map_certificate complete = internal::complete_certificate(t, result.uv);
    result.certificate = internal::shortened(complete);
    if (complete.is_injective()) return result;
    if (!observed.progress(result)) break;
    if (result.rounds == cap) {
      result.status = Status::cap;
      return result;
    }
    const std::vector<std::uint32_t> bad = internal::large_faces(t, complete.bad_faces, result.uv);
    const std::size_t split = internal::split_longest_inner_edges(t, bad);
    result.inserted += split;
    if (split == 0) {
      result.status =
          bad.empty() && !complete.bad_faces.empty() ? Status::inaccurate : Status::stalled;
      return result;
    }
  }
  result.status = Status::cancelled;
  return result;
}

/// maps disks to a border, with the solver that `solver_for()` chooses; see above.
template <RefinableTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Injective_map injective_harmonic_map(Triangulation& t, const Border_map& border,
                                     const NP& np = parameters::default_values()) {
  return injective_harmonic_map(t, border, Linear_solver::automatic, np);
}

/// maps disks to the `circular_border()`; see above.
template <RefinableTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Injective_map injective_harmonic_map(Triangulation& t,
                                     const NP& np = parameters::default_values()) {
  return injective_harmonic_map(t, circular_border(t), np);
}

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(injective_harmonic_map)
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_HARMONIC_MAP_H
