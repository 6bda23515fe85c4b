// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#if __has_include(<Spectra/SymGEigsShiftSolver.h>)

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Chosen_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_operators/solvers/eigenpairs.h>
#include <CGAL/Intrinsic_operators/solvers/eigenpairs/Block_eigensolver.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymGEigsShiftSolver.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The operator for Spectra, y = (a + s m)^-1 x, from a factorization. It can take out known
// eigenvectors, so that Spectra finds others.
class Shifted_inverse {
public:
  using Scalar = double; // named by Spectra

  // \param solutions counts them; must outlive this object
  template <Factorization Factored>
  Shifted_inverse(Factored factored, Solution_counter& solutions)
      : factorization_(std::move(factored)), solutions_(&solutions) {}
  Eigen::Index rows() const { return factorization_.size(); }
  Eigen::Index cols() const { return rows(); }
  void set_shift(double) {}
  void perform_op(const double* x, double* y) const {
    solutions_->count();
    const Eigen::VectorXd v = Eigen::Map<const Eigen::VectorXd>(x, rows());
    Eigen::Map<Eigen::VectorXd> result(y, rows());
    result = factorization_.solve(v);
    if (out_.values.size() == 0) return;
    const Eigen::VectorXd parts = out_.vectors.transpose() * v;
    result -= out_.vectors * parts.cwiseProduct(out_.values);
  }
  // takes out pairs of `a x = lambda m x`
  void take_out(const Eigenpairs& pairs, double shift) {
    out_.values = (pairs.values.array() + shift).inverse();
    out_.vectors = pairs.vectors;
  }

private:
  Chosen_factorization<double> factorization_;
  Eigenpairs out_{};
  Solution_counter* solutions_;
};

static Eigenpairs lanczos_eigenpairs(Shifted_inverse& inverse,
                                     const Spectra::SparseSymMatProd<double>& mass,
                                     Eigen::Index count, double shift) {
  auto m = mass; // which Spectra takes as not constant
  // twice the number of pairs, as Spectra advises
  const Eigen::Index space = std::min(inverse.rows(), std::max<Eigen::Index>(2 * count + 1, 20));
  // eigenvalues far above a cluster of others have fewer digits; 1e-10 is the default of Spectra
  for (const double tolerance : {1e-13, 1e-10}) {
    Spectra::SymGEigsShiftSolver<Shifted_inverse, Spectra::SparseSymMatProd<double>,
                                 Spectra::GEigsMode::ShiftInvert>
        solver(inverse, m, count, space, -shift);
    solver.init();
    solver.compute(Spectra::SortRule::LargestMagn, 1000, tolerance,
                   Spectra::SortRule::SmallestAlge);
    if (solver.info() == Spectra::CompInfo::Successful)
      return {solver.eigenvalues(), solver.eigenvectors(), Status::done};
  }
  throw std::runtime_error("the eigenvalues have not converged; ask for others, or a finer mesh");
}

// Inserts one pair among others and drops the greatest.
static void insert_pair(Eigenpairs& pairs, double value, const Eigen::VectorXd& vector) {
  Eigen::Index i = pairs.values.size() - 1;
  for (; i > 0 && pairs.values[i - 1] > value; --i) {
    pairs.values[i] = pairs.values[i - 1];
    pairs.vectors.col(i) = pairs.vectors.col(i - 1);
  }
  pairs.values[i] = value;
  pairs.vectors.col(i) = vector;
}

// From one vector Lanczos' method finds one eigenvector of each eigenvalue, and others by rounding
// only: on a symmetric surface it misses some. It finds them after the others are taken out.
static void find_missed_pairs(Eigenpairs& pairs, Shifted_inverse& inverse,
                              const Spectra::SparseSymMatProd<double>& mass, double shift) {
  constexpr double equal = 1 - 1e-9; // ten times the larger tolerance above
  for (Eigen::Index i = 0; i < pairs.values.size(); ++i) {
    inverse.take_out(pairs, shift);
    const Eigenpairs next = lanczos_eigenpairs(inverse, mass, 1, shift);
    if (!(next.values[0] < equal * pairs.values[pairs.values.size() - 1])) return;
    insert_pair(pairs, next.values[0], next.vectors.col(0));
  }
}

