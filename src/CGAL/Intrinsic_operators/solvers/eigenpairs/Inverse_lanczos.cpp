// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Chosen_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/eigenpairs/Inverse_lanczos.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <complex>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

Inverse_lanczos::Inverse_lanczos(Chosen_factorization<Complex> factor, Eigen::VectorXd masses,
                                 std::vector<std::uint32_t> part, Eigen::MatrixXcd known)
    : factor_(std::move(factor)), masses_(std::move(masses)), part_(std::move(part)),
      known_(std::move(known)) {}

Eigen::VectorXcd Inverse_lanczos::smallest(const Eigen::VectorXcd& start,
                                           const std::function<bool()>& progress) const {
  Eigen::VectorXcd z = start;
  for (Eigen::Index k = 0; k < known_.cols(); ++k) remove(known_.col(k), z);
  for (int round = 0; round < 8; ++round) // 3 are enough on the data set
    if (improve(z, progress)) break;
  return z;
}

// Replaces vectors by the best combinations of some powers of the inverse applied to them; returns
// whether they are eigenvectors, or, if cancelled, empty.
bool Inverse_lanczos::improve(Eigen::VectorXcd& z, const std::function<bool()>& progress) const {
  constexpr int steps = 16; // with 8 or 24 fields on the data set take as long, with 32 1.7 times
  Eigen::MatrixXcd basis(z.size(), steps);
  Eigen::MatrixXd diagonal = Eigen::MatrixXd::Zero(z.size(), steps), beside = diagonal;
  basis.col(0) = z;
  divide(basis.col(0), norms(z));
  for (int j = 0; j < steps; ++j) {
    Eigen::VectorXcd next(z.size());
    for (Eigen::Index i = 0; i < z.size(); ++i) next[i] = masses_[i] * basis(i, j);
    next = factor_.solve(next);
    if (!progress()) {
      z.resize(0);
      return true;
    }
    for (Eigen::Index k = 0; k < known_.cols(); ++k) remove(known_.col(k), next);
    for (int k = j; k >= 0; --k) { // all of them, since rounding makes them not orthogonal
      const Eigen::VectorXcd c = remove(basis.col(k), next);
      if (k == j) diagonal.col(j) = c.real();
    }
    Eigen::VectorXd norm = norms(next);
    // Rounding errors are no direction: those of sums of up to a million terms are 1e3 2^-53.
    for (Eigen::Index i = 0; i < z.size(); ++i)
      if (norm[i] <= 1e-13 * diagonal(i, 0)) norm[i] = 0;
    beside.col(j) = norm;
    if (j + 1 == steps) break;
    basis.col(j + 1) = next;
    divide(basis.col(j + 1), norm);
  }
  return combine(basis, diagonal, beside, z);
}

// The greatest eigenvectors of tridiagonal matrices, a row of entries for each part, as sums of
// vectors of the basis.
bool Inverse_lanczos::combine(const Eigen::MatrixXcd& basis, const Eigen::MatrixXd& diagonal,
                              const Eigen::MatrixXd& beside, Eigen::VectorXcd& z) const {
  const Eigen::Index last = diagonal.cols() - 1;
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(z.size(), last + 1);
  bool is_done = true;
  for (Eigen::Index p = 0; p < z.size(); ++p) {
    if (!(diagonal(p, 0) > 0)) continue; // represents no part, or a part that is left out
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(diagonal.row(p), beside.row(p).head(last));
    weights.row(p) = solver.eigenvectors().col(last);
    const double residual = beside(p, last) * std::abs(weights(p, last));
    // an eigenvalue errs by the square of its residual, over the gap to others (Kato, Temple)
    is_done = is_done && residual <= 1e-7 * solver.eigenvalues()[last];
  }
  for (Eigen::Index i = 0; i < z.size(); ++i)
    z[i] = basis.row(i).transpose().cwiseProduct(weights.row(part(i)).transpose()).sum();
  return is_done;
}

// Makes a vector orthogonal to one of length one, in each part; returns how much of it is removed,
// at the rows that represent parts.
Eigen::VectorXcd Inverse_lanczos::remove(const Eigen::Ref<const Eigen::VectorXcd>& unit,
                                         Eigen::VectorXcd& from) const {
  Eigen::VectorXcd c = Eigen::VectorXcd::Zero(from.size());
  for (Eigen::Index i = 0; i < from.size(); ++i)
    c[part(i)] += masses_[i] * std::conj(unit[i]) * from[i];
  for (Eigen::Index i = 0; i < from.size(); ++i) from[i] -= c[part(i)] * unit[i];
  return c;
}

Eigen::VectorXd Inverse_lanczos::norms(const Eigen::VectorXcd& x) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) result[part(i)] += masses_[i] * std::norm(x[i]);
  return result.cwiseSqrt();
}

// in each part by its norm, or by nothing
void Inverse_lanczos::divide(Eigen::Ref<Eigen::VectorXcd> x, const Eigen::VectorXd& norm) const {
  for (Eigen::Index i = 0; i < x.size(); ++i)
    x[i] = norm[part(i)] > 0 ? Complex(x[i] / norm[part(i)]) : 0;
}

} // namespace CGAL::Intrinsic_triangulations::internal
