// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_DENSE_PRODUCT_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_DENSE_PRODUCT_H

#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The lower triangle of a product of a matrix and the transpose of another one, both with few
// columns. Copies of both are in the order in which tiles of the product read them.
class Dense_product {
public:
  static constexpr int rows = 8, columns = 4; // of a tile, whose sums are in registers
  using Tile = Eigen::Array<double, rows, columns>;

  // \param size the number of rows of both matrices \param depth that of their columns
  void resize(int size, int depth) {
    size_ = size;
    depth_ = depth;
    left_.assign(row_number(round_up(size, rows)) * row_number(depth), 0);
    right_.assign(row_number(round_up(size, columns)) * row_number(depth), 0);
  }
  double& left(int i, int k) { return left_[place<rows>(i, k)]; }
  double& right(int i, int k) { return right_[place<columns>(i, k)]; }

  // Calls `add` with the first row and column of each tile, and the tile. It may reach beyond the
  // product, and above its diagonal.
  template <class Add>
  void for_each_tile(const Add& add) const {
    constexpr int block = 12 * rows; // rows that stay in the cache of the first level, or near it
    Tile sums;
    for (int begin = 0; begin < size_; begin += block) {
      const int end = std::min(begin + block, size_);
      for (int c = 0; c < end; c += columns)
        for (int i = std::max(begin, c / rows * rows); i < end; i += rows) {
          multiply(&left_[place<rows>(i, 0)], &right_[place<columns>(c, 0)], depth_, sums.data());
          add(i, c, sums);
        }
    }
  }

private:
  static int round_up(int n, int unit) { return (n + unit - 1) / unit * unit; }
  template <int height>
  std::size_t place(int i, int k) const {
    return (row_number(i / height) * row_number(depth_) + row_number(k)) * height +
           row_number(i % height);
  }
  static void multiply(const double* left, const double* right, int depth, double* sums);

  int size_ = 0, depth_ = 0;
  std::vector<double> left_, right_; // by tiles, these by columns
};

// Products of a few columns of a matrix, which lie apart, and a vector.
struct Dense_panel {
  static constexpr std::size_t columns = 4;
  using Columns = std::array<const double*, columns>;

  // Adds the columns times factors to a vector.
  static void add(const Columns& column, const double* factor, std::ptrdiff_t rows, double* to);
  // Adds the products of columns and a vector, row by row, to four sums of each column in turn.
  // \return how many rows it has added, all but less than four
  static std::ptrdiff_t sum(const Columns& column, const double* vector, std::ptrdiff_t rows,
                            double* sums);
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_DENSE_PRODUCT_H
