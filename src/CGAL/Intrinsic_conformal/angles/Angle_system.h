// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_ANGLES_ANGLE_SYSTEM_H
#define CGAL_INTRINSIC_CONFORMAL_ANGLES_ANGLE_SYSTEM_H

#include <CGAL/Intrinsic_conformal/angles/Ideal_surface.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The sums of the angles of triangles as functions of u at rows, and their derivative. The sides of
// Euclidean triangles are the scaled lambdas; the derivative is minus the cotangent Laplacian
// (Springborn 2020), which does not see constants. Hyperbolic ones have lambda = 2 sinh(l/2) in the
// units of the user; the derivative is negative definite (Bobenko, Pinkall, Springborn 2015).
class Angle_system {
public:
  // \param is_fixed for each row, whether u is fixed there
  Angle_system(const Ideal_components& components, const std::vector<char>& is_fixed,
               Geometry geometry = Geometry::euclidean);

  // Takes faces in place of those before.
  // \param unit by which lambdas are multiplied in hyperbolic triangles
  void read(const std::vector<Ideal_face>& faces, double unit = 1);
  // the sum of angles at each row
  const Eigen::VectorXd& angle_sums() const { return sums_; }
  // the sum of the weights of edges at each row, without their signs
  Eigen::VectorXd weights() const;

  // Solves `L x = b` with minus the derivative at the faces. x is zero where it is fixed, and in
  // flat components where it is fixed nowhere it has mean zero.
  // \pre b is zero where x is fixed, and has the mean zero up to rounding in such components
  Eigen::VectorXd solve(Eigen::VectorXd b);
  // Subtracts its mean from x in flat components where nothing is fixed.
  void centre(Eigen::VectorXd& x) const;

private:
  static constexpr int fixed = -1;
  // A sum of weights, and that of the weights without their signs.
  struct Weight {
    double sum, size;
    Weight& operator+=(const Weight& other);
  };
  struct Weighted_edge {
    int i = fixed, j = fixed; // rows; without weight if they are one
    Weight value{0, 0};
  };

  void factor();
  Eigen::SparseMatrix<double> matrix(Eigen::VectorXd& diagonal) const;
  bool has_same_pattern(const Eigen::SparseMatrix<double>& m) const;
  void analyze(const Eigen::SparseMatrix<double>& m);

  const Ideal_components& components_;
  Geometry geometry_;
  std::vector<char> is_pinned_; // per component: nothing is fixed but one row of ours
  std::vector<int> unknown_;    // of each row
  int number_of_unknowns_ = 0;
  Eigen::VectorXd sums_, excess_;    // at rows
  std::vector<Weighted_edge> edges_; // by their numbers
  Eigen::SparseMatrix<double> last_; // whose analysis we have
  Shared_analysis analysis_;
  std::optional<Laplacian_factorization> factor_; // of the faces, once it was needed
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_CONFORMAL_ANGLES_ANGLE_SYSTEM_H
