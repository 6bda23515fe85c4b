// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_ELEMENTS_CROUZEIX_RAVIART_H
#define CGAL_INTRINSIC_OPERATORS_ELEMENTS_CROUZEIX_RAVIART_H

#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_operators/operators/symmetric_assembly.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <complex>
#include <cstdint>

/*!
\file
The elements of Crouzeix and Raviart: functions and tangent vector fields with values at the
  midpoints of edges, linear in each face. A vector at an edge is a complex number in the frame of
  the edge, whose real axis runs along `halfedge(e, t.mesh())` and whose imaginary axis points to
  its left. An edge lies in the planes of both its faces, so vectors pass to them without any
  choice, also at the border and at edges that are loops.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Half the cotangents at the corners opposite the sides of a face, times a factor: finite, also
// where entries of a matrix sum them.
std::array<double, 3> checked_half_cotangents(const Table_face& f, double factor = 1);

// The directions of the frames of the sides of a face, in the frame of side 0: unit complex
// numbers. An edge is directed along its halfedge with an even number.
std::array<std::complex<double>, 3> side_frames(const Table_face& f);

// Removals leave numbers without an edge: these rows are zero.
Eigen::SparseMatrix<std::complex<double>> edge_connection_laplacian(const Face_table& table,
                                                                    double factor = 1);

// a third of the areas of the faces at each edge
Eigen::VectorXd edge_areas(const Face_table& table);

} // namespace internal

/*!
\brief assembles the connection Laplacian of Crouzeix and Raviart (Stein, Jacobson, Wardetzky,
Grinspun, A smoothness energy without boundary distortion for curved surfaces, 2020; Feng and Crane
2024): for edges a and b of a face, which meet at an angle theta,

    L_ab = -2 cot(theta) r_ab,    L_aa = sum over faces at a of 2 (cot + cot) at its ends

where r_ab turns vectors from the frame of b to that of a, see the head of the file. x^H L x is the
sum over faces of the integral of |grad x|^2 for the vector field that is linear in each face, with
these vectors at the midpoints of its sides.

The matrix is Hermitian and positive semidefinite; its kernel contains the fields that are parallel
across all edges: constant vectors on a flat surface.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\return a compressed matrix with a row and column per number of an edge, `t.index(e)`, without
dimension; zero for removed edges
\throws Invalid_input if a face has no area, or there are too many edges for the index type of Eigen
\complexity linear
*/
template <NumberedTriangulation Triangulation>
Eigen::SparseMatrix<std::complex<double>> edge_connection_laplacian(const Triangulation& t) {
  internal::expect_countable(10 * std::uint64_t{t.numbers().edge_capacity(t.mesh())},
                             "the matrix has many entries");
  return internal::edge_connection_laplacian(internal::face_table(t));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_ELEMENTS_CROUZEIX_RAVIART_H
