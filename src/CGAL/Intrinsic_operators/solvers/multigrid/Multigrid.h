// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIGRID_MULTIGRID_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIGRID_MULTIGRID_H

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Multigrid_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_operators/solvers/multigrid/Multigrid_hierarchy.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <complex>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

template <class Scalar>
struct Multigrid {
  using Matrix = Eigen::SparseMatrix<Scalar>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  // \param full compressed, both triangles
  Multigrid(Matrix full, Eigen::VectorXd excess, double least_residual)
      : matrix{std::move(full), std::move(excess)}, tolerance(least_residual) {
    if constexpr (std::is_same_v<Scalar, double>) find_kernel();
    const Eigen::VectorXd diagonal = matrix.matrix.diagonal().real();
    for (int i = 0; i < diagonal.size(); ++i)
      if (!(diagonal[i] > 0) && !is_in_kernel(i)) throw Indefinite_matrix(i);
    cycle.emplace(matrix);
  }
  Multigrid(const Multigrid&) = delete; // the cycle refers to the matrix
  Multigrid& operator=(const Multigrid&) = delete;

  // Finds the components where rows sum to zero.
  void find_kernel() {
    component = components_of_matrix(matrix.matrix);
    const std::vector<char> has_constants =
        components_where_all(component, [&](Eigen::Index r) { return matrix.excess[r] == 0; });
    if (least_rows(component, has_constants).empty()) return;
    kernel_size.assign(component.size(), 0);
    for (const std::uint32_t root : component)
      if (has_constants[root] != 0) ++kernel_size[root];
  }
  bool is_in_kernel(Eigen::Index i) const {
    return !kernel_size.empty() && kernel_size[component[row_number(i)]] > 0;
  }

  // Subtracts the means of components with constants in the kernel.
  void project(Vector& x) const { subtract_means(x, Eigen::VectorXd::Ones(x.size()), kernel_size); }
  // The same with weights. \param total of the weights of components, at their least rows
  template <class Values, class Weights, class Totals>
  void subtract_means(Values&& x, const Weights& weight, const Totals& total) const {
    if (kernel_size.empty()) return;
    Vector sum = Vector::Zero(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) sum[component[row_number(i)]] += weight[i] * x[i];
    for (Eigen::Index i = 0; i < x.size(); ++i)
      if (const std::uint32_t root = component[row_number(i)]; kernel_size[root] > 0)
        x[i] -= sum[root] / total[root];
  }

  // The greatest entry of a direction along which the matrix is not positive is in a row at fault.
  static Eigen::Index greatest_row(const Vector& p) {
    Eigen::Index row = 0;
    p.cwiseAbs().maxCoeff(&row);
    return row;
  }

  /*
  Conjugate gradients (Hestenes and Stiefel 1952). The residual is updated, and differs from that of
  the solution by rounding: where it seems small enough, the iteration begins anew from there, and
  ends if the true one is.
  */
  Vector solve(const Vector& b, Iterations& iterations) const {
    constexpr int most = 1000;
    const double enough = tolerance * b.norm();
    Vector x = Vector::Zero(b.size()), r = b;
    project(r);
    int steps = 0;
    for (double last = r.norm(); last > enough && steps < most;) {
      steps += descend(x, r, enough, most - steps);
      r = b - matrix * x;
      project(r);
      const double now = r.norm();
      if (!(now < 0.5 * last)) break; // rounding prevents more
      last = now;
    }
    if (enough == 0) return x;
    iterations.most = std::max(iterations.most, steps);
    const double residual = r.norm() / b.norm();
    if (!(residual <= iterations.residual)) iterations.residual = residual;
    if (!(residual <= tolerance)) iterations.status = Status::cap;
    return x;
  }

  // \return the number of steps
  int descend(Vector& x, Vector& r, double enough, int most) const {
    Vector p;
    double last = 0;
    for (int step = 0; step < most; ++step) {
      if (!(r.norm() > 0.5 * enough)) return step;
      Vector z = (*cycle)(r);
      project(z);
      const double now = std::real(r.dot(z));
      if (!(now > 0)) throw Indefinite_matrix(greatest_row(z));
      p = step == 0 ? z : Vector(z + now / last * p);
      const Vector image = matrix * p;
      const double energy = std::real(p.dot(image));
      if (!(energy > 0)) throw Indefinite_matrix(greatest_row(p));
      x += now / energy * p;
      r -= now / energy * image;
      last = now;
    }
    return most;
  }

