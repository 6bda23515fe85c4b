// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_DENSE_EIGENVALUES_H
#define TEST_INTRINSIC_TRIANGULATIONS_DENSE_EIGENVALUES_H

#include <Eigen/Dense>

// Eigen's solvers for dense matrices, by which tests check sparse ones. They take seconds to compile.

/// returns the eigenvalues of a symmetric matrix, in order.
Eigen::VectorXd dense_eigenvalues(const Eigen::MatrixXd& a);
/// returns those of a Hermitian matrix.
Eigen::VectorXd dense_eigenvalues(const Eigen::MatrixXcd& a);

/// Eigenvalues in order, and eigenvectors as columns.
template <class Matrix>
struct Dense_eigenpairs {
  Eigen::VectorXd values;
  Matrix vectors;
};

/// solves a x = lambda b x. \param a symmetric \param b symmetric and positive definite
Dense_eigenpairs<Eigen::MatrixXd> dense_eigenpairs(const Eigen::MatrixXd& a,
                                                   const Eigen::MatrixXd& b);
/// the same for Hermitian matrices
Dense_eigenpairs<Eigen::MatrixXcd> dense_eigenpairs(const Eigen::MatrixXcd& a,
                                                    const Eigen::MatrixXcd& b);

#endif // TEST_INTRINSIC_TRIANGULATIONS_DENSE_EIGENVALUES_H
