// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_CONFORMAL_MAP_H
#define CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_CONFORMAL_MAP_H

#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/parametrization/disk_border.h>
#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numeric>
#include <vector>

#if CGAL_INTRINSIC_TRIANGULATIONS_DEFINES(FUNCTIONS)
#include <Eigen/Dense>
#endif

/*!
\file
Maps to the plane with a free border that are as conformal as may be: they minimise the conformal energy

    E = 1/2 integral of |grad w|^2 - area of the image = w^H C w,    w = x + i y

which is not negative, and zero if all angles are kept. C is Hermitian: half the cotangent Laplacian, less the area as a form on the
border.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// C, with rows as the Laplacian
Eigen::SparseMatrix<std::complex<double>>
conformal_energy(const Eigen::SparseMatrix<double>& laplacian, const Disk_border& border);

Eigen::MatrixX2d least_squares_conformal_map(const Face_table& table,
                                             const Eigen::SparseMatrix<double>& laplacian,
                                             const Disk_border& border);
Eigen::MatrixX2d spectral_conformal_map(const Face_table& table,
                                        const Eigen::SparseMatrix<double>& laplacian,
                                        const Disk_border& border);

} // namespace internal

/*!
\brief assembles the matrix of the conformal energy of a disk, see the head of the file.
\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\param t the triangulation
\return a Hermitian, positive semidefinite matrix with a row and column per row of `t.input_vertex()`, without dimension
\throws Invalid_input if a face has no area, or the surface is not a disk, see `circular_border()`
\complexity linear
*/
template <MeasuredTriangulation Triangulation>
  requires NumberedTriangulation<Triangulation> Eigen::SparseMatrix<std::complex<double>>
  conformal_energy(const Triangulation& t) {
    return internal::conformal_energy(cotangent_laplacian(t), internal::disk_border(t));
  }

/*!
\brief maps a disk to the plane with least conformal energy, two vertices fixed (Lévy, Petitjean, Ray, Maillot, Least squares conformal maps,
2002).

The two are the vertex of the border with the least row, and the one that halves the length of the border with it. The result is scaled to
the area of the surface, and the first vertex is at the origin. It depends on the two vertices, if no conformal map exists;
`spectral_conformal_map()` does not. Faces may be turned around, and parts may overlap: `certify_map()` tells, exactly.

\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\param t the triangulation of a disk
\return a point, x and y in the units of the input, per row of `t.input_vertex()`; isolated vertices are at (0, 0)
\throws Invalid_input if a face has no area, or the surface is not a disk, see `circular_border()`
\throws Indefinite_matrix if rounding has left no definite matrix
\complexity that of a sparse factorization of complex numbers
*/
template <MeasuredTriangulation Triangulation>
  requires NumberedTriangulation<Triangulation> Eigen::MatrixX2d
  least_squares_conformal_map(const Triangulation& t) {
    const internal::Face_table table = internal::face_table(t);
    return internal::least_squares_conformal_map(
        table, cotangent_laplacian(t), internal::disk_border(table, t.input().names().sheets));
  }

