// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_OPERATORS_HODGE_STARS_H
#define CGAL_INTRINSIC_OPERATORS_OPERATORS_HODGE_STARS_H

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/SparseCore>

#include <vector>

/*!
\file
Exterior derivatives and Hodge stars of discrete differential forms on an intrinsic
  triangulation (Desbrun, Kanso and Tong 2008).

A 0-form has a value per vertex `v`, at `t.input_vertex(v)`; a 1-form a value per number of an edge,
`t.index(e)`, along its first halfedge `halfedge(e, t.mesh())`; a 2-form a value per number of a
face, `t.index(f)`. On a cover, forms have values on the edges and faces of all sheets, and stars
are divided by the number of sheets: d0^T star1 d0 is the cotangent Laplacian of the user's surface.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief assembles the derivative of 0-forms: (d u)_ij = u_j - u_i.
\tparam Triangulation a model of `MeasuredTriangulation`
\param t the triangulation
\return a compressed matrix with a row per edge number and a column per vertex; rows of numbers
without an edge, and of edges from a vertex to itself, are zero
\complexity linear
*/
template <MeasuredTriangulation Triangulation>
Eigen::SparseMatrix<double> exterior_derivative_0(const Triangulation& t) {
  const auto& mesh = t.mesh();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(2 * num_edges(mesh));
  for (const typename Triangulation::edge_descriptor e : edges(mesh)) {
    const auto h = halfedge(e, mesh);
    const auto row = static_cast<int>(t.index(e));
    const auto i = static_cast<int>(t.input_vertex(source(h, mesh)));
    const auto j = static_cast<int>(t.input_vertex(target(h, mesh)));
    if (i == j) continue;
    entries.emplace_back(row, i, -1);
    entries.emplace_back(row, j, 1);
  }
  return internal::matrix_of(t.numbers().edge_capacity(mesh), checked_matrix_size(t), entries);
}

/*!
\brief assembles the derivative of 1-forms: their sum around each face. `exterior_derivative_1(t) *
exterior_derivative_0(t)` is zero.
\tparam Triangulation a model of `MeasuredTriangulation`
\param t the triangulation
\return a compressed matrix with a row per number of a face and a column per number of an edge; a
  face that has an edge on both of its sides has a stored zero there
\complexity linear
*/
template <MeasuredTriangulation Triangulation>
Eigen::SparseMatrix<double> exterior_derivative_1(const Triangulation& t) {
  const auto& mesh = t.mesh();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(3 * num_faces(mesh));
  for (const typename Triangulation::face_descriptor f : faces(mesh)) {
    auto h = halfedge(f, mesh);
    for (int k = 0; k < 3; ++k, h = next(h, mesh)) {
      const auto e = edge(h, mesh);
      entries.emplace_back(static_cast<int>(t.index(f)), static_cast<int>(t.index(e)),
                           halfedge(e, mesh) == h ? 1 : -1);
    }
  }
  return internal::matrix_of(t.numbers().face_capacity(mesh), t.numbers().edge_capacity(mesh),
                             entries);
}

/*!
\brief returns the Hodge star of 0-forms: the mass of each vertex, the diagonal of
`lumped_mass_matrix()`.
\tparam Triangulation a model of `MeasuredTriangulation`
\return a value per vertex, in units of area
\complexity linear
*/
template <MeasuredTriangulation Triangulation>
Eigen::VectorXd hodge_star_0(const Triangulation& t) {
  return internal::areas_at_vertices(t) / 3;
}

/*!
\brief returns the Hodge star of 1-forms: the cotangent weight of each edge, the length of its dual
edge by its own. In a Delaunay triangulation no inner edge has a negative one.
\tparam Triangulation a model of `MeasuredTriangulation`
\return a value per number of an edge, without dimension; zero at numbers without an edge
\throws Invalid_input if a face has no area
\complexity linear
*/
template <MeasuredTriangulation Triangulation>
Eigen::VectorXd hodge_star_1(const Triangulation& t) {
  Eigen::VectorXd star = Eigen::VectorXd::Zero(t.numbers().edge_capacity(t.mesh()));
  internal::for_each_cotangent_weight(
      t, [&](typename Triangulation::edge_descriptor e, double weight) {
        star[t.index(e)] = weight / t.input().names().sheets;
      });
  return star;
}

/*!
\brief returns the Hodge star of 2-forms: one over the area of each face.
\tparam Triangulation a model of `MeasuredTriangulation`
\return a value per number of a face, in units of 1 / area; zero at numbers without a face
\throws Invalid_input if a face has no area
\complexity linear
*/
template <MeasuredTriangulation Triangulation>
Eigen::VectorXd hodge_star_2(const Triangulation& t) {
  Eigen::VectorXd star = Eigen::VectorXd::Zero(t.numbers().face_capacity(t.mesh()));
  for (const typename Triangulation::face_descriptor f : faces(t.mesh())) {
    const double value = 1 / internal::area_per_sheet(t, f);
    if (!std::isfinite(value)) internal::throw_degenerate_face(t, f);
    star[t.index(f)] = value;
  }
  return star;
}

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(hodge_star_1)
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_OPERATORS_HODGE_STARS_H
