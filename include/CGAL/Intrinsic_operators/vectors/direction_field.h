// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_DIRECTION_FIELD_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_DIRECTION_FIELD_H

#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_operators/vectors/Direction_problem.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>

#include <Eigen/Core>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/*!
\file
Smoothest fields of directions (F. Knoeppel, K. Crane, U. Pinkall, P. Schroeder, *Globally
  Optimal Direction Fields*, 2013).
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds `degree` equivalent directions at each vertex: vectors, lines, crosses.
*/
struct Direction_field {
  /// Number of directions: 1 for vectors, 2 for lines, 4 for crosses.
  int degree = 1;
  /// The powers of the directions, of absolute value 1, by the numbers of a `Tangent_field`; zero
  /// at isolated vertices.
  std::vector<std::complex<double>> powers;
  /// `cancelled` by the caller: then there are no powers
  Status status = Status::done;

  /// returns one of the directions at each vertex. \param which a number below `degree`
  Tangent_field directions(int which = 0) const {
    Tangent_field result(powers.size());
    for (std::size_t i = 0; i < powers.size(); ++i)
      if (powers[i] != 0.)
        result[i] = std::polar(1., (std::arg(powers[i]) + 2 * std::numbers::pi * which) / degree);
    return result;
  }
};

namespace internal {

// the power of a direction, with a length
inline std::complex<double> power_of(const std::complex<double>& z, int degree) {
  return std::polar(std::abs(z), degree * std::arg(z));
}

template <class Triangulation>
void expect_degree(int degree) {
  if (degree < 1)
    throw std::invalid_argument("a field has at least one direction at a vertex, not " +
                                std::to_string(degree));
}

template <class Triangulation>
using Fixed_directions =
    std::vector<std::pair<typename Triangulation::vertex_descriptor, std::complex<double>>>;

// The problem without guide.
template <class Triangulation>
Direction_problem direction_problem(const Triangulation& t, int degree,
                                    const Fixed_directions<Triangulation>& fixed) {
  expect_degree<Triangulation>(degree);
  const Vertex_copies<Triangulation> copies(t);
  Direction_problem problem{
      degree, Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(copies.size())), 0, {}};
  std::map<std::size_t, std::pair<std::complex<double>, double>> sums; // and the number of each
  for (const auto& [v, z] : fixed) {
    const std::complex<double> u = unit_vector(z);
    if (u == 0. || Intrinsic_triangulations::internal::is_isolated(t, v))
      throw std::invalid_argument("the direction at vertex " + std::to_string(copies(v)) +
                                  " cannot be fixed: it is zero or not finite, or the vertex has "
                                  "no face");
    auto& [sum, count] = sums[copies(v)];
    sum += power_of(u, degree);
    ++count;
  }
  for (const auto& [i, sum] : sums) {
    if (!(std::abs(sum.first) > cancelled * sum.second))
      throw std::invalid_argument(
          "the directions at vertex " + std::to_string(i) +
          " cancel, such as one across a border of a cover, which points there from both sides; "
          "give one along the border, or fix another vertex");
    problem.fixed.push_back({i, unit_vector(sum.first)});
  }
  return problem;
}

template <class Triangulation>
Direction_field solved(const Triangulation& t, const Direction_problem& problem,
                       const std::function<bool(Direction_step)>& progress) {
  const Halfedge_angles angles(t, Border_angles::half_circle);
  Direction_field field{problem.degree, solve(problem, connection_graph(t, angles), progress)};
  if (field.powers.empty() && problem.guide.size() > 0) field.status = Status::cancelled;
  return field;
}

} // namespace internal

/*!
\brief finds the smoothest field of directions: of least energy

    sum over edges of w_ij |z_j - r_ij^degree z_i|^2

among those whose powers `z` have length 1 in the mean, the eigenvector of the connection Laplacian
for the least eigenvalue, in every component; values are then divided by their lengths. On the
border directions are free.

In components with fixed directions, as along curves (`directions_along_path()`), the field is the
solution of a linear problem.
\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`, Delaunay
\param t the triangulation
\param degree the number of equivalent directions at a vertex: 1 for vectors, 4 for crosses
\param fixed vertices, and their fixed directions in polar coordinates; if there are several at a
  vertex, the mean of their powers counts
\param solver how to solve the linear problems: one for each step of the search for an eigenvector
\param np optional named parameters:
  - `visitor(v)`: `v.progress(step)` is called with a `Direction_step` after each step that takes
    long but the last, and returns whether to go on.
\return the field; on symmetric surfaces, one of several
\throws Invalid_input if a face has no area
\throws std::invalid_argument if the degree is not positive, a direction cannot be fixed, or the
  surface is that of a cloud of points, see
  `Point_cloud_vectors`
\complexity that of factoring a complex matrix, and of solving with it for some tens of times
*/
template <ConnectedTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Direction_field smoothest_direction_field(const Triangulation& t, int degree,
                                          const internal::Fixed_directions<Triangulation>& fixed,
                                          Linear_solver solver,
                                          const NP& np = parameters::default_values()) {
  internal::expect_names<internal::tags::visitor>(np);
  internal::Direction_problem problem = internal::direction_problem(t, degree, fixed);
  problem.solver = solver;
  return internal::solved(t, problem, internal::progress_of(np));
}

