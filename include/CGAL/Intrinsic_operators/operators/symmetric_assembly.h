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
#include <limits>
#include <numeric>
#include <string>
#include <type_traits>
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

// The columns of a symmetric or Hermitian matrix without its diagonal: entries are bucketed by
// column, in the order given, and sorted there.
template <class Number = double>
class Symmetric_columns {
public:
  struct Entry {
    int row;
    Number value;
  };

  template <class Given>
  Symmetric_columns(const std::vector<Given>& entries, int size)
      : end_(row_number(size) + 1, 0), entries_(2 * entries.size()) {
    for (const Given& e : entries) {
      ++end_[row_number(e.i) + 1];
      ++end_[row_number(e.j) + 1];
    }
    std::partial_sum(end_.begin(), end_.end(), end_.begin());
    for (const Given& e : entries) {
      entries_[end_[row_number(e.i)]++] = {e.j, conjugate(e.value)};
      entries_[end_[row_number(e.j)]++] = {e.i, e.value};
    }
  }

  // \param diagonal takes a column and the iterator range of its sorted entries; returns the
  // diagonal entry
  // \param entry takes the sum of equal entries; returns that of the matrix
  template <class Diagonal, class Value = std::identity>
  auto matrix(const Diagonal& diagonal, const Value& entry = {}) {
    using Scalar = std::decay_t<std::invoke_result_t<Value, const Number&>>;
    const int size = static_cast<int>(end_.size()) - 1;
    Eigen::SparseMatrix<Scalar> m(size, size);
    m.resizeNonZeros(size + static_cast<Eigen::Index>(entries_.size()));
    int count = 0;
    const auto append = [&](int row, const Scalar& value) {
      m.innerIndexPtr()[count] = row;
      m.valuePtr()[count++] = value;
    };
    auto begin = entries_.begin();
    for (int c = 0; c < size; ++c) {
      const auto end = entries_.begin() + static_cast<std::ptrdiff_t>(end_[row_number(c)]);
      const auto last = merge(begin, end);
      auto i = begin;
      for (; i != last && i->row < c; ++i) append(i->row, entry(i->value));
      append(c, diagonal(c, begin, last));
      for (; i != last; ++i) append(i->row, entry(i->value));
      m.outerIndexPtr()[c + 1] = count;
      begin = end;
    }
    m.resizeNonZeros(count);
    return m;
  }

private:
  using Iterator = typename std::vector<Entry>::iterator;

  // Sorts entries by rows and adds up those of the same row, in their order. \return the end of the
  // result
  static Iterator merge(Iterator begin, Iterator end) {
    // up to there, insertion takes 0.4 to 0.7 of the time (measured), which grows with the square
    constexpr std::ptrdiff_t few = 24;
    if (end - begin > few)
      std::stable_sort(begin, end, [](const Entry& a, const Entry& b) { return a.row < b.row; });
    else
      for (Iterator i = begin; i != end; ++i) {
        const Entry e = *i;
        Iterator to = i;
        for (; to != begin && e.row < (to - 1)->row; --to) *to = *(to - 1);
        *to = e;
      }
    Iterator last = begin;
    for (Iterator i = begin; i != end; ++i)
      if (last != begin && (last - 1)->row == i->row)
        (last - 1)->value += i->value;
      else
        *last++ = *i;
    return last;
  }

  std::vector<std::size_t> end_; // the end of each column
  std::vector<Entry> entries_;
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
