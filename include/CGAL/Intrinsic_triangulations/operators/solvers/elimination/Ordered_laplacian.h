// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_ORDERED_LAPLACIAN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_ORDERED_LAPLACIAN_H

#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/Elimination.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <future>
#include <memory>

namespace CGAL::Intrinsic_triangulations::internal {

// A Laplacian, the order of which is found while its owner does something else, where there is a second processor.
class Ordered_laplacian {
public:
  using Matrix = Eigen::SparseMatrix<double>;

  // begins to find the order
  explicit Ordered_laplacian(Matrix laplacian);

  const Matrix& operator*() const { return *laplacian_; }
  const Matrix* operator->() const { return laplacian_.get(); }
  const std::shared_ptr<const Matrix>& matrix() const { return laplacian_; }

  // waits for it
  const std::shared_ptr<const Elimination>& elimination() const { return elimination_.get(); }

private:
  std::shared_ptr<const Matrix> laplacian_;
  std::shared_future<std::shared_ptr<const Elimination>> elimination_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_ORDERED_LAPLACIAN_H
