// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_DISTANCE_SIGNED_HEAT_DISTANCE_H
#define CGAL_INTRINSIC_OPERATORS_DISTANCE_SIGNED_HEAT_DISTANCE_H

#include <CGAL/Intrinsic_operators/distance/Heat_solver.h>
#include <CGAL/Intrinsic_operators/distance/Pinned_laplacian.h>
#include <CGAL/Intrinsic_operators/distance/distance_sources.h>
#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <complex>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

class Vector_flow;

// The signed heat method on a table of faces, in scaled units.
class Signed_heat_solver {
  using Complex = std::complex<double>;

public:
  Signed_heat_solver(Face_table table, const Eigen::SparseMatrix<double>& laplacian,
                     double time_factor, Heat_progress progress);

  const Face_table& table() const { return table_; }
  double time() const { return table_.unscaled(table_.unscaled(time_)); }

  // whether the caller stopped the last step
  bool is_cancelled() const { return is_cancelled_; }

  // \return by rows, in the units of the input; empty if cancelled
  Eigen::VectorXd distances(const Source_places& curves);

private:
  // The normals on the right of the curves, diffused.
  Heat<Complex> normals(const Source_places& curves, const Pinned_laplacian::Pins& pins) const;

  // of the field of unit vectors that have the directions of the diffused normals in the middle of
  // the faces
  Eigen::VectorXd divergence(const Heat<Complex>& field) const;

  // Zero at vertices of the curves. At the corners of a face that a curve goes through, the
  // distance from its line there, which is linear in the face: it is zero where the curve is.
  Pinned_laplacian::Pins signed_distances_near(const Source_places& curves) const;

  Face_table table_;
  double time_;
  std::vector<std::uint32_t> component_;
  Pinned_laplacian poisson_;
  Pinned_laplacian::Kept kept_;
  std::shared_ptr<const Vector_flow> flow_;
  Heat_progress progress_;
  bool is_cancelled_ = false;
};

} // namespace internal

/*!
\brief approximates signed geodesic distances from curves, by the flow of their normals (Feng and
Crane, A heat method for generalized signed distance, 2024).

The normals of the curve diffuse for a short time as tangent vectors, by the connection Laplacian of
Crouzeix and Raviart. The distance is the function whose gradient fits their directions best, by
least squares:

    (M + time L) X = normals,     Y = X / |X|,     L d = div Y

Curves may be loops or open, and there may be several. Curves with gaps or errors bound no region,
but still have sides; the distance is smooth across the gaps. **Signs**: distances are negative left
of a curve, as inside a counterclockwise loop, and positive right of it. At vertices of the curve
they are exactly zero. In a face that a straight piece of a curve crosses, d is the distance from
its line; where two pieces are as near, from their joint. Pieces along edges belong to the faces on
both sides alike.

\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`, but not of a
cover, which has no sides
*/
template <NumberedTriangulation Triangulation>
  requires MeasuredTriangulation<Triangulation>
class Signed_heat_distance {
public:
  /*!
  \brief assembles the matrices, and factors that of the flow of vectors, with a row per edge.
  \tparam NP a chain of named parameters
  \param t the triangulation; it must outlive this object unchanged
  \param np optional named parameters:
    - `time_factor(x)`: the time is x times the mean of the squares of half the lengths of the
      edges, since the vectors are at their midpoints. Default: 1. More bridges wider gaps.
    - `visitor(v)`: see `Heat_distance_visitor`. If it stops this constructor, there are no
      distances. Later calls use it too: what `std::ref(v)` refers to must outlive this object.
  \throws Invalid_input if a face has no area, or `t` is a cover, where left and right share a row
  \throws std::invalid_argument if the factor is less than 1e-100, or the time more than 1e8 areas
    of the surface: then heat is even up to rounding
  \throws std::runtime_error if rounding makes the matrix indefinite (the message names a row)
  \complexity that of a sparse factorization with three times as many rows as there are vertices
  */
  template <NamedParameters NP = parameters::Parameters<>>
  explicit Signed_heat_distance(const Triangulation& t, const NP& np = parameters::default_values())
      : t_(&t), solver_(internal::face_table(with_sides(t)), cotangent_laplacian(t),
                        internal::value_or<internal::tags::time_factor>(np, 1.0),
                        internal::progress_of(np)) {
    internal::expect_names<internal::tags::time_factor, internal::tags::visitor>(np);
  }

  /*!
  \brief computes the signed distances of all vertices from curves.
  \tparam Curves a halfedge of `t.mesh()`, in the direction of the curve; a `Polyline_source`; or a
    range of these, or a range of ranges
  \param curves the curves
  \return a distance per row of `t.input_vertex()`, in the units of the input; infinity on
    components without a curve and at isolated vertices. An empty vector if the visitor stops the
    computation
  \throws std::invalid_argument if there are vertices or points among the curves, or consecutive
    points of a polyline are not in one face
  \throws std::runtime_error if rounding makes the matrix indefinite
  \complexity that of a solution, and of a factorization of the Laplacian without the rows of the
  curve, unless the curve is that of the last call. Do not call it from two threads at once
  */
  template <class Curves>
  Eigen::VectorXd distances(const Curves& curves) {
    if (is_stopped_) return {};
    return solver_.distances(
        internal::Source_reader<Triangulation>(*t_, solver_.table()).read(curves));
  }

  /// returns `cancelled` if the visitor stopped the last step, else `done`.
  Status status() const { return solver_.is_cancelled() ? Status::cancelled : Status::done; }

  /// returns the time of the flow, in units of area of the input.
  double time() const { return solver_.time(); }

private:
  static const Triangulation& with_sides(const Triangulation& t) {
    if (t.input().names().is_cover())
      throw Invalid_input(Element_kind::none, 0,
                          "signed distances need a left and a right side; this surface is a cover, "
                          "which joins both");
    return t;
  }

  const Triangulation* t_;
  internal::Signed_heat_solver solver_;
  bool is_stopped_ = solver_.is_cancelled(); // during construction
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_DISTANCE_SIGNED_HEAT_DISTANCE_H
