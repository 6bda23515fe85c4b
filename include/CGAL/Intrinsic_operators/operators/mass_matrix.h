// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_OPERATORS_MASS_MATRIX_H
#define CGAL_INTRINSIC_OPERATORS_OPERATORS_MASS_MATRIX_H

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/symmetric_assembly.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <boost/graph/graph_traits.hpp>

#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The area of a face divided by the number of sheets: so all sheets together have the area of the
// user's surface.
template <class Triangulation>
double area_per_sheet(const Triangulation& t, typename Triangulation::face_descriptor f) {
  return t.area(f) / t.input().names().sheets;
}

// the sum of the areas of the faces at each vertex; a face counts once per corner
template <class Triangulation>
Eigen::VectorXd areas_at_vertices(const Triangulation& t) {
  const auto& mesh = t.mesh();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(checked_matrix_size(t));
  for (const typename Triangulation::face_descriptor f : faces(mesh)) {
    const double area = area_per_sheet(t, f);
    typename Triangulation::halfedge_descriptor h = halfedge(f, mesh);
    for (int corner = 0; corner < 3; ++corner, h = next(h, mesh))
      sum[t.input_vertex(target(h, mesh))] += area;
  }
  return sum;
}

} // namespace internal

/*!
\brief assembles the mass matrix of the Voronoi dual (§4.1 of the course; Meyer, Desbrun, Schroeder
and Barr 2003): on the diagonal the area of the circumcentric cell of each vertex

    M_ii = 1/4 sum over edges ij of w_ij |ij|^2,    w_ij the cotangent weight,

as the dual of an edge has length w_ij |ij|. In a Delaunay triangulation these are the areas of the
cells of the intrinsic Voronoi diagram: nonnegative except at a border edge that faces an obtuse
angle. In other triangulations, areas at obtuse angles can be negative. The trace is the area of the
surface, up to rounding.
\tparam Triangulation a model of `MeasuredTriangulation`
\param t the triangulation, whose predicates may sharpen stored values
\return a compressed diagonal matrix as that of `lumped_mass_matrix()`
\throws Invalid_input if a face has no area
\complexity linear
*/
template <MeasuredTriangulation Triangulation>
Eigen::SparseMatrix<double> voronoi_mass_matrix(const Triangulation& t) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(checked_matrix_size(t));
  internal::for_each_cotangent_weight(
      t, [&](typename Triangulation::edge_descriptor e, double weight) {
        const double half_of_diamond = weight * t.squared_length(e) / t.input().names().sheets / 4;
        const auto h = halfedge(e, t.mesh());
        sum[t.input_vertex(source(h, t.mesh()))] += half_of_diamond;
        sum[t.input_vertex(target(h, t.mesh()))] += half_of_diamond;
      });
  return symmetric_matrix({}, sum);
}

/*!
\brief assembles the lumped mass matrix (§2.5.1 of the course, Eq. 5): a third of the area of the
faces at each vertex, on the diagonal.

A face that has a vertex at several corners counts at each. The trace is the area of the surface; on
a cover, of the user's surface, whose vertices number the rows. The faces of a point cloud are not
the user's, and where four points are on a circle, rounding decides between two pairs of faces: its
masses are those of `voronoi_mass_matrix()`, which are the same for both, nonnegative and as
accurate.

\tparam Triangulation a model of `MeasuredTriangulation`
\param t the triangulation
\return a compressed diagonal matrix with a row and column per vertex, in the numbering of the
  input, in units of area of the input; sparse, so that it adds to a Laplacian; every diagonal entry
  is stored
\complexity linear
*/
template <MeasuredTriangulation Triangulation>
Eigen::SparseMatrix<double> lumped_mass_matrix(const Triangulation& t) {
  if (t.input().names().is_cloud()) return voronoi_mass_matrix(t);
  return symmetric_matrix({}, internal::areas_at_vertices(t) / 3);
}

/*!
\brief assembles the Galerkin mass matrix (§2.5.1 of the course, Eq. 6):

    M_ii = 1/6 of the area of the faces at i,    M_ij = 1/12 of the area of the faces at ij

so that u^T M v is the integral of u v, exactly, for piecewise linear functions u and v. A face that
has a vertex at several corners counts with every pair of its corners: an edge from vertex i to
itself adds twice 1/12 of the area of its faces to M_ii. The sum of all entries is the area of the
surface. Positive definite if no vertex is isolated and every face has an area.

\tparam Triangulation a model of `MeasuredTriangulation`
\param t the triangulation
\return a compressed matrix with a row and column per vertex, in the numbering of the input, in
  units of area of the input, symmetric bit by bit; every diagonal entry is stored
\complexity linear
*/
template <MeasuredTriangulation Triangulation>
Eigen::SparseMatrix<double> galerkin_mass_matrix(const Triangulation& t) {
  const auto& mesh = t.mesh();
  const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
  Eigen::VectorXd diagonal = internal::areas_at_vertices(t) / 6;
  std::vector<Symmetric_entry> entries;
  entries.reserve(num_edges(mesh));
  for (const typename Triangulation::edge_descriptor e : edges(mesh)) {
    const typename Triangulation::halfedge_descriptor h = halfedge(e, mesh), o = opposite(h, mesh);
    double area = 0;
    for (const auto f : {face(h, mesh), face(o, mesh)})
      if (f != null) area += internal::area_per_sheet(t, f);
    const auto i = static_cast<int>(t.input_vertex(source(h, mesh)));
    const auto j = static_cast<int>(t.input_vertex(target(h, mesh)));
    if (i == j)
      diagonal[i] += area / 6;
    else
      entries.push_back({i, j, area / 12});
  }
  return symmetric_matrix(entries, diagonal);
}

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(lumped_mass_matrix)
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(voronoi_mass_matrix)
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(galerkin_mass_matrix)
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_OPERATORS_MASS_MATRIX_H
