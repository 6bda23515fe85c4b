// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_ORDERING_SYMBOLIC_FACTORIZATION_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_ORDERING_SYMBOLIC_FACTORIZATION_H

#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_operators/solvers/ordering/Nested_dissection.h>
#include <CGAL/Intrinsic_operators/solvers/ordering/minimum_degree_order.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The symbolic factorization of a symmetric matrix: a permutation of its rows, and the places of
// the entries of its factor. It depends on the pattern only. The *place* of a row is its number in
// the permutation.
struct Symbolic_factorization {
  // Permutes by approximate minimum degree, or by nested dissection if that leaves less work: which
  // it tries if elimination would take longer than dissection. \throws std::invalid_argument if the
  // pattern is not symmetric
  template <class Scalar>
  explicit Symbolic_factorization(const Eigen::SparseMatrix<Scalar>& a);
  // \param order the rows, as they are eliminated
  template <class Scalar>
  Symbolic_factorization(const Eigen::SparseMatrix<Scalar>& a, std::vector<int> order);

  // An entry of the matrix, below the diagonal once permuted.
  struct Entry {
    int place, number;
  };
  // Independent subtrees are distributed to two halves, which two threads may eliminate; their
  // common ancestors follow.
  enum Part : unsigned char { first_half, second_half, after_both };

  int supernodes() const { return static_cast<int>(supernode_begin.size()) - 1; }
  // the number of rows of a front: those of the supernode and those below it
  int height(int s) const { return rows_begin[row_number(s + 1)] - rows_begin[row_number(s)] + 1; }
  int columns(int s) const {
    return supernode_begin[row_number(s + 1)] - supernode_begin[row_number(s)];
  }
  // of all fronts
  int greatest_height() const {
    int result = 0;
    for (int s = 0; s < supernodes(); ++s) result = std::max(result, height(s));
    return result;
  }
  // the places of the rows below a supernode
  const int* rows_below(int s) const {
    return rows.data() + rows_begin[row_number(s)] + columns(s) - 1;
  }
  const int* rows_end(int s) const { return rows.data() + rows_begin[row_number(s + 1)]; }
  // the supernode of the first row below, or -1
  int parent(int s) const {
    return height(s) > columns(s) ? supernode[row_number(*rows_below(s))] : -1;
  }

  std::vector<int> row, place;       // the permutation, and its inverse
  std::vector<int> entry_begin;      // of each column of the permuted matrix
  std::vector<Entry> entry;          // in the order of the matrix
  std::vector<int> column_begin;     // of each column of the factor, below the diagonal
  std::vector<int> supernode;        // of each column
  std::vector<int> supernode_begin;  // the first column of each
  std::vector<int> rows_begin, rows; // places of the entries of the first column of each
  std::vector<Part> part;            // of each supernode
  bool has_halves = false;
  double work = 0; // products of numbers in the elimination
  Eigen::Index entries_of_matrix;

private:
  template <class Scalar>
  void find_entries(const Eigen::SparseMatrix<Scalar>& a);
  void find_supernodes();
  template <class Visit>
  bool for_each_row_below(int column, const Visit& visit) const;
  void begin_supernode(int column);
  void find_parts();

  std::vector<int> seen_;            // the last supernode with an entry in a row
  std::vector<int> child_, sibling_; // of a column the last child, of a supernode the one before
  std::vector<int> added_;           // rows of a new supernode
};

// Whether there is an entry (c, r) for each (r, c); rows are sorted, so those of a column come in
// order.
template <class Scalar>
bool has_symmetric_pattern(const Eigen::SparseMatrix<Scalar>& a) {
  const int *const begin = a.outerIndexPtr(), *const row = a.innerIndexPtr();
  std::vector<int> next(begin, begin + a.outerSize());
  for (int c = 0; c < a.outerSize(); ++c)
    for (int e = begin[c]; e < begin[c + 1]; ++e) {
      int& mirror = next[row_number(row[e])];
      if (mirror == begin[row[e] + 1] || row[mirror] != c) return false;
      ++mirror;
    }
  return true;
}

template <class Scalar>
Symbolic_factorization::Symbolic_factorization(const Eigen::SparseMatrix<Scalar>& a)
    : Symbolic_factorization(a, minimum_degree_order(a)) {
  constexpr double worth_dissection = 20'000; // products of a row
  if (work <= worth_dissection * static_cast<double>(row.size())) return;
  if (Symbolic_factorization dissected(a, dissected_order(a, row)); dissected.work < work)
    *this = std::move(dissected);
}

template <class Scalar>
Symbolic_factorization::Symbolic_factorization(const Eigen::SparseMatrix<Scalar>& a,
                                               std::vector<int> order)
    : row(std::move(order)), place(row.size()), entries_of_matrix(a.nonZeros()) {
  if (!has_symmetric_pattern(a))
    throw std::invalid_argument("the matrix must be symmetric; give both triangles of it");
  for (std::size_t k = 0; k < row.size(); ++k) place[row_number(row[k])] = static_cast<int>(k);
  find_entries(a);
  find_supernodes();
  find_parts();
}

