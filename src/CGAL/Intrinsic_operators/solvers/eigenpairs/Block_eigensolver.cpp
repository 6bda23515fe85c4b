// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/eigenpairs/Block_eigensolver.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Residuals relative to \lambda m x: values have the square of this error.
static constexpr double greatest_eigenresidual = 1e-8;

Block_eigensolver::Block_eigensolver(const Eigen::SparseMatrix<double>& a,
                                     const Eigen::SparseMatrix<double>& m,
                                     const std::function<bool(std::size_t)>& progress)
    : mass_(m), multigrid_(a, excess_of(a), greatest_eigenresidual), progress_(progress) {
  find_constants();
}

// Constants in components, of length one by the masses.
void Block_eigensolver::find_constants() {
  const std::vector<std::uint32_t>& component = multigrid_.component;
  std::vector<char> is_singular(component.size(), 0);
  for (std::size_t r = 0; r < component.size(); ++r)
    is_singular[component[r]] = multigrid_.is_in_kernel(static_cast<int>(r)) ? 1 : 0;
  const std::vector<std::uint32_t> roots = least_rows(component, is_singular);
  constants_ = Eigen::MatrixXd::NullaryExpr(
      mass_.rows(), static_cast<Eigen::Index>(roots.size()),
      [&](Eigen::Index r, Eigen::Index c) -> double {
        return component[row_number(r)] == roots[row_number(c)] ? 1 : 0;
      });
  for (Eigen::Index c = 0; c < constants_.cols(); ++c)
    constants_.col(c) /= std::sqrt(constants_.col(c).dot(mass_ * constants_.col(c)));
}

void Block_eigensolver::remove_constants(Eigen::MatrixXd& x) const {
  if (constants_.cols() > 0) x -= constants_ * (constants_.transpose() * (mass_ * x)).eval();
}

// One cycle makes random vectors smooth.
Eigen::MatrixXd Block_eigensolver::random_block(Eigen::Index columns) const {
  std::mt19937 random(1);
  Eigen::MatrixXd x(mass_.rows(), columns);
  for (Eigen::Index c = 0; c < columns; ++c) {
    for (double& value : x.col(c)) value = static_cast<double>(random()) * 0x1p-31 - 1;
    Eigen::VectorXd right = mass_ * x.col(c);
    multigrid_.project(right);
    x.col(c) = (*multigrid_.cycle)(right);
  }
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

// \return whether it was not cancelled
bool Block_eigensolver::iterate(Block& x, Eigen::VectorXd& values, Eigen::Index count) {
  constexpr int most = 200; // 15 to 40 are enough on the data set
  Block step = block_of(Eigen::MatrixXd(x.x.rows(), 0));
  for (int round = 0; round < most; ++round) {
    std::vector<Eigen::VectorXd> found;
    bool is_done = true;
    for (Eigen::Index c = 0; c < x.x.cols(); ++c) {
      Eigen::VectorXd rest = x.a.col(c) - values[c] * x.m.col(c);
      if (rest.norm() <= greatest_eigenresidual * values[c] * x.m.col(c).norm()) continue;
      is_done = is_done && c >= count;
      if (progress_ && !progress_(cycles_)) return false;
      ++cycles_;
      multigrid_.project(rest);
      found.push_back((*multigrid_.cycle)(rest));
    }
    if (is_done) return true;
    Eigen::MatrixXd w(x.x.rows(), static_cast<Eigen::Index>(found.size()));
    for (std::size_t c = 0; c < found.size(); ++c) w.col(static_cast<Eigen::Index>(c)) = found[c];
    found.clear();
    remove_constants(w);
    w -= x.x * (x.m.transpose() * w).eval();
    values = improve(x, step, block_of(std::move(w)));
  }
  throw std::runtime_error("the eigenvalues have not converged; ask for others, take a direct "
                           "solver, or make the triangulation Delaunay");
}

Eigenpairs Block_eigensolver::smallest(Eigen::Index count) {
  const Eigen::Index zeros = std::min(count, constants_.cols()), others = count - zeros;
  Eigenpairs pairs{Eigen::VectorXd::Zero(count), Eigen::MatrixXd(mass_.rows(), count),
                   Status::done};
  pairs.vectors.leftCols(zeros) = constants_.leftCols(zeros);
  if (others == 0) return pairs;
  // vectors above the last one make it converge as fast as the others
  const Eigen::Index columns = std::min(others + std::max<Eigen::Index>(4, others / 4),
                                        (mass_.rows() - constants_.cols()) / 3);
  Block x = block_of(random_block(columns)), none = block_of(Eigen::MatrixXd(mass_.rows(), 0));
  Block empty = none;
  Eigen::VectorXd values = improve(x, none, empty);
  if (!iterate(x, values, others)) return {{}, Eigen::MatrixXd(mass_.rows(), 0), Status::cancelled};
  pairs.values.tail(others) = values.head(others);
  pairs.vectors.rightCols(others) = x.x.leftCols(others);
  return pairs;
}

} // namespace CGAL::Intrinsic_triangulations::internal
