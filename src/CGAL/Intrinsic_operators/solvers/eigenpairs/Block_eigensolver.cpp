// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/eigenpairs/Block_eigensolver.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Residuals relative to \lambda m x: values have the square of this error.
static constexpr double greatest_eigenresidual = 1e-8;

Block_eigensolver::Block_eigensolver(const Eigen::SparseMatrix<double>& a,
                                     const Eigen::SparseMatrix<double>& m, Solution_counter& cycles)
    : mass_(m), multigrid_(a, excess_of(a), greatest_eigenresidual), cycles_(cycles),
      masses_(m * Eigen::VectorXd::Ones(m.cols())), diagonal_(a.diagonal()) {
  find_constants();
}

void Block_eigensolver::find_constants() {
  const std::vector<std::uint32_t>& component = multigrid_.component;
  mass_of_ = Eigen::VectorXd::Zero(masses_.size());
  for (Eigen::Index r = 0; r < masses_.size(); ++r)
    mass_of_[component[row_number(r)]] += masses_[r];
  roots_ = least_rows(component, components_where_all(component, [&](Eigen::Index r) {
                        return multigrid_.is_in_kernel(r);
                      }));
}

// Constants in the first components that have them, of length one by the masses.
Eigen::MatrixXd Block_eigensolver::constants(Eigen::Index columns) const {
  return Eigen::MatrixXd::NullaryExpr(
      mass_.rows(), columns, [&](Eigen::Index r, Eigen::Index c) -> double {
        const std::uint32_t root = roots_[row_number(c)];
        return multigrid_.component[row_number(r)] == root ? 1 / std::sqrt(mass_of_[root]) : 0;
      });
}

void Block_eigensolver::remove_constants(Eigen::MatrixXd& x) const {
  for (Eigen::Index c = 0; c < x.cols(); ++c)
    multigrid_.subtract_means(x.col(c), masses_, mass_of_);
}

// One cycle makes random vectors smooth, but may make them nearly dependent.
Eigen::MatrixXd Block_eigensolver::random_block(Eigen::Index columns) {
  std::mt19937 random(1);
  Eigen::MatrixXd x(mass_.rows(), columns);
  for (Eigen::Index c = 0; c < columns; ++c) {
    for (double& value : x.col(c)) value = static_cast<double>(random()) * 0x1p-31 - 1;
    Eigen::VectorXd right = mass_ * x.col(c);
    multigrid_.project(right);
    cycles_.count();
    x.col(c) = (*multigrid_.cycle)(right);
  }
  x = Eigen::HouseholderQR<Eigen::MatrixXd>(x).householderQ() *
      Eigen::MatrixXd::Identity(x.rows(), columns);
  remove_constants(x);
  return x;
}

Block_eigensolver::Block Block_eigensolver::block_of(Eigen::MatrixXd x) const {
  Block block{std::move(x), {}, {}};
  block.a.resize(block.x.rows(), block.x.cols());
  for (Eigen::Index c = 0; c < block.x.cols(); ++c)
    block.a.col(c) = multigrid_.matrix * block.x.col(c);
  block.m = mass_ * block.x;
  return block;
}

// The smallest eigenpairs of a small problem, from directions that rounding has not made dependent.
static std::pair<Eigen::VectorXd, Eigen::MatrixXd>
small_eigenpairs(Eigen::MatrixXd a, Eigen::MatrixXd m, Eigen::Index count) {
  const Eigen::VectorXd unit =
      m.diagonal().unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 0; });
  a = unit.asDiagonal() * a * unit.asDiagonal();
  m = unit.asDiagonal() * m * unit.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> lengths(m);
  const Eigen::Index dependent = (lengths.eigenvalues().array() < 1e-13).count();
  const Eigen::Index kept = m.rows() - dependent;
  if (kept < count)
    throw No_eigenpairs("rounding leaves too few vectors for so many eigenvalues; ask for "
                        "fewer, or take a direct solver");
  const Eigen::MatrixXd basis =
      lengths.eigenvectors().rightCols(kept) *
      lengths.eigenvalues().tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(basis.transpose() * a * basis);
  return {solver.eigenvalues().head(count),
          unit.asDiagonal() * (basis * solver.eigenvectors().leftCols(count)).eval()};
}

