// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_OPERATORS_SYMMETRIC_ASSEMBLY_H
#define CGAL_INTRINSIC_OPERATORS_OPERATORS_SYMMETRIC_ASSEMBLY_H

#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
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

// The same for Hermitian matrices: it stands for (i, j), and its conjugate for (j, i).
struct Hermitian_entry {
  int i, j;
  std::complex<double> value;
};

template <class Number>
Number conjugate(const Number& x) {
  return x;
}
inline std::complex<double> conjugate(const std::complex<double>& x) { return std::conj(x); }

// Assembles a symmetric or Hermitian matrix in its own memory: a list of entries would take more
// than the matrix. Entries are counted by columns, added in their order, and sorted there.
template <class Number = double>
class Symmetric_columns {
public:
  // \param for_each_pair calls a function with the row and the column of each entry that will be
  // added, or may be
  template <class For_each_pair>
  Symmetric_columns(int size, const For_each_pair& for_each_pair)
      : matrix_(size, size), end_(row_number(size)) {
    int* const first = matrix_.outerIndexPtr(); // of each column
    for_each_pair([first](int i, int j) {
      ++first[i + 1];
      ++first[j + 1];
    });
    for (int c = 0; c < size; ++c) first[c + 1] += first[c] + 1; // with the diagonal
    std::copy(first, first + size, end_.begin());
    matrix_.resizeNonZeros(first[size]);
  }

  // Adds given entries.
  template <class Given>
  Symmetric_columns(const std::vector<Given>& entries, int size)
      : Symmetric_columns(size, [&](const auto& count) {
          for (const Given& e : entries) count(e.i, e.j);
        }) {
    for (const Given& e : entries) add(e.i, e.j, e.value);
  }

  Symmetric_columns(const Symmetric_columns&) = delete; // it may be large
  Symmetric_columns& operator=(const Symmetric_columns&) = delete;

  // Adds an entry, which stands for (i, j), and its conjugate for (j, i).
  void add(int i, int j, const Number& value) {
    append(i, j, conjugate(value));
    append(j, i, value);
  }

  // Completes the matrix, of the type of the result of `entry`.
  // \param diagonal takes a column and the values of its entries, sorted by rows; returns the entry
  // on the diagonal
  // \param entry takes the sum of equal entries; returns that of the matrix
  template <class Diagonal, class Value = std::identity>
  auto matrix(const Diagonal& diagonal, const Value& entry = {}) {
    using Scalar = std::decay_t<std::invoke_result_t<Value, const Number&>>;
    int* const first = matrix_.outerIndexPtr();
    int count = 0;
    for (int c = 0; c < matrix_.cols(); ++c) {
      const int begin = std::exchange(first[c], count);
      int end = merge(begin, end_[row_number(c)]);
      const Number on_diagonal(
          diagonal(c, std::span(values() + begin, static_cast<std::size_t>(end - begin))));
      insert(begin, end++, c, on_diagonal);
      if (begin != count) {
        std::copy(rows() + begin, rows() + end, rows() + count);
        std::copy(values() + begin, values() + end, values() + count);
      }
      count += end - begin;
    }
    first[matrix_.cols()] = count;
    matrix_.resizeNonZeros(count);
    Eigen::SparseMatrix<Scalar> result; // Eigen copies what is moved
    if constexpr (std::is_same_v<Scalar, Number>)
      result.swap(matrix_);
    else
      convert(entry, result);
    return result;
  }

private:
  struct Entry {
    int row;
    Number value;
  };

  int* rows() { return matrix_.innerIndexPtr(); }
  Number* values() { return matrix_.valuePtr(); }

  void append(int column, int row, const Number& value) {
    const int to = end_[row_number(column)]++;
    rows()[to] = row;
    values()[to] = value;
  }

  // Inserts an entry among those from `begin` to `end`, whose rows ascend, after those of its row.
  void insert(int begin, int end, int row, const Number& value) {
    int to = end;
    for (; to != begin && row < rows()[to - 1]; --to) {
      rows()[to] = rows()[to - 1];
      values()[to] = values()[to - 1];
    }
    rows()[to] = row;
    values()[to] = value;
  }

  // Sorts entries by rows, those of the same row in their order.
  void sort(int begin, int end) {
    // up to there, insertion takes 0.4 to 0.7 of the time (measured), which grows with the square
    constexpr int few = 24;
    if (end - begin <= few) {
      for (int i = begin; i != end; ++i) insert(begin, i, rows()[i], Number(values()[i]));
      return;
    }
    std::vector<Entry> entries;
    for (int i = begin; i != end; ++i) entries.push_back({rows()[i], values()[i]});
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return a.row < b.row; });
    for (const Entry& e : entries) {
      rows()[begin] = e.row;
      values()[begin++] = e.value;
    }
  }

  // Sorts entries by rows and adds up those of the same row, in their order. \return the end of the
  // result
  int merge(int begin, int end) {
    sort(begin, end);
    int last = begin;
    for (int i = begin; i != end; ++i)
      if (last != begin && rows()[last - 1] == rows()[i]) {
        values()[last - 1] += values()[i];
      } else {
        rows()[last] = rows()[i];
        values()[last++] = values()[i];
      }
    return last;
  }

  // Sets a matrix to the values of a function of entries.
  template <class Scalar, class Value>
  void convert(const Value& entry, Eigen::SparseMatrix<Scalar>& m) {
    m.resize(matrix_.rows(), matrix_.cols());
    m.resizeNonZeros(matrix_.nonZeros());
    std::copy(matrix_.outerIndexPtr(), matrix_.outerIndexPtr() + matrix_.cols() + 1,
              m.outerIndexPtr());
    std::copy(rows(), rows() + matrix_.nonZeros(), m.innerIndexPtr());
    std::transform(values(), values() + matrix_.nonZeros(), m.valuePtr(), entry);
  }

  Eigen::SparseMatrix<Number> matrix_; // columns with room, until it is complete
  std::vector<int> end_;               // of each column
};

} // namespace internal

/*!
\brief assembles a symmetric sparse matrix whose diagonal is stored in every row, zeros included.

Equal pairs add up, in the order given. The matrix is symmetric bit by bit.
\param entries entries off the diagonal
\param diagonal those on it
\return the matrix, compressed
\pre `0 <= i, j < diagonal.size()` and `i != j` for every entry
\complexity linear in size and number of entries, except n log n for n entries of a row
*/
Eigen::SparseMatrix<double> symmetric_matrix(const std::vector<Symmetric_entry>& entries,
                                             const Eigen::VectorXd& diagonal);

namespace internal {

// The same for a Hermitian matrix.
Eigen::SparseMatrix<std::complex<double>>
hermitian_matrix(const std::vector<Hermitian_entry>& entries, const Eigen::VectorXd& diagonal);

// throws Invalid_input if a number exceeds what the index type of `Eigen::SparseMatrix` can count
void expect_countable(std::uint64_t number, const std::string& has);

} // namespace internal

/*!
\brief checks that the numbers of rows and of entries fit the index type of `Eigen::SparseMatrix`.

Removed vertices keep a row until their number is used again.
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

#endif // CGAL_INTRINSIC_OPERATORS_OPERATORS_SYMMETRIC_ASSEMBLY_H