// Reads the matrix from the first row to the last, since places are in random order.
template <class Scalar>
void Symbolic_factorization::find_entries(const Eigen::SparseMatrix<Scalar>& a) {
  entry_begin.assign(row.size() + 1, 0);
  const int *const begin = a.outerIndexPtr(), *const inner = a.innerIndexPtr();
  for (int c = 0; c < a.cols(); ++c) {
    const int k = place[row_number(c)];
    int& count = entry_begin[row_number(k + 1)];
    for (int e = begin[c]; e < begin[c + 1]; ++e) count += place[row_number(inner[e])] > k ? 1 : 0;
  }
  std::partial_sum(entry_begin.begin(), entry_begin.end(), entry_begin.begin());
  entry.resize(row_number(entry_begin.back()));
  for (int c = 0; c < a.cols(); ++c) {
    const int k = place[row_number(c)];
    std::size_t to = row_number(entry_begin[row_number(k)]);
    for (int e = begin[c]; e < begin[c + 1]; ++e)
      if (const int p = place[row_number(inner[e])]; p > k) entry[to++] = {p, e};
  }
}

// Calls `visit` with the rows below a column, of the matrix and of its children in the elimination
// tree, until that returns `false`.
template <class Visit>
bool Symbolic_factorization::for_each_row_below(int column, const Visit& visit) const {
  for (int i = entry_begin[row_number(column)]; i < entry_begin[row_number(column + 1)]; ++i)
    if (!visit(entry[row_number(i)].place)) return false;
  for (int c = child_[row_number(column)]; c >= 0; c = sibling_[row_number(c)])
    if (!std::all_of(rows_below(c) + 1, rows_end(c), visit)) return false;
  return true;
}

// Analyses a matrix, unless the analysis of one with entries in the same places is given. \throws
// std::invalid_argument if the other one has another size
template <class Scalar>
void analyze(const Eigen::SparseMatrix<Scalar>& a,
             std::shared_ptr<const Symbolic_factorization>& s) {
  if (!s) s = std::make_shared<const Symbolic_factorization>(a);
  if (s->row.size() != row_number(a.cols()) || s->entries_of_matrix != a.nonZeros())
    throw std::invalid_argument("the analysis is that of another matrix");
}

// A column continues a supernode if it is the parent of the one before and adds no row.
inline void Symbolic_factorization::find_supernodes() {
  const int size = static_cast<int>(row.size());
  seen_.assign(row.size(), -1);
  child_.assign(row.size(), -1);
  rows_begin.push_back(0);
  std::int64_t entries = 0;
  for (int k = 0; k < size; ++k) {
    const int last = static_cast<int>(supernode_begin.size()) - 1;
    if (last < 0 || seen_[row_number(k)] != last ||
        !for_each_row_below(k, [&](int r) { return seen_[row_number(r)] == last; }))
      begin_supernode(k);
    supernode.push_back(static_cast<int>(supernode_begin.size()) - 1);
    column_begin.push_back(static_cast<int>(entries));
    entries += height(supernode.back()) - 1 - (k - supernode_begin.back());
    if (entries > std::numeric_limits<int>::max()) throw std::bad_alloc(); // more than 17 GB
  }
  column_begin.push_back(static_cast<int>(entries));
  supernode_begin.push_back(size);
  for (std::vector<int>* const temporary : {&seen_, &child_, &sibling_, &added_})
    std::vector<int>().swap(*temporary);
}

inline void Symbolic_factorization::begin_supernode(int column) {
  const int s = static_cast<int>(supernode_begin.size());
  supernode_begin.push_back(column);
  if (s > 0 && height(s - 1) > columns(s - 1)) {
    int& child = child_[row_number(*rows_below(s - 1))];
    sibling_.push_back(std::exchange(child, s - 1));
  } else if (s > 0) {
    sibling_.push_back(-1);
  }
  added_.clear();
  for_each_row_below(column, [&](int r) {
    if (std::exchange(seen_[row_number(r)], s) != s) added_.push_back(r);
    return true;
  });
  std::sort(added_.begin(), added_.end());
  rows.insert(rows.end(), added_.begin(), added_.end());
  rows_begin.push_back(static_cast<int>(rows.size()));
}

// Supernodes above subtrees of some work come after both halves.
inline void Symbolic_factorization::find_parts() {
  // A unit takes a nanosecond: starting a thread, which takes 18 microseconds, is 2 % of this work.
  constexpr double worth_a_thread = 1e6;
  // The lesser half gets the next subtree: they differ at most by this share. Counted in operations
  // two threads are 1.5 times as fast on the data set, with 0.1 1.4 times, with 0.4 1.55 times.
  constexpr double greatest_share = 0.2;
  std::vector<double> below(row_number(supernodes()), 0); // work of the subtree
  for (int s = 0; s < supernodes(); ++s) {
    double own = 0;
    for (int h = height(s); h > height(s) - columns(s); --h) own += (h + 3.) * (h + 3.);
    below[row_number(s)] += own;
    work += own;
    if (const int above = parent(s); above >= 0) below[row_number(above)] += below[row_number(s)];
  }
  part.assign(below.size(), after_both);
  has_halves = work >= worth_a_thread;
  std::array<double, 2> halves{0, 0};
  for (int s = supernodes() - 1; s >= 0 && has_halves; --s) {
    if (below[row_number(s)] > greatest_share * work) continue;
    const int above = parent(s);
    Part& own = part[row_number(s)];
    if (above >= 0) own = part[row_number(above)];
    if (own != after_both) continue;
    own = halves[0] <= halves[1] ? first_half : second_half;
    halves[own] += below[row_number(s)];
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_ORDERING_SYMBOLIC_FACTORIZATION_H
