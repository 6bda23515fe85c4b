// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class Factorization Cholesky_factorization.h <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
\cgalConcept

The concept `Factorization` describes a positive definite matrix that was prepared once, and solves
for any number of right sides. The concept requires no constructor: each model needs other
arguments to be accurate.

\cgalHasModel{\itc{Cholesky_factorization}: for symmetric and Hermitian matrices}
\cgalHasModel{\itc{Laplacian_factorization}: for the Laplacian of a graph and a diagonal, without
subtraction}
\cgalHasModel{\itc{Multigrid_factorization}: for symmetric and Hermitian matrices, by iteration}

\cgalHeading{Which operation needs what}

Steps of the heat flow of functions use \itc{Laplacian_factorization}, those of vectors
\itc{Cholesky_factorization}; \itf{smallest_eigenpairs} takes either. \itc{Fixed_values_solver}
chooses one when it sees the matrix, so that the choice is not a parameter of its type. It iterates
with \itc{Multigrid_factorization} if you ask for it, or if \itf{solver_for} says so.

\cgalHeading{Complexity}

A copy shares the factor. A solution takes linear time in the number of entries of the factor, or
for each step of an iteration in those of the matrix.
*/
class Factorization {
public:
  /// Type of the matrix, an `Eigen::SparseMatrix`.
  typedef unspecified_type Matrix;
  /// Type of right sides and solutions, a column each: a dense matrix of the same numbers.
  typedef unspecified_type Vectors;
  /// returns the number of rows.
  Eigen::Index size() const;
  /// solves for right sides. \pre `b` has a row per row of the matrix
  Vectors solve(const Vectors& b) const;
};
