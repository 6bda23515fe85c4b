// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/editing/Surface_deformation.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

/*!
Functions d with given values in some rows and L M^-1 L d = 0 in the others, F. It avoids that
product, since doubles lose its small eigenvalues if weights span about eight orders of magnitude.

Let M w = L d. Then w is harmonic in F, so w = P w_B: the columns of P are harmonic, each one in its
row of B and zero in the others, where B are the fixed rows beside F. With w, L d = M w in F gives
d. The remaining equations M w = L d in B are

    (P^T M P) w_B = S d,    S = L_B + L_BF P

a dense, definite system with one row per row of B. P is not negative, the matrix has no
subtractions, and S applies to differences of d. So if L has no negative weights, errors are those
of the values.
*/
class Biharmonic_interpolation {
public:
  // \param laplacian its rows sum to zero \param mass the diagonal of M \param rows the fixed rows,
  // some in each component
  // \param beside `rows_beside_free_ones()`; takes the time and memory of that many solutions with
  // L
  // \throws Indefinite_matrix if rounding makes the matrix indefinite; it names a fixed row
  Biharmonic_interpolation(const Eigen::SparseMatrix<double>& laplacian, Eigen::VectorXd mass,
                           std::span<const std::uint32_t> rows, std::vector<std::uint32_t> beside,
                           Linear_solver solver);

  // \param values as of `Fixed_values_solver::solve()`
  Eigen::MatrixXd solve(const Eigen::MatrixXd& values) const;

private:
  void find_measures(std::span<const std::uint32_t> rows);
  void factor_strengths();
  Eigen::MatrixXd laplacian_beside(const Eigen::MatrixXd& harmonic) const;

  Eigen::VectorXd mass_;
  std::vector<std::uint32_t> beside_;
  std::vector<char> is_fixed_;
  Eigen::SparseMatrix<double> laplacian_;
  Fixed_values_solver harmonic_;
  Eigen::MatrixXd measures_, through_free_; // P and L_BF P
  Eigen::VectorXd unit_;                    // of each row of the dense system
  Eigen::LDLT<Eigen::MatrixXd> strengths_;
};

// The fixed rows with entries in free columns, without repetition.
static std::vector<std::uint32_t> rows_beside_free_ones(const Eigen::SparseMatrix<double>& a,
                                                        std::span<const std::uint32_t> fixed) {
  const std::vector<char> is_fixed = marked_rows(a.rows(), fixed);
  std::vector<std::uint32_t> beside;
  for (std::uint32_t r = 0; r < is_fixed.size(); ++r) {
    if (is_fixed[r] == 0) continue;
    for (Eigen::SparseMatrix<double>::InnerIterator i(a, static_cast<int>(r)); i; ++i)
      if (is_fixed[row_number(i.row())] == 0 && i.value() != 0) {
        beside.push_back(r);
        break;
      }
  }
  return beside;
}

Biharmonic_interpolation::Biharmonic_interpolation(const Eigen::SparseMatrix<double>& laplacian,
                                                   Eigen::VectorXd mass,
                                                   std::span<const std::uint32_t> rows,
                                                   std::vector<std::uint32_t> beside,
                                                   Linear_solver solver)
    : mass_(std::move(mass)), beside_(std::move(beside)),
      is_fixed_(marked_rows(laplacian.rows(), rows)), laplacian_(laplacian),
      harmonic_(laplacian, rows, solver) {
  find_measures(rows);
  factor_strengths();
}

void Biharmonic_interpolation::find_measures(std::span<const std::uint32_t> rows) {
  const auto count = static_cast<Eigen::Index>(beside_.size());
  std::vector<Eigen::Index> place(is_fixed_.size(), -1);
  for (Eigen::Index b = 0; b < count; ++b) place[beside_[row_number(b)]] = b;
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), count);
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (place[rows[i]] >= 0) values(static_cast<Eigen::Index>(i), place[rows[i]]) = 1;
  measures_ = harmonic_.solve(Eigen::MatrixXd::Zero(laplacian_.rows(), count), values);
  through_free_ = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index b = 0; b < count; ++b)
    for (Eigen::SparseMatrix<double>::InnerIterator i(laplacian_,
                                                      static_cast<int>(beside_[row_number(b)]));
         i; ++i)
      if (is_fixed_[row_number(i.row())] == 0)
        through_free_.row(b) += i.value() * measures_.row(i.row());
}

