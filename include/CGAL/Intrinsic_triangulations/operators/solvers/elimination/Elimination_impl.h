// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_ELIMINATION_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_ELIMINATION_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/Elimination.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/row_number.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <new>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Whether there is an entry (c, r) for each (r, c); rows are sorted, so that those of a column are met in their order.
inline bool has_symmetric_pattern(const Eigen::SparseMatrix<double>& a) {
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

// Of the pattern alone, below the diagonal, with all of that, as Eigen wants it.
inline std::vector<int> minimum_degree_order(const Eigen::SparseMatrix<double>& a) {
  Eigen::SparseMatrix<signed char> pattern(a.rows(), a.cols());
  pattern.resizeNonZeros(a.nonZeros() / 2 + a.cols());
  int count = 0;
  for (int c = 0; c < a.cols(); ++c) {
    pattern.innerIndexPtr()[count++] = c;
    for (int e = a.outerIndexPtr()[c]; e < a.outerIndexPtr()[c + 1]; ++e)
      if (a.innerIndexPtr()[e] > c) pattern.innerIndexPtr()[count++] = a.innerIndexPtr()[e];
    pattern.outerIndexPtr()[c + 1] = count;
  }
  pattern.resizeNonZeros(count);
  std::fill_n(pattern.valuePtr(), count, static_cast<signed char>(1));
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  if (a.cols() > 0) Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Lower>(), order);
  return {order.indices().data(), order.indices().data() + order.indices().size()};
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Elimination::Elimination(const Eigen::SparseMatrix<double>& a)
    : number_of_entries(a.nonZeros()), place(row_number(a.cols())) {
  if (!has_symmetric_pattern(a))
    throw std::invalid_argument("the matrix must be symmetric; give both triangles of it");
  row = minimum_degree_order(a);
  for (std::size_t k = 0; k < row.size(); ++k) place[row_number(row[k])] = static_cast<int>(k);
  find_later(a);
  find_blocks();
  find_sequence();
  find_parts();
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE bool
Elimination::is_of(const Eigen::SparseMatrix<double>& a) const {
  if (row_number(a.cols()) != row.size() || a.nonZeros() != number_of_entries) return false;
  const int* const begin = a.outerIndexPtr();
  for (std::size_t k = 0; k < row.size(); ++k) {
    int i = later_begin[k];
    for (int e = begin[row[k]]; e < begin[row[k] + 1]; ++e)
      if (const int p = place[row_number(a.innerIndexPtr()[e])]; p > static_cast<int>(k))
        if (i == later_begin[k + 1] || entry[row_number(i)] != e || later[row_number(i++)] != p)
          return false;
    if (i != later_begin[k + 1]) return false;
  }
  return has_symmetric_pattern(a);
}

// Finds where columns of the factor have entries: where the matrix has some, or an earlier column that has its first entry in the row of the diagonal, its
// child in the elimination tree. A column is of the block of the one before if that adds nothing to what is left of it.
class Block_finder {
public:
  explicit Block_finder(Elimination& e)
      : e_(e), seen_(e.row.size(), -1), child_(e.row.size(), -1), sibling_(e.row.size(), -1) {}

  void add_column(int k) {
    own_.assign(e_.later.begin() + e_.later_begin[row_number(k)],
                e_.later.begin() + e_.later_begin[row_number(k + 1)]);
    if (k == 0 || !continues_block(k)) begin_block(k);
    const int block = static_cast<int>(e_.block_begin.size()) - 1;
    e_.block.push_back(block);
    const int first = e_.block_rows_begin[row_number(block)] + k - e_.block_begin.back(),
              end = static_cast<int>(e_.block_rows.size());
    entries_ += end - first;
    if (entries_ > std::numeric_limits<int>::max())
      throw std::bad_alloc(); // a factor of more than 26 GB
    e_.column_begin.push_back(static_cast<int>(entries_));
    if (first == end) return;
    const std::size_t parent = row_number(e_.block_rows[row_number(first)]);
    sibling_[row_number(k)] = child_[parent];
    child_[parent] = k;
  }

private:
  // Calls `visit(begin, end)` with the rows of each child but that of the diagonal, until that returns `false`.
  template <class Visit>
  bool for_each_child(int k, const Visit& visit) const {
    for (int c = child_[row_number(k)]; c >= 0; c = sibling_[row_number(c)]) {
      const std::size_t b = row_number(e_.block[row_number(c)]);
      const int end = b + 1 < e_.block_rows_begin.size() ? e_.block_rows_begin[b + 1]
                                                         : static_cast<int>(e_.block_rows.size());
      const int count = e_.column_begin[row_number(c + 1)] - e_.column_begin[row_number(c)];
      if (!visit(c, e_.block_rows.data() + end - count + 1, e_.block_rows.data() + end))
        return false;
    }
    return true;
  }

  bool continues_block(int k) const {
    const int block = static_cast<int>(e_.block_begin.size()) - 1;
    const auto is_there = [&](int r) { return seen_[row_number(r)] == block; };
    bool is_child = false;
    return std::all_of(own_.begin(), own_.end(), is_there) &&
           for_each_child(k,
                          [&](int c, const int* first, const int* last) {
                            if (c == k - 1) is_child = true;
                            return c == k - 1 || std::all_of(first, last, is_there);
                          }) &&
           is_child;
  }

  void begin_block(int k) {
    std::sort(own_.begin(), own_.end());
    for_each_child(k, [&](int, const int* first, const int* last) {
      merged_.clear();
      std::set_union(own_.begin(), own_.end(), first, last, std::back_inserter(merged_));
      own_.swap(merged_);
      return true;
    });
    const int block = static_cast<int>(e_.block_begin.size());
    for (const int r : own_) seen_[row_number(r)] = block;
    e_.block_begin.push_back(k);
    e_.block_rows_begin.push_back(static_cast<int>(e_.block_rows.size()));
    e_.block_rows.insert(e_.block_rows.end(), own_.begin(), own_.end());
  }

  Elimination& e_;
  std::vector<int> seen_;            // the last block with an entry there
  std::vector<int> child_, sibling_; // of each column a child, and another of the same parent
  std::vector<int> own_, merged_;    // entries of a column
  std::int64_t entries_ = 0;
};

// The matrix is read from the first row to the last, as places are anywhere in it.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE void
Elimination::find_later(const Eigen::SparseMatrix<double>& a) {
  later_begin.assign(row.size() + 1, 0);
  const int *const begin = a.outerIndexPtr(), *const inner = a.innerIndexPtr();
  for (int c = 0; c < a.cols(); ++c) {
    const int k = place[row_number(c)];
    int& count = later_begin[row_number(k + 1)];
    for (int e = begin[c]; e < begin[c + 1]; ++e) count += place[row_number(inner[e])] > k ? 1 : 0;
  }
  std::partial_sum(later_begin.begin(), later_begin.end(), later_begin.begin());
  later.resize(row_number(later_begin.back()));
  entry.resize(later.size());
  for (int c = 0; c < a.cols(); ++c) {
    const int k = place[row_number(c)];
    std::size_t to = row_number(later_begin[row_number(k)]);
    for (int e = begin[c]; e < begin[c + 1]; ++e)
      if (const int p = place[row_number(inner[e])]; p > k) {
        later[to] = p;
        entry[to++] = e;
      }
  }
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Elimination::find_blocks() {
  column_begin.reserve(row.size() + 1);
  column_begin.push_back(0);
  block.reserve(row.size());
  Block_finder finder(*this);
  for (int k = 0; k < static_cast<int>(row.size()); ++k) finder.add_column(k);
  block_begin.push_back(static_cast<int>(row.size()));
  block_rows_begin.push_back(static_cast<int>(block_rows.size()));
}

// Children are numbered before their parents: from the last on, each block gets the last places that are left of those of its parent, but that with most below
// it the first ones.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Elimination::find_sequence() {
  const int n = static_cast<int>(block_begin.size()) - 1;
  std::vector<int> size(row_number(n), 1), greatest(row_number(n), -1), at(row_number(n)),
      end(row_number(n)); // of the places that are left
  for (int b = 0; b < n; ++b)
    if (const int above = parent(b); above >= 0) {
      size[row_number(above)] += size[row_number(b)];
      int& g = greatest[row_number(above)];
      if (g < 0 || size[row_number(b)] > size[row_number(g)]) g = b;
    }
  sequence.resize(row_number(n));
  int last = n;
  for (int b = n - 1; b >= 0; --b) {
    const int above = parent(b), own = size[row_number(b)];
    int& free = above >= 0 ? end[row_number(above)] : last;
    if (above >= 0 && greatest[row_number(above)] == b) {
      at[row_number(b)] = at[row_number(above)] - size[row_number(above)] + own;
    } else {
      at[row_number(b)] = free - 1;
      free -= own;
    }
    end[row_number(b)] = at[row_number(b)];
    sequence[row_number(at[row_number(b)])] = b;
  }
}

// Subtrees of the tree of blocks are independent: blocks above subtrees of some work come after both halves, the subtrees are distributed.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Elimination::find_parts() {
  const int n = static_cast<int>(block_begin.size()) - 1;
  std::vector<double> work(row_number(n), 0);
  double all = 0;
  for (int b = 0; b < n; ++b) {
    double own = 0;
    for (int k = block_begin[row_number(b)]; k < block_begin[row_number(b + 1)]; ++k)
      own += (count(k) + 4.0) * (count(k) + 4.0);
    work[row_number(b)] += own;
    all += own;
    if (const int above = parent(b); above >= 0) work[row_number(above)] += work[row_number(b)];
  }
  constexpr double worth_a_thread = 1e6, greatest_share = 0.2;
  part.assign(row_number(n), after_both);
  if (all < worth_a_thread) return;
  std::array<double, 2> halves{0, 0};
  for (int b = n - 1; b >= 0; --b) {
    if (work[row_number(b)] > greatest_share * all) continue;
    const int parent_of_b = parent(b);
    const Part above = parent_of_b >= 0 ? part[row_number(parent_of_b)] : after_both;
    part[row_number(b)] = above != after_both      ? above
                          : halves[0] <= halves[1] ? first_half
                                                   : second_half;
    if (above == after_both) halves[part[row_number(b)]] += work[row_number(b)];
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_ELIMINATION_IMPL_H
