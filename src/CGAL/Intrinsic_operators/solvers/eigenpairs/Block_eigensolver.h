// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_EIGENPAIRS_BLOCK_EIGENSOLVER_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_EIGENPAIRS_BLOCK_EIGENSOLVER_H

#include <CGAL/Intrinsic_operators/solvers/eigenpairs.h>
#include <CGAL/Intrinsic_operators/solvers/multigrid/Multigrid.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <functional>

namespace CGAL::Intrinsic_triangulations::internal {

/*
The smallest eigenvalues of `a x = lambda m x` without a factor of `a`: a block of vectors is
replaced by the best combinations of it, of its residuals after a cycle of multigrid, and of the
step before (locally optimal block preconditioned conjugate gradients: Knyazev 2001). A block finds
all vectors of a multiple eigenvalue. Constants in the kernel of a Laplacian are known, and taken
out.
*/
class Block_eigensolver {
public:
  // \param progress is called with the number of cycles before each step, and returns whether to go
  // on \throws Indefinite_matrix
  Block_eigensolver(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& m,
                    const std::function<bool(std::size_t)>& progress);

  // \param count how many, fewer than a third of the rows \return the pairs; none if cancelled
  // \throws std::runtime_error if they do not converge
  Eigenpairs smallest(Eigen::Index count);

private:
  // Vectors, and what both matrices make of them.
  struct Block {
    Eigen::MatrixXd x, a, m;
  };

  void find_constants();
  void remove_constants(Eigen::MatrixXd& x) const;
  Eigen::MatrixXd random_block(Eigen::Index columns) const;
  Block block_of(Eigen::MatrixXd x) const;
  // Replaces the block by its best combinations with others. \return its eigenvalues
  Eigen::VectorXd improve(Block& x, Block& step, const Block& other) const;
  bool iterate(Block& x, Eigen::VectorXd& values, Eigen::Index count);

  const Eigen::SparseMatrix<double>& mass_;
  Multigrid<double> multigrid_;
  const std::function<bool(std::size_t)>& progress_;
  Eigen::MatrixXd constants_; // a column per component with constants in the kernel
  std::size_t cycles_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_EIGENPAIRS_BLOCK_EIGENSOLVER_H
