// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_BORDER_SPECTRUM_H
#define CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_BORDER_SPECTRUM_H

#include <CGAL/Intrinsic_operators/parametrization/disk_border.h>
#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numeric>

namespace CGAL::Intrinsic_triangulations::internal {

using Complex_matrix = Eigen::SparseMatrix<std::complex<double>>;

// Isolated vertices get the value zero.
inline void regularise_isolated(Complex_matrix& c) {
  for (int r = 0; r < c.cols(); ++r)
    if (c.coeff(r, r) == 0.0) c.coeffRef(r, r) = 1;
  c.makeCompressed();
}

// The eigenvectors of C w = lambda B w with least eigenvalues, by inverse iteration with a few
// vectors at a time. A small multiple of B shifts C, since C may be singular: on a flat surface its
// own shape has eigenvalue zero. (Holomorphic functions have no conformal energy: the least
// eigenvalues are those of the smoothest ones, in the order of squared lengths of edges.)
class Border_spectrum {
public:
  Border_spectrum(const Complex_matrix& c, const Disk_border& border)
      : weight_(Eigen::VectorXd::Zero(c.rows())), matrix_(shifted(c, border)),
        factored_(raised_factorization(matrix_)) {}

  Eigen::VectorXcd first() const {
    const Eigen::Index n = std::min<Eigen::Index>(vectors, (weight_.array() > 0).count() - 1);
    Eigen::MatrixXcd w(weight_.size(), n);
    for (Eigen::Index r = 0; r < w.rows(); ++r) // not orthogonal to any eigenvector
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

  // By Gram and Schmidt, twice, in the inner product of B: if an eigenvalue is zero, one solution
  // makes all vectors nearly parallel.
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

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_BORDER_SPECTRUM_H
