// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_EIGENPAIRS_BLOCK_EIGENSOLVER_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_EIGENPAIRS_BLOCK_EIGENSOLVER_H

#include <CGAL/Intrinsic_operators/solvers/eigenpairs.h>
#include <CGAL/Intrinsic_operators/solvers/multigrid/Multigrid.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Ends Spectra's loops, which have no other way to stop.
struct Cancelled_eigenpairs {};

// An iteration for eigenpairs ended before their residuals were small enough.
struct No_eigenpairs : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Calls the visitor before each solution or cycle, with the number of previous ones.
class Solution_counter {
public:
  explicit Solution_counter(std::function<bool(std::size_t)> progress)
      : progress_(std::move(progress)) {}
  // \throws Cancelled_eigenpairs
  void count() {
    if (progress_ && !progress_(solutions_++)) throw Cancelled_eigenpairs();
  }

private:
  std::function<bool(std::size_t)> progress_;
  std::size_t solutions_ = 0;
};

/*
The smallest eigenvalues of `a x = lambda m x` without a factor of `a`: a block of vectors is
replaced by the best combinations of it, of its residuals after a cycle of multigrid, and of the
step before (locally optimal block preconditioned conjugate gradients: Knyazev 2001). A block finds
all vectors of a multiple eigenvalue. Constants in the kernel of a Laplacian are known, and taken
out.
*/
class Block_eigensolver {
public:
  // \param cycles counts them; must outlive this object \throws Indefinite_matrix
  Block_eigensolver(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& m,
                    Solution_counter& cycles);

  // \param count how many, fewer than a third of the rows
  // \throws No_eigenpairs if they do not converge \throws Cancelled_eigenpairs
  Eigenpairs smallest(Eigen::Index count);

private:
  // Vectors, and what both matrices make of them.
  struct Block {
    Eigen::MatrixXd x, a, m;
  };

  void find_constants();
  void remove_constants(Eigen::MatrixXd& x) const;
  Eigen::MatrixXd constants(Eigen::Index columns) const;
  Eigen::MatrixXd random_block(Eigen::Index columns);
  Block block_of(Eigen::MatrixXd x) const;
  // Replaces the block by its best combinations with others. \return its eigenvalues
  Eigen::VectorXd improve(Block& x, Block& step, const Block& other) const;
  void iterate(Block& x, Eigen::VectorXd& values, Eigen::Index count);

  const Eigen::SparseMatrix<double>& mass_;
  Multigrid<double> multigrid_;
  Solution_counter& cycles_;
  Eigen::VectorXd masses_, diagonal_; // sums of rows of the mass matrix; the diagonal of `a`
  std::vector<std::uint32_t> roots_;  // least rows of components with constants in the kernel
  Eigen::VectorXd mass_of_;           // of components, at their least rows
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_EIGENPAIRS_BLOCK_EIGENSOLVER_H
