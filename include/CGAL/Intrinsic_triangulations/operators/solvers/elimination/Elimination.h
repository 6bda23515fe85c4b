// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_ELIMINATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_ELIMINATION_H

#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/row_number.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// In which order the rows of a symmetric matrix are eliminated, and where its factor has entries: of the pattern alone.
struct Elimination {
  // by approximate minimum degree \throws std::invalid_argument if the pattern is not symmetric
  explicit Elimination(const Eigen::SparseMatrix<double>& a);

  Eigen::Index number_of_entries; // of the matrix
  std::vector<int> row, place;    // at each place of the order, and of each row
  // Of the matrix, the entries after the diagonal at each place, in the order of the matrix: where they begin, their other places, and where the matrix has them.
  std::vector<int> later_begin, later, entry;
  // Where the entries of each column of the factor begin, below the diagonal.
  std::vector<int> column_begin;
  // Blocks of columns that end alike, each with the next one as its first entry: where they begin, and of each column.
  std::vector<int> block_begin, block;
  // The places of the entries of the first column of each block, ascending, which end with those of the others.
  std::vector<int> block_rows_begin, block_rows;

  // The blocks in the order of their elimination: each right after all that is below it, of which the child with most below comes first.
  std::vector<int> sequence;
  // Of each block, who computes it: one of two halves, which have nothing in common, or what comes after both. The same whether or not there are threads.
  enum Part : unsigned char { first_half, second_half, after_both };
  std::vector<Part> part;
  bool has_halves() const { return std::find(part.begin(), part.end(), second_half) != part.end(); }

  int count(int column) const {
    return column_begin[row_number(column + 1)] - column_begin[row_number(column)];
  }
  const int* rows_end(int of_block) const {
    return block_rows.data() + block_rows_begin[row_number(of_block + 1)];
  }
  // Whether it is that of a matrix, with entries in the same places.
  bool is_of(const Eigen::SparseMatrix<double>& a) const;
  // the block of the first row below, or -1
  int parent(int of_block) const {
    const int last = block_begin[row_number(of_block + 1)] - 1;
    return count(last) > 0 ? block[row_number(*rows(last))] : -1;
  }
  // the places of the entries of a column
  const int* rows(int column) const { return rows_end(block[row_number(column)]) - count(column); }

private:
  void find_later(const Eigen::SparseMatrix<double>& a);
  void find_blocks();
  void find_sequence();
  void find_parts();
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_ELIMINATION_H
