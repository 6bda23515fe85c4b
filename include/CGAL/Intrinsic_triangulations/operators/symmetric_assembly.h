// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SYMMETRIC_ASSEMBLY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SYMMETRIC_ASSEMBLY_H

#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/row_number.h>
#include <CGAL/Intrinsic_triangulations/triangulation/MeasuredTriangulation.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds an entry of a symmetric matrix off the diagonal; it stands for (i, j) and (j, i).
*/
struct Symmetric_entry {
  int i;        ///< a row and column
  int j;        ///< another row and column, not `i`
  double value; ///< the entry
};

namespace internal {

// The strict lower triangle of a symmetric matrix, by columns. Rows within a column are sorted without
// comparing: entries are bucketed by row, and then by column, in order.
class Lower_triangle {
public:
  Lower_triangle(const std::vector<Symmetric_entry>& entries, int size)
      : start_(row_number(size) + 1, 0), below_(row_number(size), 0), left_(row_number(size), 0),
        row_(entries.size()), value_(entries.size()) {
    for (const Symmetric_entry& e : entries) {
      ++below_[row_number(std::min(e.i, e.j))];
      ++left_[row_number(std::max(e.i, e.j))];
    }
    std::partial_sum(below_.begin(), below_.end(), start_.begin() + 1);
    std::fill(below_.begin(), below_.end(), 0);
    for (const Symmetric_entry& e : sorted_by_row(entries)) append(e);
  }

  // writes both triangles and the diagonal
  Eigen::SparseMatrix<double> mirrored(const Eigen::VectorXd& diagonal) {
    const int size = static_cast<int>(below_.size());
    Eigen::SparseMatrix<double> m(size, size);
    int* const outer = m.outerIndexPtr();
    for (std::size_t c = 0; c < below_.size(); ++c)
      outer[c + 1] = outer[c] + left_[c] + 1 + below_[c];
    m.resizeNonZeros(outer[size]);
    int* const inner = m.innerIndexPtr();
    double* const value = m.valuePtr();
    std::copy(outer, outer + size, left_.begin()); // now: where the next row of a column goes
    for (int c = 0; c < size; ++c) {
      int& to = left_[row_number(c)];
      inner[to] = c;
      value[to++] = diagonal[c];
      std::size_t from = row_number(start_[row_number(c)]);
      for (const int end = to + below_[row_number(c)]; to < end; ++to, ++from) {
        inner[to] = row_[from];
        value[to] = value_[from];
        const int mirror = left_[row_number(row_[from])]++;
        inner[mirror] = c;
        value[mirror] = value_[from];
      }
    }
    return m;
  }

private:
  std::vector<Symmetric_entry> sorted_by_row(const std::vector<Symmetric_entry>& entries) const {
    std::vector<int> next(left_.size());
    std::exclusive_scan(left_.begin(), left_.end(), next.begin(), 0);
    std::vector<Symmetric_entry> sorted(entries.size());
    for (const Symmetric_entry& e : entries)
      sorted[row_number(next[row_number(std::max(e.i, e.j))]++)] = e;
    return sorted;
  }

  void append(const Symmetric_entry& e) {
    const int row = std::max(e.i, e.j);
    int& count = below_[row_number(std::min(e.i, e.j))];
    const std::size_t end = row_number(start_[row_number(std::min(e.i, e.j))] + count);
    if (count > 0 && row_[end - 1] == row) {
      value_[end - 1] += e.value;
      --left_[row_number(row)];
      return;
    }
    row_[end] = row;
    value_[end] = e.value;
    ++count;
  }

  std::vector<int> start_; // of each column, which may leave gaps before the next
  std::vector<int> below_; // number of entries below the diagonal of each column
  std::vector<int> left_;  // number of entries left of the diagonal of each row
  std::vector<int> row_;
  std::vector<double> value_;
};

} // namespace internal

/*!
\brief assembles a symmetric sparse matrix whose diagonal is stored in every row, zeros included.

Equal pairs add up, in the order given. The matrix is symmetric bit by bit.
\param entries entries off the diagonal
\param diagonal those on it
\return the matrix, compressed
\pre `0 <= i, j < diagonal.size()` and `i != j` for every entry
\complexity linear in size and number of entries
*/
inline Eigen::SparseMatrix<double> symmetric_matrix(const std::vector<Symmetric_entry>& entries,
                                                    const Eigen::VectorXd& diagonal) {
  return internal::Lower_triangle(entries, static_cast<int>(diagonal.size())).mirrored(diagonal);
}

namespace internal {

// throws Invalid_input if a number exceeds what the index type of `Eigen::SparseMatrix` can count
inline void expect_countable(std::uint64_t number, const std::string& has) {
  if (number > static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
    throw Invalid_input(Element_kind::none, 0,
                        has + ", more than Eigen's index type can count; split the mesh");
}

} // namespace internal

/*!
\brief checks that the numbers of rows and of entries fit the index type of `Eigen::SparseMatrix`.

Vertices that have been removed have a row too, until their number is taken again.
\return the number of rows
\throws Invalid_input if they do not
*/
template <MeasuredTriangulation Triangulation>
int checked_matrix_size(const Triangulation& t) {
  const std::uint64_t rows = t.number_of_vertices(),
                      entries = rows + 2 * std::uint64_t{t.numbers().edge_capacity(t.mesh())};
  internal::expect_countable(entries,
                             "a matrix of the mesh has " + std::to_string(entries) + " entries");
  return static_cast<int>(rows);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SYMMETRIC_ASSEMBLY_H