// Rows and columns are scaled to a diagonal of ones.
void Biharmonic_interpolation::factor_strengths() {
  if (beside_.empty()) return;
  Eigen::MatrixXd a = measures_.transpose() * mass_.asDiagonal() * measures_;
  unit_ = a.diagonal().cwiseSqrt().cwiseInverse();
  a = unit_.asDiagonal() * a * unit_.asDiagonal();
  strengths_.compute(a);
  Eigen::Index least = 0;
  // as for pivots of `Cholesky_factorization`
  if (strengths_.vectorD().minCoeff(&least) > 64 * std::numeric_limits<double>::epsilon()) return;
  Eigen::VectorXi order = Eigen::VectorXi::LinSpaced(a.rows(), 0, static_cast<int>(a.rows()) - 1);
  order = strengths_.transpositionsP() * order;
  throw Indefinite_matrix(
      beside_[row_number(order[least])],
      "the handle is too close to another handle for doubles; give one of them");
}

// L d in the rows beside free ones, for the harmonic function d, from differences.
Eigen::MatrixXd Biharmonic_interpolation::laplacian_beside(const Eigen::MatrixXd& harmonic) const {
  const auto count = static_cast<Eigen::Index>(beside_.size());
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(count, harmonic.cols());
  for (Eigen::Index b = 0; b < count; ++b) {
    const auto row = static_cast<Eigen::Index>(beside_[row_number(b)]);
    for (Eigen::Index k = 0; k < count; ++k)
      result.row(b) +=
          through_free_(b, k) *
          (harmonic.row(static_cast<Eigen::Index>(beside_[row_number(k)])) - harmonic.row(row));
    for (Eigen::SparseMatrix<double>::InnerIterator i(laplacian_, static_cast<int>(row)); i; ++i)
      if (is_fixed_[row_number(i.row())] != 0 && i.row() != row)
        result.row(b) += i.value() * (harmonic.row(i.row()) - harmonic.row(row));
  }
  return result;
}

Eigen::MatrixXd Biharmonic_interpolation::solve(const Eigen::MatrixXd& values) const {
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(laplacian_.rows(), values.cols());
  const Eigen::MatrixXd harmonic = harmonic_.solve(zero, values);
  if (beside_.empty()) return harmonic;
  const Eigen::MatrixXd right = unit_.asDiagonal() * laplacian_beside(harmonic);
  const Eigen::MatrixXd w = unit_.asDiagonal() * Eigen::MatrixXd(strengths_.solve(right));
  return harmonic_.solve(mass_.asDiagonal() * Eigen::MatrixXd(measures_ * w), values);
}

// L M^-1 L; isolated vertices have no mass and are fixed
static Eigen::SparseMatrix<double> bilaplacian(const Eigen::SparseMatrix<double>& l,
                                               const Eigen::VectorXd& mass) {
  Eigen::VectorXd inverse(mass.size());
  for (Eigen::Index i = 0; i < mass.size(); ++i) inverse[i] = mass[i] > 0 ? 1 / mass[i] : 0;
  return l * inverse.asDiagonal() * l;
}

[[noreturn]] static void refuse_to_iterate(bool is_laplacian, std::size_t few) {
  throw std::invalid_argument(
      "the square of the Laplacian, which biharmonic deformations " +
      (is_laplacian ? "by more than " + std::to_string(few) + " handles beside free vertices"
                    : std::string("of vertices without a mass, or by rows with a sum")) +
      " need, is too near to singular to iterate; take a direct solver, the harmonic energy, or " +
      (is_laplacian ? "fewer handles" : "make the triangulation Delaunay"));
}

// whether rows that are not handles, and have neighbours, have masses
static bool all_free_have_mass(const Eigen::SparseMatrix<double>& laplacian,
                               const Eigen::VectorXd& mass,
                               std::span<const std::uint32_t> handles) {
  const std::vector<char> needs_none = marked_rows(mass.size(), handles);
  for (Eigen::Index r = 0; r < mass.size(); ++r)
    if (mass[r] == 0 && needs_none[static_cast<std::size_t>(r)] == 0 &&
        laplacian.outerIndexPtr()[r + 1] - laplacian.outerIndexPtr()[r] > 1)
      return false;
  return true;
}

} // namespace internal