Eigen::VectorXd Block_eigensolver::improve(Block& x, Block& step, const Block& other) const {
  const Eigen::Index n = x.x.cols(), s = step.x.cols(), o = other.x.cols();
  Eigen::MatrixXd a(n + s + o, n + s + o), m = a;
  const Block* const blocks[]{&x, &step, &other};
  const Eigen::Index begin[]{0, n, n + s};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const Block &b = *blocks[i], &c = *blocks[j];
      a.block(begin[i], begin[j], b.x.cols(), c.x.cols()) = b.x.transpose() * c.a;
      m.block(begin[i], begin[j], b.x.cols(), c.x.cols()) = b.x.transpose() * c.m;
    }
  const std::pair<Eigen::VectorXd, Eigen::MatrixXd> found =
      small_eigenpairs((a + a.transpose()) / 2, (m + m.transpose()) / 2, n);
  const Eigen::MatrixXd& weights = found.second;
  const auto combine = [&](Eigen::MatrixXd Block::*part) {
    const Eigen::MatrixXd moved =
        step.*part * weights.middleRows(n, s) + other.*part * weights.bottomRows(o);
    x.*part = (x.*part * weights.topRows(n)).eval() + moved;
    step.*part = moved;
  };
  combine(&Block::x);
  combine(&Block::a);
  combine(&Block::m);
  return found.first;
}

// Rounding of `a x` is relative to the terms of its sums, of which those of the diagonal are half.
void Block_eigensolver::iterate(Block& x, Eigen::VectorXd& values, Eigen::Index count) {
  constexpr int most = 200; // 15 to 40 are enough on the data set
  Block step = block_of(Eigen::MatrixXd(x.x.rows(), 0));
  for (int round = 0; round < most; ++round) {
    std::vector<Eigen::VectorXd> found;
    bool is_done = true;
    for (Eigen::Index c = 0; c < x.x.cols(); ++c) {
      Eigen::VectorXd rest = x.a.col(c) - values[c] * x.m.col(c);
      const double rounding = 0x1p-50 * diagonal_.cwiseProduct(x.x.col(c)).norm();
      if (rest.norm() <= std::max(greatest_eigenresidual * values[c] * x.m.col(c).norm(), rounding))
        continue;
      is_done = is_done && c >= count;
      cycles_.count();
      multigrid_.project(rest);
      found.push_back((*multigrid_.cycle)(rest));
    }
    if (is_done) return;
    Eigen::MatrixXd w(x.x.rows(), static_cast<Eigen::Index>(found.size()));
    for (std::size_t c = 0; c < found.size(); ++c) w.col(static_cast<Eigen::Index>(c)) = found[c];
    found.clear();
    remove_constants(w);
    w -= x.x * (x.m.transpose() * w).eval();
    values = improve(x, step, block_of(std::move(w)));
  }
  throw No_eigenpairs("the eigenvalues have not converged; ask for others, take a direct "
                      "solver, or make the triangulation Delaunay");
}

Eigenpairs Block_eigensolver::smallest(Eigen::Index count) {
  const Eigen::Index zeros = std::min(count, static_cast<Eigen::Index>(roots_.size()));
  const Eigen::Index others = count - zeros;
  Eigenpairs pairs{Eigen::VectorXd::Zero(count), Eigen::MatrixXd(mass_.rows(), count),
                   Status::done};
  pairs.vectors.leftCols(zeros) = constants(zeros);
  if (others == 0) return pairs;
  // vectors above the last one make it converge as fast as the others
  const Eigen::Index columns =
      std::min(others + std::max<Eigen::Index>(4, others / 4),
               (mass_.rows() - static_cast<Eigen::Index>(roots_.size())) / 3);
  Block x = block_of(random_block(columns)), none = block_of(Eigen::MatrixXd(mass_.rows(), 0));
  Block empty = none;
  Eigen::VectorXd values = improve(x, none, empty);
  iterate(x, values, others);
  pairs.values.tail(others) = values.head(others);
  pairs.vectors.rightCols(others) = x.x.leftCols(others);
  return pairs;
}

} // namespace CGAL::Intrinsic_triangulations::internal