/// finds the smoothest field with the solver that `solver_for()` chooses; see above.
template <ConnectedTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Direction_field
smoothest_direction_field(const Triangulation& t, int degree,
                          const internal::Fixed_directions<Triangulation>& fixed = {},
                          const NP& np = parameters::default_values()) {
  return smoothest_direction_field(t, degree, fixed, Linear_solver::automatic, np);
}

/*!
\brief finds a smooth field of directions that is near given ones.

It solves `(L + s M) z = M q` with the connection Laplacian L and the mass matrix M, q the powers of
the given directions with their lengths as weights, and s the strength divided by the square of the
mean length of edges.
\param t the triangulation, see `smoothest_direction_field()`
\param degree the number of equivalent directions at a vertex \param guide vectors in polar
  coordinates by the numbers of a `Tangent_field`: one of the directions wanted at each vertex,
  longer where it matters more, zero where any direction will do. Principal directions have degree
  2: both signs.
\param strength zero gives the smoothest guided field; larger values bring it closer to the guide
\param fixed see `smoothest_direction_field()`
\param solver see `smoothest_direction_field()`
\param np see `smoothest_direction_field()`
\throws std::invalid_argument if there is not a vector per vertex, or the strength is negative, and
as `smoothest_direction_field()` does
*/
template <ConnectedTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Direction_field
aligned_direction_field(const Triangulation& t, int degree, const Tangent_field& guide,
                        double strength, const internal::Fixed_directions<Triangulation>& fixed,
                        Linear_solver solver, const NP& np = parameters::default_values()) {
  internal::expect_names<internal::tags::visitor>(np);
  internal::Direction_problem problem = internal::direction_problem(t, degree, fixed);
  if (guide.size() != static_cast<std::size_t>(problem.guide.size()))
    throw std::invalid_argument("there must be a vector per vertex to be near, " +
                                std::to_string(problem.guide.size()) + ", not " +
                                std::to_string(guide.size()));
  if (!(strength >= 0) || !std::isfinite(strength))
    throw std::invalid_argument("the strength of alignment must not be negative");
  double longest = 0; // lengths are weights: only their ratios count
  for (const std::complex<double>& z : guide) longest = std::max(longest, std::abs(z));
  if (!std::isfinite(longest)) throw std::invalid_argument("vectors to be near must be finite");
  for (std::size_t i = 0; i < guide.size() && longest > 0; ++i)
    problem.guide[static_cast<Eigen::Index>(i)] = internal::power_of(guide[i] / longest, degree);
  problem.strength = strength;
  problem.solver = solver;
  return internal::solved(t, problem, internal::progress_of(np));
}

/// finds a smooth field with the solver that `solver_for()` chooses; see above.
template <ConnectedTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Direction_field aligned_direction_field(const Triangulation& t, int degree,
                                        const Tangent_field& guide, double strength = 0,
                                        const internal::Fixed_directions<Triangulation>& fixed = {},
                                        const NP& np = parameters::default_values()) {
  return aligned_direction_field(t, degree, guide, strength, fixed, Linear_solver::automatic, np);
}

/*!
\brief returns the directions along a path of edges, at its vertices, to fix in fields that follow
it.

A vertex between two edges of the path gets the middle direction. If the path passes a vertex twice,
the first time counts.
\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\param t the triangulation
\param path halfedges of `t.mesh()`, each from the target of the one before
\return vertices and unit vectors in their polar coordinates
\complexity linear
*/
template <ConnectedTriangulation Triangulation>
internal::Fixed_directions<Triangulation>
directions_along_path(const Triangulation& t,
                      const std::vector<typename Triangulation::halfedge_descriptor>& path) {
  const internal::Halfedge_angles angles(t, internal::Border_angles::half_circle);
  std::vector<char> is_passed(t.numbers().vertex_capacity(t.mesh()), 0);
  internal::Fixed_directions<Triangulation> result;
  const auto add = [&](auto v, double angle) {
    char& passed = is_passed[t.numbers().vertex(v)];
    if (passed == 0) result.push_back({v, std::polar(1., angle)});
    passed = 1;
  };
  const auto back = [&](auto h) { // the direction at the end of a halfedge, away from it
    return angles[t.numbers().halfedge(h) ^ 1U] + std::numbers::pi;
  };
  const bool is_closed =
      !path.empty() && source(path.front(), t.mesh()) == target(path.back(), t.mesh());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double out = angles[t.numbers().halfedge(path[i])];
    double turn = 0;
    if (i > 0 || is_closed)
      turn =
          std::remainder(back(path[i > 0 ? i - 1 : path.size() - 1]) - out, 2 * std::numbers::pi);
    add(source(path[i], t.mesh()), out + turn / 2);
  }
  if (!path.empty()) add(target(path.back(), t.mesh()), back(path.back()));
  return result;
}

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(smoothest_direction_field)
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(aligned_direction_field)
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_DIRECTION_FIELD_H
