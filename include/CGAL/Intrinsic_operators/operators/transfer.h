// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_OPERATORS_TRANSFER_H
#define CGAL_INTRINSIC_OPERATORS_OPERATORS_TRANSFER_H

#include <CGAL/Intrinsic_operators/operators/subdivision_matrices.h>
#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <complex>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

/*!
\file
Transfer of piecewise linear functions between an intrinsic triangulation and its input
  (§4.11.1 of the course). Functions are given by their values at vertices, numbered as in all
  operators: vertices of the input as there, then the inserted ones; one function per column.
*/

namespace CGAL::Intrinsic_triangulations {

/// The target of a transfer.
enum class Transfer_direction {
  to_input,    ///< from the intrinsic triangulation to the input
  to_intrinsic ///< from the input to the intrinsic triangulation
};

/*!
\brief copies values at vertices from the intrinsic triangulation to the input.

It needs no correspondence, since both triangulations have the vertices of the input with equal
numbers.
\param t the triangulation
\param f values at the vertices of the intrinsic triangulation, a function per column
*/
template <NumberedTriangulation Triangulation, class Derived>
  requires std::derived_from<Derived, Eigen::MatrixBase<Derived>>
typename Derived::PlainObject copy_to_input(const Triangulation& t,
                                            const Eigen::MatrixBase<Derived>& f) {
  return f.topRows(t.input().number_of_rows());
}

/*!
\brief copies values at vertices from the input to the intrinsic triangulation; inserted vertices
get the value of the function there.
\param t the triangulation, with a correspondence if vertices were inserted
\param g values at the vertices of the input, a function per column
\return values at the vertices
\complexity linear
*/
template <QueriedTriangulation Triangulation, class Derived>
  requires std::derived_from<Derived, Eigen::MatrixBase<Derived>>
typename Derived::PlainObject copy_to_intrinsic(const Triangulation& t,
                                                const Eigen::MatrixBase<Derived>& g) {
  typename Derived::PlainObject f = Derived::PlainObject::Zero(t.number_of_vertices(), g.cols());
  for (const typename Triangulation::vertex_descriptor v : vertices(t.mesh())) {
    const std::uint32_t row = t.input_vertex(v);
    if (!t.is_inserted(v)) {
      f.row(row) = g.row(row);
      continue;
    }
    const Weighted_vertices w = weighted_vertices(t, t.correspondence().location(t.index(v)));
    f.row(row).setZero(); // a copy of the vertex may have values here
    for (std::size_t i = 0; i < w.size; ++i) f.row(row) += w.weights[i] * g.row(w.vertices[i]);
  }
  return f;
}

/*!
\brief takes functions to the nearest ones on the other triangulation, in the L2 norm (§4.11.1 of
the course, Eqs. 16 to 18).

The nearest function g to f minimises (P f - Q g)^T M_S (P f - Q g), with P and Q the interpolation
matrices from here and from there, and M_S the mass matrix of the common subdivision:

    (Q^T M_S Q) g = Q^T M_S P f

The error is orthogonal to all functions there; so integrals are preserved, functions that are
linear on both triangulations are reproduced, and copying is never better in this norm. The matrix
is factored once for any number of functions. It is a mass matrix: scaled to a unit diagonal, it has
eigenvalues between 1/2 and 2 for all triangles (Wathen 1987), so the solution is accurate on every
mesh. Vertices without area keep their values.
*/
class L2_transfer {
public:
  /*!
  \brief assembles and factors the system.
  \tparam Triangulation a model of `NumberedTriangulation`
  \param t the triangulation
  \param s its common subdivision with the input
  \param direction the target of the functions
  \throws Invalid_input if the subdivision is too large for the index type of Eigen
  \throws Indefinite_matrix if rounding makes the matrix indefinite
  \complexity that of a sparse factorization
  */
  template <NumberedTriangulation Triangulation>
  L2_transfer(const Triangulation& t, const Common_subdivision& s,
              Transfer_direction direction = Transfer_direction::to_input) {
    const Interpolation_matrix input = interpolation_from_input(s);
    const Interpolation_matrix intrinsic = interpolation_from_intrinsic(s);
    const bool back = direction == Transfer_direction::to_input;
    const Interpolation_matrix& from = back ? intrinsic : input;
    const Interpolation_matrix& to = back ? input : intrinsic;
    const Matrix weighted = Matrix(to.transpose()) * subdivision_mass_matrix(t, s);
    mass_ = weighted * Matrix(to);
    cross_ = weighted * Matrix(from);
    keep_values_without_area(s, back);
    factor();
  }

  /*!
  \brief takes functions to the other triangulation.
  \param f values at vertices, a function per column
  \return values at the vertices there
  */
  template <class Derived>
  typename Derived::PlainObject operator()(const Eigen::MatrixBase<Derived>& f) const {
    const double largest = f.size() > 0 ? f.cwiseAbs().maxCoeff() : 0;
    if (!(largest > 0x1p-1020)) return solver_->solve(cross_ * f);
    // products of small values and small areas would vanish; a power of two is exact
    const double scale = std::ldexp(1., -std::ilogb(largest));
    const typename Derived::PlainObject right = cross_ * (f * scale);
    return solver_->solve(right) / scale;
  }

  /// returns Q^T M_S Q, the mass matrix of the target triangulation, with ones for vertices without
  /// area.
  const Eigen::SparseMatrix<double>& mass_matrix() const { return mass_; }

private:
  using Matrix = Eigen::SparseMatrix<double>;