Surface_deformation::Surface_deformation(const Eigen::SparseMatrix<double>& laplacian,
                                         const Eigen::VectorXd& mass,
                                         std::span<const std::uint32_t> handles,
                                         Deformation_energy energy, Linear_solver solver,
                                         const std::function<bool(Deformation_step)>& progress)
    : rows_(handles.begin(), handles.end()), handles_(handles.size()), size_(laplacian.rows()) {
  if (mass.size() != size_)
    throw std::invalid_argument("there must be a mass per row of the Laplacian");
  if (!mass.allFinite() || !(mass.array() >= 0).all())
    throw std::invalid_argument("masses must be finite and not negative");
  status_ = Status::cancelled; // until all is done
  if (!progress(Deformation_step::matrices)) return;
  const std::vector<std::uint32_t> component = components_of_matrix(laplacian);
  const std::vector<char> is_handle = internal::marked_rows(size_, handles);
  const std::vector<char> has_none = internal::components_where_all(
      component, [&](Eigen::Index r) { return is_handle[internal::row_number(r)] == 0; });
  for (std::uint32_t r = 0; r < is_handle.size(); ++r)
    if (has_none[component[r]] != 0) rows_.push_back(r);
  if (energy == Deformation_energy::harmonic)
    solver_.emplace(laplacian, rows_, solver);
  else
    factor_biharmonic(laplacian, mass, solver);
  if (progress(Deformation_step::factored)) status_ = Status::done;
}

// By handles if that is faster; also if the matrix is not definite and memory suffices.
void Surface_deformation::factor_biharmonic(const Eigen::SparseMatrix<double>& laplacian,
                                            const Eigen::VectorXd& mass, Linear_solver solver) {
  // Both ways take as long for 64 handles on 2,800 and on 10,000 vertices, for 128 on 38,000; 2000
  // handles take 8 seconds on 10,000 vertices, 28 on 38,000.
  constexpr std::size_t few = 64, many = 2000;
  constexpr std::size_t numbers = 100000000; // by handles and rows: 800 MB
  std::vector<std::uint32_t> beside = internal::rows_beside_free_ones(laplacian, rows_);
  // the product leaves out rows without mass, which should be harmonic
  const bool is_laplacian =
      internal::is_laplacian(laplacian) && internal::all_free_have_mass(laplacian, mass, rows_);
  const auto by_handles = [&] { // the unit of masses is that of the energy alone
    const double greatest = size_ > 0 ? mass.maxCoeff() : 0;
    const double unit = greatest > 0 ? std::ldexp(1., -std::ilogb(greatest)) : 1;
    by_handles_ = std::make_shared<const internal::Biharmonic_interpolation>(
        laplacian, unit * mass, rows_, std::move(beside), solver);
  };
  if (is_laplacian && beside.size() <= few) return by_handles();
  if (solver == Linear_solver::iterative) internal::refuse_to_iterate(is_laplacian, few);
  try {
    solver_.emplace(internal::bilaplacian(laplacian, mass), rows_, Linear_solver::direct);
  } catch (const Indefinite_matrix& error) {
    if (!is_laplacian || beside.size() > many ||
        beside.size() > numbers / static_cast<std::size_t>(size_))
      throw Indefinite_matrix(error.row(), "faces there are too different in size for so many "
                                           "handles; give fewer, or take the harmonic energy");
    by_handles();
  }
}

Eigen::MatrixXd Surface_deformation::displacements(const Eigen::MatrixXd& displacements) const {
  if (status_ != Status::done) throw std::logic_error("the deformation was stopped; construct it");
  if (displacements.rows() != static_cast<Eigen::Index>(handles_))
    throw std::invalid_argument(
        "there must be a displacement per handle: " + std::to_string(handles_) + ", not " +
        std::to_string(displacements.rows()));
  Eigen::MatrixXd values =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows_.size()), displacements.cols());
  values.topRows(displacements.rows()) = displacements;
  if (by_handles_) return by_handles_->solve(values);
  return solver_->solve(Eigen::MatrixXd::Zero(size_, displacements.cols()), values);
}

} // namespace CGAL::Intrinsic_triangulations
