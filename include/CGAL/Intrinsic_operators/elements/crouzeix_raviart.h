// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_ELEMENTS_CROUZEIX_RAVIART_H
#define CGAL_INTRINSIC_OPERATORS_ELEMENTS_CROUZEIX_RAVIART_H

#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_operators/operators/symmetric_assembly.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

/*!
\file
The elements of Crouzeix and Raviart: functions and tangent vector fields with values at the midpoints of edges, linear in each face. A
vector at an edge is a complex number in the frame of the edge, whose real axis runs along `halfedge(e, t.mesh())` and whose imaginary axis
points to its left. An edge lies in the planes of both its faces, so that vectors come into them without any choice, also at the border and in
Delta-complexes of which edges are loops.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Half the cotangents at the corners opposite the sides of a face, finite.
inline std::array<double, 3> checked_half_cotangents(const Table_face& f) {
  std::array<double, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = f.half_cotangent(k);
    if (!std::isfinite(result[k]))
      throw Invalid_input(
          Element_kind::none, 0,
          "a face has no area, or one too small for its cotangents; make the triangulation "
          "Delaunay, or build it with mollification");
  }
  return result;
}

// The directions of the frames of the sides of a face, in the frame of side 0: unit complex numbers. An edge is directed along
// its halfedge with an even number.
inline std::array<std::complex<double>, 3> side_frames(const Table_face& f) {
  const auto corners = f.layout();
  std::array<std::complex<double>, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::complex<double> side = corners[(k + 1) % 3] - corners[k];
    result[k] = (f.halfedges[k] % 2 == 0 ? side : -side) / std::abs(side);
  }
  return result;
}

// Edges without a face, which removals leave as gaps in the numbers, are zero.
inline Eigen::SparseMatrix<std::complex<double>>
edge_connection_laplacian(const Face_table& table) {
  using Complex = std::complex<double>;
  std::vector<Eigen::Triplet<Complex>> entries;
  entries.reserve(9 * table.faces.size());
  for (const Table_face& f : table.faces) {
    const auto weights = checked_half_cotangents(f);
    const auto frames = side_frames(f);
    for (std::size_t k = 0; k < 3; ++k) {
      // the cotangents at the ends of a side sum to this, which is positive whatever rounding makes of them
      const auto side = static_cast<int>(f.halfedges[k] / 2);
      entries.emplace_back(side, side, f.squared_lengths[k] / f.area());
      // two sides meet at the corner opposite the third
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      const auto i = static_cast<int>(f.halfedges[a] / 2), j = static_cast<int>(f.halfedges[b] / 2);
      const double w = 4 * weights[k];
      const Complex turn = std::conj(frames[a]) * frames[b]; // from frame b to frame a
      entries.emplace_back(i, j, -w * turn);
      entries.emplace_back(j, i, -w * std::conj(turn));
    }
  }
  const auto size = static_cast<Eigen::Index>(table.number_of_edges);
  return matrix_of(size, size, entries);
}

// a third of the areas of the faces at each edge
inline Eigen::VectorXd edge_areas(const Face_table& table) {
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(table.number_of_edges));
  for (const Table_face& f : table.faces)
    for (const std::uint32_t h : f.halfedges) areas[h / 2] += f.area() / 3;
  return areas;
}

} // namespace internal

/*!
\brief assembles the connection Laplacian of Crouzeix and Raviart (Stein, Jacobson, Wardetzky, Grinspun, A smoothness
energy without boundary distortion for curved surfaces, 2020; Feng and Crane 2024): for edges a and b of a face, which meet at an angle theta,

    L_ab = -2 cot(theta) r_ab,    L_aa = sum over faces at a of 2 (cot + cot) at its ends

where r_ab turns vectors from the frame of b to that of a, see the head of the file. x^H L x is the sum over faces of the integral of |grad x|^2 for
the vector field that is linear in each face, with these vectors at the midpoints of its sides.

The matrix is Hermitian and positive semidefinite; in its kernel are the fields that are parallel across all edges: on a
flat surface those of constant vectors.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\return a compressed matrix with a row and column per number of an edge, `t.index(e)`, without dimension; those of removed edges are zero
\throws Invalid_input if a face has no area, or there are too many edges for the index type of Eigen
\complexity linear
*/
template <NumberedTriangulation Triangulation>
Eigen::SparseMatrix<std::complex<double>> edge_connection_laplacian(const Triangulation& t) {
  internal::expect_countable(10 * std::uint64_t{t.numbers().edge_capacity(t.mesh())},
                             "the matrix has many entries");
  return internal::edge_connection_laplacian(internal::face_table(t));
}

/*!
\brief computes the mass matrix of Crouzeix and Raviart: a third of the areas of the faces at each edge. It is diagonal without
lumping: hat functions of edges are orthogonal.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\return the diagonal, by numbers of edges, in units of area of the input
\complexity linear
*/
template <NumberedTriangulation Triangulation>
Eigen::VectorXd edge_mass(const Triangulation& t) {
  const internal::Face_table table = internal::face_table(t);
  return internal::edge_areas(table) * std::ldexp(1.0, -2 * table.scale_exponent);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_ELEMENTS_CROUZEIX_RAVIART_H