// Throws if a pair is wrong: its residual must be rounding relative to the terms of its sums, else
// it is noise of Lanczos' method.
static void expect_eigenpairs(const Eigen::SparseMatrix<double>& a,
                              const Eigen::SparseMatrix<double>& m, const Eigenpairs& pairs) {
  const Eigen::SparseMatrix<double> sizes_a = a.cwiseAbs(), sizes_m = m.cwiseAbs();
  for (Eigen::Index i = 0; i < pairs.values.size(); ++i) {
    const Eigen::VectorXd x = pairs.vectors.col(i), size = x.cwiseAbs();
    const double value = pairs.values[i];
    const double terms = (sizes_a * size + std::abs(value) * (sizes_m * size)).norm();
    if (!((a * x - value * (m * x)).norm() <= 0x1p-26 * terms)) // half of the digits
      throw std::runtime_error("eigenvalue " + std::to_string(i) +
                               " has not converged; ask for fewer");
  }
}

// the row of the least diagonal entry
static Eigen::Index least_diagonal(const Eigen::SparseMatrix<double>& m) {
  Eigen::Index row = 0;
  Eigen::VectorXd(m.diagonal()).minCoeff(&row);
  return row;
}

static Eigenpairs dense_eigenpairs(const Eigen::MatrixXd& a, const Eigen::SparseMatrix<double>& m) {
  const Eigen::MatrixXd dense(m);
  if (Eigen::LLT<Eigen::MatrixXd>(dense).info() != Eigen::Success)
    throw Indefinite_matrix(least_diagonal(m));
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(a, dense);
  return {solver.eigenvalues(), solver.eigenvectors(), Status::done};
}

// A column per component, constant there; orthonormal by a mass matrix.
static Eigen::MatrixXd constants_of_components(const Eigen::SparseMatrix<double>& a,
                                               const Eigen::SparseMatrix<double>& m) {
  const std::vector<std::uint32_t> component = components_of_matrix(a);
  std::vector<std::uint32_t> least = component;
  std::sort(least.begin(), least.end());
  least.erase(std::unique(least.begin(), least.end()), least.end());
  const auto columns = static_cast<Eigen::Index>(least.size());
  const Eigen::MatrixXd c = Eigen::MatrixXd::NullaryExpr(
      a.rows(), columns, [&](Eigen::Index i, Eigen::Index j) -> double {
        return component[row_number(i)] == least[row_number(j)] ? 1 : 0;
      });
  const Eigen::LLT<Eigen::MatrixXd> gram(c.transpose() * (m * c));
  return c * gram.matrixU().solve(Eigen::MatrixXd::Identity(columns, columns)).eval();
}

// Constants in components have the eigenvalue zero, which rounding of the greatest eigenvalue would
// hide: they are lifted above it, and moved to the front at the end.
static Eigenpairs dense_laplacian_eigenpairs(const Eigen::SparseMatrix<double>& a,
                                             const Eigen::SparseMatrix<double>& m,
                                             Eigen::Index count) {
  const double greatest = dense_eigenpairs(Eigen::MatrixXd(a), m).values.cwiseAbs().maxCoeff();
  const Eigen::MatrixXd constants = constants_of_components(a, m), images = m * constants;
  Eigenpairs others =
      dense_eigenpairs(Eigen::MatrixXd(a) + 4 * greatest * images * images.transpose(), m);
  const double rounding = 0x1p-50 * static_cast<double>(a.rows()) * greatest;
  for (double& value : others.values) // without negative weights there are no negative eigenvalues
    if (value < 0 && value > -rounding) value = 0;
  const Eigen::Index zeros = constants.cols(), rest = a.rows() - zeros;
  for (Eigen::Index i = 0; i < std::min(rest, count - zeros); ++i)
    if (!(others.values[i] > 16 * rounding)) // a digit is left
      throw std::runtime_error("rounding hides eigenvalue " + std::to_string(zeros + i) +
                               " next to the greatest one; ask for fewer, or "
                               "refine faces that are too thin");
  Eigenpairs pairs{Eigen::VectorXd::Zero(a.rows()), Eigen::MatrixXd(a.rows(), a.rows()),
                   Status::done};
  pairs.vectors << constants, others.vectors.leftCols(rest);
  pairs.values.tail(rest) = others.values.head(rest);
  return pairs;
}

