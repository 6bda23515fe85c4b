// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_EDITING_BIHARMONIC_INTERPOLATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_EDITING_BIHARMONIC_INTERPOLATION_H

#include <CGAL/Intrinsic_triangulations/operators/solvers/Fixed_values_solver.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The fixed rows that a matrix joins with free ones, without repetition.
std::vector<std::uint32_t> rows_beside_free_ones(const Eigen::SparseMatrix<double>& a,
                                                 std::span<const std::uint32_t> fixed);

/*!
Functions d with given values in some rows and L M^-1 L d = 0 in the others, F, without that product, of which no double holds the small eigenvalues once
weights span eight orders of magnitude or so.

Let M w = L d. Then w is harmonic in F, and so P w_B: of the values in the fixed rows B beside F, with the harmonic measures P, one in its row of B and zero in the others; and
where w is known so is d, from L d = M w in F. What is left is M w = L d in B,

    (P^T M P) w_B = S d,    S = L_B + L_BF P

a dense system, definite and of one row per row of B. Measures are not negative and nothing is subtracted in its matrix; S is applied to differences of d. So errors are
those of the values, where L has no negative weights.
*/
class Biharmonic_interpolation {
public:
  // \param laplacian its rows sum to zero \param mass the diagonal of M \param rows the fixed rows, some in each component
  // \param beside `rows_beside_free_ones()`; time and memory for that many solutions with L are needed
  // \throws Indefinite_matrix if rounding has left no definite matrix; it names a fixed row
  Biharmonic_interpolation(const Eigen::SparseMatrix<double>& laplacian, Eigen::VectorXd mass,
                           std::span<const std::uint32_t> rows, std::vector<std::uint32_t> beside);

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

} // namespace CGAL::Intrinsic_triangulations::internal

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/applications/editing/Biharmonic_interpolation_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_EDITING_BIHARMONIC_INTERPOLATION_H
