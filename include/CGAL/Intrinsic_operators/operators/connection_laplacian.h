// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_OPERATORS_CONNECTION_LAPLACIAN_H
#define CGAL_INTRINSIC_OPERATORS_OPERATORS_CONNECTION_LAPLACIAN_H

#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_operators/operators/symmetric_assembly.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <type_traits>
#include <vector>

/*!
\file
Parallel transport of tangent vectors along edges, and the Laplacian of fields of them (§2.4
  of the course; Knoeppel, Crane, Pinkall and Schroeder 2013). Vectors are those of a
  `Tangent_field`.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The factor of a vector along an edge, to the power `order`.
template <class Scalar>
Scalar transport_factor(const Connection_edge& e, int order) {
  if constexpr (std::is_same_v<Scalar, double>)
    return 1;
  else
    return std::polar(1., order * std::remainder(e.turn(), 2 * std::numbers::pi));
}

// The areas at vertices, ones at isolated vertices.
inline Eigen::VectorXd positive_masses(const Connection_graph& graph) {
  Eigen::VectorXd masses = Eigen::Map<const Eigen::VectorXd>(
      graph.areas.data(), static_cast<Eigen::Index>(graph.areas.size()));
  return masses.unaryExpr([](double m) { return m > 0 ? m : 1; });
}

// The matrix `factor` L: Hermitian bit by bit, with a diagonal entry in each row.
template <class Scalar>
Eigen::SparseMatrix<Scalar> scaled_laplacian(const Connection_graph& graph, int order,
                                             double factor) {
  constexpr bool is_real = std::is_same_v<Scalar, double>;
  std::vector<std::conditional_t<is_real, Symmetric_entry, Hermitian_entry>> entries;
  entries.reserve(graph.edges.size());
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(graph.size));
  for (const Connection_edge& e : graph.edges) {
    if (e.weight == 0) continue;
    const double w = factor * e.weight;
    const Scalar r = transport_factor<Scalar>(e, order);
    if (e.source == e.target) { // a loop: its energy is |z - r z|^2
      diagonal[e.source] += w * std::norm(Scalar(1) - r);
      continue;
    }
    diagonal[e.source] += w;
    diagonal[e.target] += w;
    entries.push_back({e.target, e.source, -w * r});
  }
  if constexpr (is_real)
    return symmetric_matrix(entries, diagonal);
  else
    return hermitian_matrix(entries, diagonal);
}

} // namespace internal

/*!
\brief computes parallel transport along halfedges (§2.4 of the course).

Let `z` be a vector at the source of halfedge `h`, in polar coordinates. Then `r[h] * z` is the
parallel vector at the target, in the coordinates there: the transport keeps the angle with the
edge. Around a face it turns vectors by the sum of its corner angles as they are scaled, minus pi;
over all faces these angles sum up to 2 pi times the Euler characteristic. Along the border vectors
keep their angle with the border.
\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\param t the triangulation
\return complex numbers of absolute value 1, by `t.numbers().halfedge(h)`; the numbers of opposite
  halfedges are conjugate
\complexity linear
*/
template <ConnectedTriangulation Triangulation>
std::vector<std::complex<double>> transport_along_halfedges(const Triangulation& t) {
  const internal::Halfedge_angles angles(t, internal::Border_angles::half_circle);
  std::vector<std::complex<double>> r(2 * std::size_t{t.numbers().edge_capacity(t.mesh())}, 1);
  for (const auto e : edges(t.mesh())) {
    const std::uint32_t h = 2 * t.index(e);
    const internal::Connection_edge edge{0, 0, 0, 0, angles[h], angles[h + 1]};
    r[h] = internal::transport_factor<std::complex<double>>(edge, 1);
    r[h + 1] = std::conj(r[h]);
  }
  return r;
}

/*!
\brief assembles the connection Laplacian of tangent vectors, or of `order` equivalent directions
per vertex.

    z^H L z = sum over edges of w_ij |z_j - r_ij^order z_i|^2

with the cotangent weight w_ij of the edge and the transport r_ij along it. The matrix is Hermitian
bit by bit and positive semidefinite. It is the weak form and goes with the lumped masses, on covers
those of each copy of a vertex. A loop, an edge from a vertex to itself, turns vectors: it adds w |1
- r^order|^2 to the diagonal. Negative weights count as zero: on a curved surface they could make
the matrix indefinite. In a Delaunay triangulation only border edges have such weights.

Like the cotangent Laplacian, it is the same for all Delaunay triangulations of the surface, up to
the real axes at vertices: edges in which they differ have weight zero.
\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\param t the triangulation
\param order the power of the transport: 1 for vectors, 4 for crosses; 0 gives the cotangent
  Laplacian of functions
\return a compressed matrix without dimension with a row and column per vector of a `Tangent_field`;
  those of isolated vertices have a stored zero on the diagonal
\throws Invalid_input if a face has no area
\complexity linear
*/
template <ConnectedTriangulation Triangulation>
Eigen::SparseMatrix<std::complex<double>> connection_laplacian(const Triangulation& t,
                                                               int order = 1) {
  const internal::Halfedge_angles angles(t, internal::Border_angles::half_circle);
  const internal::Connection_graph graph = internal::connection_graph(t, angles);
  return internal::scaled_laplacian<std::complex<double>>(graph, order, 1);
}

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(connection_laplacian)
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(transport_along_halfedges)
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_OPERATORS_CONNECTION_LAPLACIAN_H