/*!
\brief maps a disk to the plane with least conformal energy for the extent of its border (Mullen, Tong, Alliez, Desbrun, Spectral conformal
parameterization, 2008).

It is the eigenvector with the least eigenvalue of C w = lambda B w, of those with mean zero on the border, where B is the length of
the border at its vertices. No vertex is fixed: the result follows the surface, turned so that the first vertex of the border (see
`circular_border()`) is on the positive x-axis, and is scaled to the area of the surface. `certify_map()` tells whether it is injective.

\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\param t the triangulation of a disk
\return a point, x and y in the units of the input, per row of `t.input_vertex()`; isolated vertices are at (0, 0)
\throws Invalid_input if a face has no area, or the surface is not a disk, see `circular_border()`
\throws Indefinite_matrix if rounding has left no definite matrix
\complexity that of a sparse factorization of complex numbers, and of some solutions
*/
template <MeasuredTriangulation Triangulation>
  requires NumberedTriangulation<Triangulation> Eigen::MatrixX2d
  spectral_conformal_map(const Triangulation& t) {
    const internal::Face_table table = internal::face_table(t);
    return internal::spectral_conformal_map(table, cotangent_laplacian(t),
                                            internal::disk_border(table, t.input().names().sheets));
  }

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(least_squares_conformal_map)
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(spectral_conformal_map)
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#if CGAL_INTRINSIC_TRIANGULATIONS_DEFINES(FUNCTIONS)
namespace CGAL::Intrinsic_triangulations {

namespace internal {

using Complex_matrix = Eigen::SparseMatrix<std::complex<double>>;

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Complex_matrix
conformal_energy(const Eigen::SparseMatrix<double>& laplacian, const Disk_border& border) {
  Complex_matrix c = (laplacian / 2).cast<std::complex<double>>();
  std::vector<Eigen::Triplet<std::complex<double>>> area;
  for (std::size_t k = 0; k < border.rows.size(); ++k) { // the area is 1/2 Im(conj(w_i) w_j)
    const auto i = static_cast<int>(border.rows[k]),
               j = static_cast<int>(border.rows[(k + 1) % border.rows.size()]);
    area.emplace_back(i, j, std::complex<double>(0, -0.25));
    area.emplace_back(j, i, std::complex<double>(0, 0.25));
  }
  c -= matrix_of(c.rows(), c.cols(), area);
  c.makeCompressed();
  return c;
}

// Isolated vertices get the value zero.
inline void regularise_isolated(Complex_matrix& c) {
  for (int r = 0; r < c.cols(); ++r)
    if (c.coeff(r, r) == 0.0) c.coeffRef(r, r) = 1;
  c.makeCompressed();
}

// The points, scaled to the area of the surface.
inline Eigen::MatrixX2d scaled_to_area(const Face_table& table, const Eigen::VectorXcd& w) {
  double area = 0, of_image = 0;
  for (const Table_face& f : table.faces) {
    const std::complex<double> a = w[f.rows[1]] - w[f.rows[0]], b = w[f.rows[2]] - w[f.rows[0]];
    area += f.area();
    of_image += std::imag(std::conj(a) * b) / 2;
  }
  const double factor = table.unscaled(of_image > 0 ? std::sqrt(area / of_image) : 1);
  Eigen::MatrixX2d result(w.size(), 2);
  result.col(0) = factor * w.real();
  result.col(1) = factor * w.imag();
  return result;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Eigen::MatrixX2d
least_squares_conformal_map(const Face_table& table, const Eigen::SparseMatrix<double>& laplacian,
                            const Disk_border& border) {
  Complex_matrix c = conformal_energy(laplacian, border);
  regularise_isolated(c);
  const double half = std::accumulate(border.lengths.begin(), border.lengths.end(), 0.0) / 2;
  std::size_t other = 0;
  for (double length = 0; length < half; ++other) length += border.lengths[other];
  const auto first = static_cast<int>(border.rows[0]),
             second = static_cast<int>(border.rows[std::min(other, border.rows.size() - 1)]);
  std::vector<char> is_fixed(static_cast<std::size_t>(c.rows()), 0);
  is_fixed[border.rows[0]] = is_fixed[static_cast<std::size_t>(second)] = 1;
  Eigen::VectorXcd w = -c.col(second);
  w[first] = 0;
  w[second] = 1;
  c = with_fixed_rows(std::move(c), is_fixed);
  w = raised_factorization(c).solve(w);
  return scaled_to_area(table, w);
}

// The eigenvectors of C w = lambda B w of least eigenvalues: by iteration with a few vectors at a time, which are shifted by a
// small multiple of B, as C may be singular: where the surface is flat, its own shape has the eigenvalue zero. (All holomorphic
// functions have no conformal energy: the least eigenvalues are those of the smoothest, in the order of squared lengths of edges.)
class Border_spectrum {
public:
  Border_spectrum(const Complex_matrix& c, const Disk_border& border)
      : weight_(Eigen::VectorXd::Zero(c.rows())), matrix_(shifted(c, border)),
        factored_(raised_factorization(matrix_)) {}

  Eigen::VectorXcd first() const {
    const Eigen::Index n = std::min<Eigen::Index>(vectors, (weight_.array() > 0).count() - 1);
    Eigen::MatrixXcd w(weight_.size(), n);
    for (Eigen::Index r = 0; r < w.rows(); ++r) // nothing that any eigenvector is orthogonal to
      for (Eigen::Index k = 0; k < n; ++k)
        w(r, k) = std::polar(1.0, static_cast<double>((k + 1) * r) + static_cast<double>(r * r));
    double last = 0;
    for (int round = 0; round < rounds; ++round) {
      remove_constants(w);
      w = orthonormal(factored_.solve(Eigen::MatrixXcd(weight_.asDiagonal() * w)));
      const Eigen::MatrixXcd form = w.adjoint() * (matrix_ * w);
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> ritz((form + form.adjoint()) / 2);
      w *= ritz.eigenvectors();
      const double least = ritz.eigenvalues()[0];
      if (std::abs(least - last) <= 1e-10 * least + 1e-15) break;
      last = least;
    }
    remove_constants(w);
    return w.col(0);
  }

private:
  static constexpr Eigen::Index vectors = 4;
  static constexpr int rounds = 100;

  Complex_matrix shifted(Complex_matrix c, const Disk_border& border) {
    const double around = std::accumulate(border.lengths.begin(), border.lengths.end(), 0.0);
    const std::size_t n = border.rows.size();
    for (std::size_t k = 0; k < n; ++k)
      weight_[border.rows[k]] =
          (border.lengths[k] + border.lengths[(k + n - 1) % n]) / (2 * around);
    regularise_isolated(c);
    for (Eigen::Index r = 0; r < c.rows(); ++r)
      if (weight_[r] > 0) c.coeffRef(r, r) += shift * weight_[r];
    return c;
  }

  void remove_constants(Eigen::MatrixXcd& w) const {
    for (Eigen::Index k = 0; k < w.cols(); ++k) {
      const std::complex<double> mean = weight_.cast<std::complex<double>>().dot(w.col(k));
      w.col(k).array() -= mean; // the weights sum to 1
      w.col(k) /= w.col(k).cwiseAbs().maxCoeff();
    }
  }

  // By Gram and Schmidt, twice, in the inner product of B: one solution makes nearly parallel vectors of all, where an
  // eigenvalue is zero.
  Eigen::MatrixXcd orthonormal(Eigen::MatrixXcd w) const {
    for (Eigen::Index k = 0; k < w.cols(); ++k)
      for (int time = 0; time < 2; ++time) {
        w.col(k) /= w.col(k).cwiseAbs().maxCoeff();
        for (Eigen::Index i = 0; i < k; ++i) {
          const std::complex<double> along = w.col(i).dot(weight_.asDiagonal() * w.col(k));
          w.col(k) -= along * w.col(i);
        }
        w.col(k) /= std::sqrt(std::real(w.col(k).dot(weight_.asDiagonal() * w.col(k))));
      }
    return w;
  }

  static constexpr double shift = 1e-9;
  Eigen::VectorXd weight_;
  Complex_matrix matrix_;
  Cholesky_factorization<std::complex<double>> factored_;
};

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Eigen::MatrixX2d
spectral_conformal_map(const Face_table& table, const Eigen::SparseMatrix<double>& laplacian,
                       const Disk_border& border) {
  Eigen::VectorXcd w = Border_spectrum(conformal_energy(laplacian, border), border).first();
  const std::complex<double> start = w[border.rows[0]];
  if (std::abs(start) > 0) w *= std::conj(start) / std::abs(start);
  for (Eigen::Index r = 0; r < w.size(); ++r)
    if (laplacian.coeff(static_cast<int>(r), static_cast<int>(r)) == 0) w[r] = 0;
  return scaled_to_area(table, w);
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
#endif

#endif // CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_CONFORMAL_MAP_H