// The smallest of all pairs.
static Eigenpairs smallest_of(const Eigenpairs& all, Eigen::Index count) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(all.values.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Eigen::Index i, Eigen::Index j) { return all.values[i] < all.values[j]; });
  order.resize(static_cast<std::size_t>(count));
  return {all.values(order), all.vectors(Eigen::all, order), Status::done};
}

static bool is_zero_matrix(const Eigen::SparseMatrix<double>& a) {
  for (int c = 0; c < a.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(a, c); i; ++i)
      if (i.value() != 0) return false;
  return true;
}

// For the zero matrix, as for isolated vertices, every vector is an eigenvector: Lanczos' method
// cannot start. With m = l l^T in the first rows, columns of l^-T are orthonormal.
static Eigenpairs eigenpairs_of_zero(const Eigen::SparseMatrix<double>& m, Eigen::Index count) {
  const Eigen::LLT<Eigen::MatrixXd> factored(
      Eigen::MatrixXd(Eigen::SparseMatrix<double>(m.topLeftCorner(count, count))));
  if (factored.info() != Eigen::Success || !(m.diagonal().minCoeff() > 0))
    throw Indefinite_matrix(least_diagonal(m));
  Eigen::MatrixXd vectors = Eigen::MatrixXd::Identity(m.rows(), count);
  vectors.topRows(count) = factored.matrixU().solve(Eigen::MatrixXd::Identity(count, count)).eval();
  return {Eigen::VectorXd::Zero(count), std::move(vectors), Status::done};
}

// trace(a) / trace(m): on a mesh without slivers, about the first nonzero frequency times the size.
static double mean_eigenvalue(const Eigen::SparseMatrix<double>& a,
                              const Eigen::SparseMatrix<double>& m) {
  const double mean = a.diagonal().sum() / m.diagonal().sum();
  return mean > 0 ? mean : 1;
}

// `m` is a positive diagonal, and `a` the Laplacian of a graph: without negative weights, or with
// few at the border, their inverse with a shift is accurate entry by entry.
static bool is_lumped_laplacian(const Eigen::SparseMatrix<double>& a,
                                const Eigen::SparseMatrix<double>& m) {
  for (int c = 0; c < m.cols(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(m, c); i; ++i)
      if (i.value() != 0 && i.row() != c) return false;
  return a.isCompressed() && is_laplacian(a) && m.diagonal().minCoeff() > 0;
}

// Estimates the number of eigenvalues below the shift, without those of constants in components, by
// a random vector x orthogonal to these: the expectation of x^T m^1/2 (a + s m)^-1 m^1/2 x, the sum
// of s / (lambda + s).
static double eigenvalues_below(const Laplacian_factorization& inverse,
                                const Eigen::VectorXd& masses,
                                const std::vector<std::uint32_t>& component, double shift) {
  std::mt19937 random(1);
  Eigen::VectorXd x = masses.cwiseSqrt();
  for (double& value : x) value *= (random() & 1U) != 0 ? 1 : -1;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(x.size()), mass = sum;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const std::uint32_t c = component[row_number(i)];
    sum[c] += x[i];
    mass[c] += masses[i];
  }
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const std::uint32_t c = component[row_number(i)];
    x[i] -= masses[i] * sum[c] / mass[c];
  }
  return shift * x.dot(inverse.solve(x));
}

// Eigenvalues of the inverse are right to rounding of its greatest one, 1 / shift: the shift must
// not be much above the wanted eigenvalues. A shift from the trace would be, if few large weights
// dominate it.
static Shifted_inverse inverted_laplacian(const Eigen::SparseMatrix<double>& a,
                                          const Eigen::VectorXd& masses, Eigen::Index count,
                                          double& shift, Solution_counter& solutions) {
  const double few = std::max(8., static_cast<double>(count));
  const std::vector<std::uint32_t> component = components_of_matrix(a);
  Laplacian_factorization inverse(a, shift * masses);
  for (;;) {
    solutions.count();
    if (!(eigenvalues_below(inverse, masses, component, shift) > few)) break;
    shift *= 0x1p-10;
    inverse = Laplacian_factorization(a, shift * masses);
  }
  return {std::move(inverse), solutions};
}

