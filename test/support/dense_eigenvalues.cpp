// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "dense_eigenvalues.h"

#include <Eigen/Eigenvalues>

namespace {

template <class Matrix>
Eigen::VectorXd eigenvalues(const Matrix& a) {
  return Eigen::SelfAdjointEigenSolver<Matrix>(a, Eigen::EigenvaluesOnly).eigenvalues();
}

template <class Matrix>
Dense_eigenpairs<Matrix> eigenpairs(const Matrix& a, const Matrix& b) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> solver(a, b);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

} // namespace

Eigen::VectorXd dense_eigenvalues(const Eigen::MatrixXd& a) { return eigenvalues(a); }
Eigen::VectorXd dense_eigenvalues(const Eigen::MatrixXcd& a) { return eigenvalues(a); }

Dense_eigenpairs<Eigen::MatrixXd> dense_eigenpairs(const Eigen::MatrixXd& a,
                                                   const Eigen::MatrixXd& b) {
  return eigenpairs(a, b);
}

Dense_eigenpairs<Eigen::MatrixXcd> dense_eigenpairs(const Eigen::MatrixXcd& a,
                                                    const Eigen::MatrixXcd& b) {
  return eigenpairs(a, b);
}
