// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_DISTANCE_HEAT_DISTANCE_H
#define CGAL_INTRINSIC_OPERATORS_DISTANCE_HEAT_DISTANCE_H

#include <CGAL/Intrinsic_operators/distance/Heat_solver.h>
#include <CGAL/Intrinsic_operators/distance/distance_sources.h>
#include <CGAL/Intrinsic_operators/distance/positions_of_rows.h>
#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {
struct Heat_batch;
} // namespace internal

/*!
\brief observes distances by heat; the default visitor does nothing.
*/
struct Heat_distance_visitor {
  /*!
  \brief is called after each step that takes long, but the last one.
  \param step what was done
  \return whether to go on
  */
  bool progress([[maybe_unused]] Heat_step step) { return true; }
};

/*!
\brief approximates geodesic distances from vertices, points and curves by the flow of heat (§4.10.2
of the course; Crane, Weischedel, Wardetzky, Geodesics in heat, 2013).

Heat flows for a short time; its gradient gives the directions of shortest paths. The distance is
the function whose gradient fits these directions best, by least squares:

    (M + time L) u = sources,     X = -grad u / |grad u|,     L d = div X

Each matrix is factored once, at construction or when it is first needed. Distances from other
sources then take the time of two solutions. Errors are in the order of the length of edges, and
large where edges are not Delaunay: call `flip_to_delaunay()` before, and for more accuracy
`delaunay_refine()`. If no weight is negative, heat is computed without any subtraction, to full
relative accuracy, where it is above 2^-800 of the greatest. Smaller heat, as far as 10^-1000 and
less, is computed from its values at that limit, with differences once for each 2^-800.

**What is certain.** Sources have distance zero. Corners of a face that contains a source have their
distance within the face. No distance is negative. No distance is less than the *chord*, the
distance in space, if the vertex and the sources have places there: if they are vertices of the
user's mesh, or inserted with exact arithmetic or integer coordinates. (From a source inside an edge
or a face, the bound is less by as much as the nearest corner of the face is away.) Values are
finite where a path leads to a source; on other components and at isolated vertices they are
infinite.

Every source has distance zero, also if there are many. Lagrange multipliers fix up to twenty, with
the same factorization. For more, the matrix is factored without their rows, once until sources
change.

\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`, with any mesh,
  arithmetic and correspondence; on a cover, copies of a vertex share a row
*/
template <NumberedTriangulation Triangulation>
  requires MeasuredTriangulation<Triangulation>
class Heat_distance {
public:
  /*!
  \brief assembles the matrices and factors that of the heat flow.
  \tparam NP a chain of named parameters
  \param t the triangulation; it must outlive this object unchanged
  \param np optional named parameters:
    - `time_factor(x)`: the time is x times the square of the mean length of the edges. Default: 1.
      More is smoother.
    - `border_condition(c)`: how heat behaves at the border. `Heat_border::average` takes the mean
      of both conditions, as the authors recommend, and costs one more factorization;
      `Heat_border::insulated` has no flux. Default: `average`. Without border they are the same.
    - `visitor(v)`: see `Heat_distance_visitor`. If it stops this constructor, there are no
      distances. Later calls use it too: what `std::ref(v)` refers to must outlive this object.
  \throws Invalid_input if a face has no area
  \throws std::invalid_argument if the factor is less than 1e-100, or the time more than 1e8 areas
    of the surface: then heat is even up to rounding
  \throws std::runtime_error if rounding makes the matrix indefinite (the message names a row)
  \complexity that of a sparse factorization: about n^1.5 for n vertices
  */
  template <NamedParameters NP = parameters::Parameters<>>
  explicit Heat_distance(const Triangulation& t, const NP& np = parameters::default_values())
      : t_(&t), positions_(internal::positions_of_rows(t)),
        solver_(cotangent_laplacian(t), internal::face_table(t), options(np),
                t.input().names().sheets, progress(np)) {}
  /// A triangulation that would end before this object is refused: give it a name.
  template <NamedParameters NP = parameters::Parameters<>>
  explicit Heat_distance(const Triangulation&&, const NP& = parameters::default_values()) = delete;

  /*!
  \brief computes the distances of all vertices from sources.
  \tparam Sources one of these, or a range of them, or a range of ranges: vertices and halfedges of
    `t.mesh()` (edges are curves); points of the triangulation as `Surface_point` or
    `Face_location<Mesh>`; `Polyline_source`
  \param sources the sources; `vertex_on_intrinsic()` and `locate_on_intrinsic()` find those of the
  user's mesh
  \return a distance per row of `t.input_vertex()`, in the units of the input; infinity where no
  path leads to a source. An empty vector if the visitor stops the computation
  \throws std::invalid_argument if a point is beyond the border, or consecutive points of a polyline
    are not in one face
  \throws std::runtime_error if rounding makes the matrix indefinite
  \complexity about n log n: solutions with a factored matrix; with more than twenty sources also a
  factorization, unless they are those of the last call. Do not call it from two threads at once
  */
  template <class Sources>
  Eigen::VectorXd distances(const Sources& sources) {
    if (is_stopped_) return {};
    const internal::Source_places places =
        internal::Source_reader<Triangulation>(*t_, solver_.table()).read(sources);
    return solver_.distances(places, positions_);
  }

  /// returns `cancelled` if the visitor stopped the last step, else `done`.
  Status status() const { return solver_.is_cancelled() ? Status::cancelled : Status::done; }

  /// returns the time of the heat flow, in units of area of the input.
  double time() const { return solver_.time(); }

private:
  friend struct internal::Heat_batch;

  template <class NP>
  static internal::Heat_options options(const NP& np) {
    using namespace internal::tags;
    internal::expect_names<time_factor, border_condition, visitor>(np);
    internal::Heat_options o;
    o.time_factor = internal::value_or<time_factor>(np, o.time_factor);
    o.border = internal::value_or<border_condition>(np, o.border);
    return o;
  }

  template <class NP>
  static internal::Heat_progress progress(const NP& np) {
    return [v = internal::object_or<internal::tags::visitor>(np, Heat_distance_visitor())](
               Heat_step step) mutable { return internal::unwrapped(v).progress(step); };
  }

  const Triangulation* t_;
  std::vector<std::array<double, 3>> positions_;
  internal::Heat_solver solver_;
  bool is_stopped_ = solver_.is_cancelled(); // during construction
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_DISTANCE_HEAT_DISTANCE_H