  // makes rows without area copy values
  void keep_values_without_area(const Common_subdivision& s, bool back);
  void factor();

  Matrix mass_;
  Matrix cross_; // Q^T M_S P: integrals of products of functions there and here
  std::optional<Laplacian_factorization> solver_;
};

/*!
\brief computes the distance of functions on both triangulations in the L2 norm (§4.11.1, Eq. 18).
\param t the triangulation
\param s its common subdivision with the input
\param f values at the vertices of the intrinsic triangulation
\param g values at the vertices of the input
\complexity linear
*/
template <NumberedTriangulation Triangulation>
double L2_distance(const Triangulation& t, const Common_subdivision& s, const Eigen::VectorXd& f,
                   const Eigen::VectorXd& g) {
  Eigen::VectorXd d = interpolation_from_intrinsic(s) * f - interpolation_from_input(s) * g;
  const double largest = d.size() > 0 ? d.lpNorm<Eigen::Infinity>() : 0;
  if (!(largest > 0)) return largest;
  d /= largest;   // squares of small ones would vanish
  double sum = 0; // of squares: no cancellation
  for_each_subdivision_triangle(
      t, s, [&](std::size_t, const std::array<std::uint32_t, 3>& v, double area) {
        for (std::size_t k = 0; k < 3; ++k) { // exact for quadratic polynomials
          const double middle = (d[v[k]] + d[v[(k + 1) % 3]]) / 2;
          sum += area / 3 * middle * middle;
        }
      });
  return largest * std::sqrt(sum / t.input().names().sheets);
}

/*!
\brief takes tangent vector fields that are constant on faces between an intrinsic triangulation and
its input, to the nearest ones in the L2 norm (§4.11.2 of the course).

A vector is a complex number in the frame of its face, whose real axis runs along the first halfedge
of the face, `halfedge_of_face()`. Faces have the numbers of the subdivision. A face of the
subdivision lies in one face of each; its corners in both frames give the rotation r between them,
and the nearest field is the average

    v_g = sum over cells c in g of |c| r_c v_f(c) / |g|

No vector passes through a vertex, so rotations are well-defined also on a curved surface.
*/
class Face_vector_transfer {
public:
  /*!
  \brief finds the rotations.
  \tparam Triangulation a model of `NumberedTriangulation`
  \param t the triangulation
  \param s its common subdivision with the input
  \complexity linear
  */
  template <NumberedTriangulation Triangulation>
  Face_vector_transfer(const Triangulation& t, const Common_subdivision& s)
      : input_face_(s.input_face), intrinsic_face_(s.intrinsic_face),
        area_(subdivision_areas(t, s)) {
    const Input& input = t.input();
    const Intrinsic_view<Triangulation> view(t);
    const Element_names& names = t.input().names().faces;
    for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
      const std::uint32_t base = view.halfedge_of_face(intrinsic_face_[f]),
                          there = input.halfedge_of_face(names.here(input_face_[f]));
      const Geodesic_face from(view, base), to(input, there);
      rotation_.push_back(
          internal::fitting_rotation(s.face_begin[f], s.face_begin[f + 1], [&](std::size_t c) {
            const auto p = from.position(internal::corner_in_face(view, s, base, c)),
                       q = to.position(internal::corner_in_input_face(input, s, there, c));
            return std::array{Complex(p[0], p[1]), Complex(q[0], q[1])};
          }));
    }
    input_faces_ = input.mesh().number_of_faces();
    intrinsic_faces_ = bound(intrinsic_face_);
  }

  /// takes a field from the faces of the intrinsic triangulation to those of the input.
  /// \complexity linear
  std::vector<std::complex<double>> to_input(const std::vector<std::complex<double>>& field) const {
    return average(field, intrinsic_face_, input_face_, input_faces_, false);
  }
  /// takes a field from the faces of the input to those of the intrinsic triangulation.
  /// \complexity linear
  std::vector<std::complex<double>>
  to_intrinsic(const std::vector<std::complex<double>>& field) const {
    return average(field, input_face_, intrinsic_face_, intrinsic_faces_, true);
  }

  /// returns the rotation that takes vectors from the intrinsic face of subdivision face `f` to its
  /// face of the input.
  std::complex<double> rotation(std::size_t f) const { return rotation_[f]; }

private:
  using Complex = std::complex<double>;

  static std::size_t bound(const std::vector<std::uint32_t>& numbers) {
    return numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end()) + std::size_t{1};
  }

  std::vector<Complex> average(const std::vector<Complex>& field,
                               const std::vector<std::uint32_t>& from,
                               const std::vector<std::uint32_t>& to, std::size_t size,
                               bool back) const {
    std::vector<Complex> result(size, 0), copy(size, 0);
    std::vector<double> area(size, 0);
    for (std::size_t f = 0; f < from.size(); ++f) {
      const Complex v = (back ? std::conj(rotation_[f]) : rotation_[f]) * field[from[f]];
      result[to[f]] += area_[f] * v;
      copy[to[f]] = v;
      area[to[f]] += area_[f];
    }
    for (std::size_t g = 0; g < size; ++g) result[g] = area[g] > 0 ? result[g] / area[g] : copy[g];
    return result;
  }

  std::vector<std::uint32_t> input_face_;
  std::vector<std::uint32_t> intrinsic_face_;
  std::vector<double> area_;
  std::vector<Complex> rotation_;
  std::size_t input_faces_ = 0, intrinsic_faces_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_OPERATORS_TRANSFER_H
