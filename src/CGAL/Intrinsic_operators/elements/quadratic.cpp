// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/elements/crouzeix_raviart.h>
#include <CGAL/Intrinsic_operators/elements/quadratic.h>
#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_operators/operators/symmetric_assembly.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Six by six: corners 0, 1, 2, then the midpoints of the sides opposite to them.
using Quadratic_block = Eigen::Matrix<double, 6, 6>;

/*
With barycentric coordinates b_k, the functions are b_k (2 b_k - 1) at corners and 4 b_i b_j at the
side opposite corner k. The integrals of their gradients are multiples of S_ij, those of grad b_i
grad b_j: S_ij = -cot_k / 2, and rows of S have sum zero.
*/
static Quadratic_block quadratic_stiffness(const Table_face& f) {
  const std::array<double, 3> half = checked_half_cotangents(f); // at the corner opposite side k
  Quadratic_block block = Quadratic_block::Zero();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Eigen::Index i = (k + 1) % 3, j = (k + 2) % 3;
    // side i of a face runs from corner i to corner j, opposite to corner k
    const double s = -half[static_cast<std::size_t>(i)];
    block(i, j) = block(j, i) = -s / 3;
    block(i, 3 + k) = block(3 + k, i) = block(j, 3 + k) = block(3 + k, j) = 4 * s / 3;
    block(3 + i, 3 + j) = block(3 + j, 3 + i) = 8 * s / 3;
    block(i, i) -= s;
    block(j, j) -= s;
    for (const Eigen::Index m : {Eigen::Index{3}, Eigen::Index{4}, Eigen::Index{5}})
      block(m, m) -= 8 * s / 3;
  }
  return block;
}

static Quadratic_block quadratic_mass(const Table_face& f) {
  Quadratic_block block;
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index j = 0; j < 3; ++j) {
      block(i, j) = i == j ? 6 : -1;
      block(3 + i, 3 + j) = i == j ? 32 : 16;
      block(i, 3 + j) = block(3 + j, i) = i == j ? -4 : 0;
    }
  return block * (f.area() / 180);
}

// Rows of the functions of a face: corners, then the sides opposite to them.
static std::array<int, 6> quadratic_rows(const Face_table& table, const Table_face& f) {
  std::array<int, 6> rows{};
  for (std::size_t k = 0; k < 3; ++k) {
    rows[k] = f.rows[k];
    rows[3 + k] =
        static_cast<int>(table.number_of_rows + f.halfedges[(k + 1) % 3] / 2); // opposite corner k
  }
  return rows;
}

template <class Block>
static Eigen::SparseMatrix<double> quadratic_matrix(const Face_table& table, double factor,
                                                    const Block& block_of) {
  const std::uint64_t size = table.number_of_rows + std::uint64_t{table.number_of_edges};
  expect_countable(size + 30 * std::uint64_t{table.faces.size()}, "the matrix has many entries");
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(size));
  std::vector<Symmetric_entry> entries;
  entries.reserve(15 * table.faces.size());
  for (const Table_face& f : table.faces) {
    const Quadratic_block block = block_of(f) * factor;
    const std::array<int, 6> rows = quadratic_rows(table, f);
    for (std::size_t i = 0; i < 6; ++i) {
      const auto r = static_cast<Eigen::Index>(i);
      diagonal[rows[i]] += block(r, r);
      for (std::size_t j = i + 1; j < 6; ++j) {
        const double value = block(r, static_cast<Eigen::Index>(j));
        if (rows[i] == rows[j])
          diagonal[rows[i]] += 2 * value; // a vertex at two corners, an edge on two sides
        else if (value != 0)
          entries.push_back({rows[i], rows[j], value});
      }
    }
  }
  return symmetric_matrix(entries, diagonal);
}

Eigen::SparseMatrix<double> quadratic_laplacian(const Face_table& table, double factor) {
  return quadratic_matrix(table, factor, quadratic_stiffness);
}

Eigen::SparseMatrix<double> quadratic_mass_matrix(const Face_table& table, double factor) {
  return quadratic_matrix(table, factor, quadratic_mass);
}

} // namespace CGAL::Intrinsic_triangulations::internal