  Matrix_with_sums<Scalar> matrix;
  double tolerance;
  std::vector<std::uint32_t> component; // of each row, its least row
  std::vector<double>
      kernel_size; // of components with constants in the kernel, at their least rows
  std::optional<Multigrid_hierarchy<Scalar>> cycle;
};

// The sums of the rows of a matrix, zero in components where rounding explains all of them.
inline Eigen::VectorXd excess_of(const Eigen::SparseMatrix<double>& a) {
  const Row_sums sums(a);
  const std::vector<std::uint32_t> component = components_of_matrix(a);
  const std::vector<char> has_constants = laplacian_components(sums, component);
  Eigen::VectorXd result = sums.sum;
  for (std::size_t r = 0; r < component.size(); ++r)
    if (has_constants[component[r]] != 0) result[static_cast<Eigen::Index>(r)] = 0;
  return result;
}
inline Eigen::VectorXd excess_of(const Eigen::SparseMatrix<std::complex<double>>& a) {
  return Eigen::VectorXd::Zero(a.cols());
}

inline void expect_tolerance(double tolerance) {
  if (!(tolerance >= 1e-14 && tolerance <= 1))
    throw std::invalid_argument("the tolerance must be between 1e-14 and 1");
}

// Refuses right sides without a solution.
template <class Scalar>
static void expect_right_side(const Multigrid<Scalar>& m,
                              const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& b) {
  if (!b.allFinite()) throw std::invalid_argument("the right side must be finite");
  auto projected = b;
  m.project(projected);
  if (!((b - projected).norm() <= 0x1p-26 * b.norm()))
    throw std::invalid_argument("rows of the matrix sum to zero in a component, so the right side "
                                "must sum to zero there; subtract its mean, or fix a value");
}

} // namespace internal

template <internal::Matrix_number Scalar>
Multigrid_factorization<Scalar>::Multigrid_factorization(const Matrix& a, double tolerance) {
  internal::expect_factorable(a);
  internal::expect_tolerance(tolerance);
  Matrix full = a.template selfadjointView<Eigen::Lower>();
  full.makeCompressed();
  Eigen::VectorXd excess = internal::excess_of(full);
  multigrid_ = std::make_shared<const internal::Multigrid<Scalar>>(std::move(full),
                                                                   std::move(excess), tolerance);
}

template <internal::Matrix_number Scalar>
Multigrid_factorization<Scalar>::Multigrid_factorization(
    const Matrix& laplacian, const Eigen::VectorXd& diagonal,
    double tolerance) requires std::same_as<Scalar, double> {
  internal::expect_factorable(laplacian);
  internal::expect_tolerance(tolerance);
  if (diagonal.size() != laplacian.rows() || !diagonal.allFinite())
    throw std::invalid_argument("the diagonal must have a finite number per row of the matrix");
  Matrix full = laplacian.template selfadjointView<Eigen::Lower>();
  // not of double: clang 14 compiles this for complex numbers, too
  using Vector = typename internal::Multigrid<Scalar>::Vector;
  const Vector sums = full * Vector::Ones(full.cols());
  for (int i = 0; i < full.cols(); ++i) full.coeffRef(i, i) += diagonal[i] - sums[i];
  full.makeCompressed();
  multigrid_ =
      std::make_shared<const internal::Multigrid<Scalar>>(std::move(full), diagonal, tolerance);
}

template <internal::Matrix_number Scalar>
Eigen::Index Multigrid_factorization<Scalar>::size() const {
  return multigrid_->matrix.matrix.cols();
}

template <internal::Matrix_number Scalar>
typename Multigrid_factorization<Scalar>::Vectors
Multigrid_factorization<Scalar>::solve(const Vectors& b, Iterations& iterations) const {
  if (b.rows() != size())
    throw std::invalid_argument("the right side must have a row per row of the matrix, " +
                                std::to_string(size()) + ", not " + std::to_string(b.rows()));
  iterations = {};
  Vectors x(b.rows(), b.cols());
  for (Eigen::Index c = 0; c < b.cols(); ++c) {
    internal::expect_right_side<Scalar>(*multigrid_, b.col(c));
    x.col(c) = multigrid_->solve(b.col(c), iterations);
  }
  return x;
}

template <internal::Matrix_number Scalar>
typename Multigrid_factorization<Scalar>::Vectors
Multigrid_factorization<Scalar>::solve(const Vectors& b) const {
  Iterations iterations;
  Vectors x = solve(b, iterations);
  if (iterations.status != Status::done) throw No_convergence(iterations);
  return x;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIGRID_MULTIGRID_H
