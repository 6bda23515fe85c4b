// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_OPERATORS_FACE_GRADIENT_H
#define CGAL_INTRINSIC_OPERATORS_OPERATORS_FACE_GRADIENT_H

#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief takes piecewise linear functions to their gradients, and fields of vectors that are constant
on faces to their divergence and curl (§2.5 of the course), from lengths alone.

A vector is a complex number in the frame of its face, whose real axis runs along the first halfedge
of the face, `halfedge(f, t.mesh())`, as for `Face_vector_transfer`. Fields have a vector per number
of a face, `t.index(f)`, functions a value per vertex `v`, at `t.input_vertex(v)`, like all
operators. With the hat function phi_i of vertex i,

    grad u = sum_i u_i grad phi_i
    (div X)_i = - sum over the faces at i of A <grad phi_i, X>
    (curl X)_i = (div -iX)_i

Divergence and curl are integrated: those of the smooth field times the mass of a vertex. So
`divergence(gradient(u))` is `-L u`, with L the cotangent Laplacian, and `curl(gradient(u))` is zero
at inner vertices, up to rounding. At the border both include the flux through it. On a cover they
are the mean over the sheets.
*/
class Face_gradient {
public:
  using Vector = std::complex<double>; ///< in the frame of a face
  using Vectors = Eigen::VectorXcd;    ///< a vector per number of a face
  using Function = Eigen::VectorXd;    ///< a value per vertex

  /*!
  \brief measures the faces of a triangulation; no reference to it is kept.
  \tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
  \throws Invalid_input if a face has no area
  \complexity linear
  */
  template <class Triangulation>
    requires MeasuredTriangulation<Triangulation> && NumberedTriangulation<Triangulation>
  explicit Face_gradient(const Triangulation& t)
      : vertices_(checked_matrix_size(t)), sheets_(t.input().names().sheets),
        faces_(t.numbers().face_capacity(t.mesh())) {
    const internal::Face_table table = internal::face_table(t);
    for (const typename Triangulation::face_descriptor f : faces(t.mesh()))
      if (!measure(table, t.index(f))) internal::throw_degenerate_face(t, f);
  }

  /// returns the number of vertices.
  Eigen::Index number_of_vertices() const { return vertices_; }
  /// returns the number of face numbers. A number without a face has gradient zero.
  Eigen::Index number_of_faces() const { return static_cast<Eigen::Index>(faces_.size()); }
  /// returns the area of face number `f`, zero if there is none; on a cover, the area of each copy.
  double area(std::size_t f) const { return faces_[f].area; }

  /// returns the gradient of a function. \complexity linear
  /// \throws std::invalid_argument if the function does not have a value per vertex
  Vectors gradient(const Function& u) const;

  /// returns the integrated divergence of a field. \complexity linear
  /// \throws std::invalid_argument if the field does not have a vector per face number
  Function divergence(const Vectors& x) const;

  /// returns the integrated curl of a field. \complexity linear
  /// \throws std::invalid_argument if the field does not have a vector per face number
  Function curl(const Vectors& x) const;

  /// returns the gradient as a matrix with a row per number of a face and a column per vertex.
  /// \complexity linear
  Eigen::SparseMatrix<Vector> matrix() const;

private:
  struct Face {
    std::array<Vector, 3> hat_gradient = {0, 0, 0}; // of the hat functions of its corners
    std::array<int, 3> row = {0, 0, 0};             // of its corners
    double area = 0;
  };

  // The gradient of a hat function is the opposite side, turned inwards by a right angle, divided
  // by twice the area.
  // \return whether it is finite
  bool measure(const internal::Face_table& table, std::uint32_t f);

  Eigen::Index vertices_;
  double sheets_;
  std::vector<Face> faces_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_OPERATORS_FACE_GRADIENT_H
