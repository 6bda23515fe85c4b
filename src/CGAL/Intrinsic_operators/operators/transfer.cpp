// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/transfer.h>
#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

void L2_transfer::keep_values_without_area(const Common_subdivision& s, bool back) {
  std::vector<Eigen::Triplet<double>> ones, copies;
  const Eigen::VectorXd diagonal = mass_.diagonal();
  for (const Common_subdivision::Vertex& v : s.vertices) {
    const auto i = static_cast<int>(v.intrinsic);
    if (i >= mass_.rows() || diagonal[i] != 0) continue;
    if (back)
      copies.emplace_back(i, i, 1);
    else
      for (std::size_t k = 0; k < v.on_input.size; ++k)
        copies.emplace_back(i, static_cast<int>(v.on_input.vertices[k]), v.on_input.weights[k]);
  }
  for (int i = 0; i < mass_.rows(); ++i)
    if (diagonal[i] == 0) ones.emplace_back(i, i, 1);
  if (ones.empty()) return;
  mass_ += internal::matrix_of(mass_.rows(), mass_.cols(), ones);
  cross_ += internal::matrix_of(cross_.rows(), cross_.cols(), copies);
}

// Off the diagonal the mass matrix is that of a Laplacian with negative weights; sums of its rows
// are the rest, twice the diagonal. By the eigenvalues, pivots are at least half the diagonal:
// subtractions cancel little, and solutions are as accurate as by Cholesky's method.
void L2_transfer::factor() {
  mass_.makeCompressed();
  try {
    solver_.emplace(mass_, mass_ * Eigen::VectorXd::Ones(mass_.cols()));
  } catch (const Indefinite_matrix& error) {
    throw Indefinite_matrix(error.row(), "areas at that vertex are as small as rounding errors");
  }
}

} // namespace CGAL::Intrinsic_triangulations
