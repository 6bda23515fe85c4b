// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/matrix_market.h>
#include <CGAL/Intrinsic_operators/operators/reaction_diffusion.h>
#include <CGAL/Intrinsic_operators/operators/residual_indicators.h>
#include <CGAL/Intrinsic_operators/operators/transfer.h>
#include <CGAL/Intrinsic_triangulation.h>

#include <cmath>
#include <utility>
#include <vector>

// The border of a tetrahedron with edges of length 2: every weight is 2 cot(60 degrees) / 2.
bool check_operators() {
  namespace IT = CGAL::Intrinsic_triangulations;
  IT::Gluing gluing;
  gluing.number_of_vertices = 4;
  gluing.origin = {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0};
  gluing.glue = {5, 8, 11, 10, 6, 0, 4, 9, 1, 7, 3, 2};
  IT::Intrinsic_input input(IT::Gluing_map(gluing), std::vector<double>(6, 4));
  IT::Intrinsic_triangulation<> t(std::move(input));
  const Eigen::SparseMatrix<double> laplacian = IT::cotangent_laplacian(t);
  const Eigen::SparseMatrix<double> mass = IT::lumped_mass_matrix(t);
  const double weight = 1 / std::sqrt(3.), area = 4 * std::sqrt(3.);
  return std::abs(laplacian.coeff(0, 1) + weight) < 1e-14 &&
         std::abs(laplacian.coeff(0, 0) - 3 * weight) < 1e-14 &&
         std::abs(mass.sum() - area) < 1e-13;
}