// Inverts `a` plus a given shift. For matrices other than Laplacians it is far less than the first
// frequency, but large enough that rounding leaves the matrix definite: the smallest eigenvalue is
// the shift, the condition about the square of the size.
static Shifted_inverse shifted_inverse(const Eigen::SparseMatrix<double>& a,
                                       const Eigen::SparseMatrix<double>& m, Eigen::Index count,
                                       double& shift, Solution_counter& solutions) {
  const double size = static_cast<double>(a.rows());
  shift = mean_eigenvalue(a, m) / (8 * size);
  if (is_lumped_laplacian(a, m)) {
    try {
      return inverted_laplacian(a, m.diagonal(), count, shift, solutions);
    } catch (const Indefinite_matrix&) { // has many negative weights
    }
  }
  shift = mean_eigenvalue(a, m) / (size * size);
  return {Cholesky_factorization<double>(a + shift * m), solutions};
}

static Eigenpairs factored_eigenpairs(const Eigen::SparseMatrix<double>& a,
                                      const Eigen::SparseMatrix<double>& m, Eigen::Index count,
                                      Solution_counter& solutions) {
  double shift = 0;
  const Spectra::SparseSymMatProd<double> mass(m);
  Shifted_inverse inverse = shifted_inverse(a, m, count, shift, solutions);
  Eigenpairs pairs = lanczos_eigenpairs(inverse, mass, count, shift);
  find_missed_pairs(pairs, inverse, mass, shift);
  expect_eigenpairs(a, m, pairs);
  return pairs;
}

static Eigenpairs sparse_eigenpairs(const Eigen::SparseMatrix<double>& a,
                                    const Eigen::SparseMatrix<double>& m, Eigen::Index count,
                                    Linear_solver solver, Solution_counter& solutions) {
  // blocks of more vectors take more memory than a factor
  if (chosen_solver(solver, a.rows()) == Linear_solver::iterative && count <= a.rows() / 16) {
    try {
      return Block_eigensolver(a, m, solutions).smallest(count);
    } catch (const No_eigenpairs&) {
      if (solver == Linear_solver::iterative) throw;
    } catch (const Indefinite_matrix&) { // has negative weights
      if (solver == Linear_solver::iterative) throw;
    }
  }
  return factored_eigenpairs(a, m, count, solutions);
}

Eigenpairs smallest_eigenpairs(const Eigen::SparseMatrix<double>& a,
                               const Eigen::SparseMatrix<double>& m, Eigen::Index count,
                               Linear_solver solver,
                               const std::function<bool(std::size_t)>& progress) {
  const Eigen::Index size = a.rows();
  if (a.cols() != size || m.rows() != size || m.cols() != size)
    throw std::invalid_argument("both matrices must be square and of one size");
  if (count < 0 || count > size)
    throw std::invalid_argument("a matrix with " + std::to_string(size) + " rows has not " +
                                std::to_string(count) + " eigenvalues");
  // a dense method is faster up to 96 rows; from there to 160 it takes 16 times as long
  constexpr Eigen::Index small = 64;
  if (count == 0) return {{}, Eigen::MatrixXd(size, 0), Status::done};
  if (is_zero_matrix(a)) return eigenpairs_of_zero(m, count);
  if (size <= std::max(small, 2 * count + 1))
    return smallest_of(is_laplacian(a) ? dense_laplacian_eigenpairs(a, m, count)
                                       : dense_eigenpairs(Eigen::MatrixXd(a), m),
                       count);
  // eigenvalues of about one: methods have thresholds without units
  const double root = std::exp2(std::round(std::log2(mean_eigenvalue(a, m)) / 2));
  if (!(root * root > 0x1p-1020 && root * root < 0x1p1020))
    throw std::invalid_argument("the matrices are of too different sizes; scale one of them");
  Solution_counter solutions(progress);
  try {
    Eigenpairs pairs = sparse_eigenpairs(a, root * root * m, count, solver, solutions);
    pairs.values *= root * root;
    pairs.vectors *= root;
    return pairs;
  } catch (const Cancelled_eigenpairs&) {
    return {{}, Eigen::MatrixXd(size, 0), Status::cancelled};
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal
#endif
