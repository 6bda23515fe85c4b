// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_EIGENPAIRS_INVERSE_LANCZOS_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_EIGENPAIRS_INVERSE_LANCZOS_H

#include <CGAL/Intrinsic_operators/solvers/Chosen_factorization.h>

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The eigenvectors of A z = lambda M z with the smallest eigenvalues, one for each part of a
// definite Hermitian matrix A: entries of A connect no two parts. It applies the method of Lanczos
// to the inverse of A in all parts at once, independently in each. `smallest_eigenpairs()` finds
// several eigenvectors of a real matrix, all parts together.
class Inverse_lanczos {
  using Complex = std::complex<double>;

public:
  // \param factor A, factored
  // \param masses the diagonal of M, not negative
  // \param part the row that represents the part of each row
  // \param known columns, orthonormal by M in each part; eigenvectors are orthogonal to them
  Inverse_lanczos(Chosen_factorization<Complex> factor, Eigen::VectorXd masses,
                  std::vector<std::uint32_t> part, Eigen::MatrixXcd known = {});

  // \param start any vector, zero in parts that are left out; in rows without mass it solves
  //   A z = M x for some x
  // \param progress returns whether to go on, after each solution
  // \return eigenvectors of length one by M; empty if cancelled
  Eigen::VectorXcd smallest(const Eigen::VectorXcd& start,
                            const std::function<bool()>& progress) const;

private:
  bool improve(Eigen::VectorXcd& z, const std::function<bool()>& progress) const;
  bool combine(const Eigen::MatrixXcd& basis, const Eigen::MatrixXd& diagonal,
               const Eigen::MatrixXd& beside, Eigen::VectorXcd& z) const;
  Eigen::Index part(Eigen::Index i) const {
    return static_cast<Eigen::Index>(part_[static_cast<std::size_t>(i)]);
  }
  Eigen::VectorXcd remove(const Eigen::Ref<const Eigen::VectorXcd>& unit,
                          Eigen::VectorXcd& from) const;
  Eigen::VectorXd norms(const Eigen::VectorXcd& x) const;
  void divide(Eigen::Ref<Eigen::VectorXcd> x, const Eigen::VectorXd& norm) const;

  Chosen_factorization<Complex> factor_;
  Eigen::VectorXd masses_;
  std::vector<std::uint32_t> part_;
  Eigen::MatrixXcd known_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_EIGENPAIRS_INVERSE_LANCZOS_H
