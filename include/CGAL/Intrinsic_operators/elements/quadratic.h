// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_ELEMENTS_QUADRATIC_H
#define CGAL_INTRINSIC_OPERATORS_ELEMENTS_QUADRATIC_H

#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>

/*!
\file
Quadratic elements (§4.10 of the course: "higher-order basis can likewise be constructed"):
continuous functions that are quadratic polynomials in each intrinsic face, with values at the
vertices and at the midpoints of the edges. Vertex `v` has row `t.input_vertex(v)`, edge `e` the row
`t.number_of_vertices() + t.index(e)`. If a solution is smooth, its error falls with the third power
of the edge length; with linear functions it falls with the second.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// \param factor multiplies the entries
Eigen::SparseMatrix<double> quadratic_laplacian(const Face_table& table, double factor);
Eigen::SparseMatrix<double> quadratic_mass_matrix(const Face_table& table, double factor);

} // namespace internal

/*!
\brief assembles the Laplacian of quadratic elements: x^T L x is the integral of |grad x|^2 for the
function x that is quadratic in each face, exactly. Symmetric bit by bit, positive semidefinite,
with constants in its kernel; the natural border condition is Neumann's.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\return a compressed matrix with a row per vertex, and after them one per number of an edge, without
  dimension; on a cover divided by the number of sheets. Rows of numbers without an edge are zero
\throws Invalid_input if a face has no area
\complexity linear
*/
template <NumberedTriangulation Triangulation>
Eigen::SparseMatrix<double> quadratic_laplacian(const Triangulation& t) {
  return internal::quadratic_laplacian(internal::face_table(t), 1. / t.input().names().sheets);
}

/*!
\brief assembles the Galerkin mass matrix of quadratic elements: x^T M y is the integral of x y,
exactly.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\return a matrix as that of `quadratic_laplacian()`, in units of area of the input
\complexity linear
*/
template <NumberedTriangulation Triangulation>
Eigen::SparseMatrix<double> quadratic_mass_matrix(const Triangulation& t) {
  return internal::quadratic_mass_matrix(internal::face_table(t),
                                         std::ldexp(1.0, -2 * t.metric().scale_exponent()) /
                                             t.input().names().sheets);
}

/*!
\brief evaluates a quadratic function.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\param u a value per row of `quadratic_laplacian(t)`
\param p a point of the intrinsic triangulation, such as `locate_on_intrinsic()` returns
\complexity constant
*/
template <NumberedTriangulation Triangulation>
double quadratic_value(const Triangulation& t, const Eigen::VectorXd& u, const Surface_point& p) {
  double sum = 0;
  auto h = t.numbers().halfedge_at(p.halfedge);
  for (std::size_t k = 0; k < 3; ++k, h = next(h, t.mesh())) {
    const double b = p.weights[k], after = p.weights[(k + 1) % 3];
    const auto side = t.number_of_vertices() + std::size_t{t.index(edge(h, t.mesh()))};
    sum += b * (2 * b - 1) * u[t.input_vertex(source(h, t.mesh()))] +
           4 * b * after * u[static_cast<Eigen::Index>(side)];
  }
  return sum;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_ELEMENTS_QUADRATIC_H
