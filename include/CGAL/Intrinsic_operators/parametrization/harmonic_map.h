// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_HARMONIC_MAP_H
#define CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_HARMONIC_MAP_H

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/parametrization/disk_border.h>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_triangulations/triangulation/MeasuredTriangulation.h>
#include <CGAL/Intrinsic_triangulations/triangulation/NumberedTriangulation.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>

#include <Eigen/Core>

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief maps a disk to the plane by harmonic functions with given values on the border (§4.10, Fig. 30 of the course).

Each vertex inside is the mean of its neighbours, weighted by cotangents. Of a Delaunay triangulation the weights are not negative: if the
border is convex, no vertex inside leaves it, and by Tutte and Floater faces are not turned around. They may be *degenerate*,
where the tessellation, that is the triangulation without the edges of weight zero, is not 3-connected: two vertices
separate a part from the border, or a face has three vertices on one side of a polygon; and by rounding, where parts are mapped to less
than its size. `certify_map()` tells, exactly, and `injective_harmonic_map()` refines the triangulation until there are none.

On `t.mesh()` as it is built, before `flip_to_delaunay()`, the map is defined as well, without that guarantee.

\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\param t the triangulation of a disk
\param border where its border goes, see `circular_border()` and `polygonal_border()`; vertices inside may be fixed as well
\return a point, x and y, per row of `t.input_vertex()`; given positions are there bit by bit; isolated vertices are at (0, 0)
\throws Invalid_input if a face has no area
\throws std::invalid_argument if rows and positions do not fit, or no value is fixed on a component
\throws Indefinite_matrix (a `std::runtime_error`) if rounding has left no definite matrix; it names a row
\complexity that of a sparse factorization
*/
template <MeasuredTriangulation Triangulation>
Eigen::MatrixX2d harmonic_map(const Triangulation& t, const Border_map& border) {
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
                                 values);
}

/// maps a disk to the unit disk by harmonic functions: to the `circular_border()`.
template <MeasuredTriangulation Triangulation>
  requires NumberedTriangulation<Triangulation> Eigen::MatrixX2d
  harmonic_map(const Triangulation& t) {
    return harmonic_map(t, circular_border(t));
  }

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(harmonic_map)
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_HARMONIC_MAP_H
