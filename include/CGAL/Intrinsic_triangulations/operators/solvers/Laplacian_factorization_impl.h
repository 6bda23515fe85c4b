// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_LAPLACIAN_FACTORIZATION_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_LAPLACIAN_FACTORIZATION_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/Laplacian_elimination.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/Laplacian_solver.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/Ordered_laplacian.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/row_number.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/where_to_run.h>

#include <Eigen/OrderingMethods>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <future>
#include <iterator>
#include <limits>
#include <memory>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

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

inline bool has_diagonal(const Eigen::SparseMatrix<double>& a) {
  for (Eigen::Index c = 0; c < a.cols(); ++c) {
    const auto *first = a.innerIndexPtr() + a.outerIndexPtr()[c],
               *last = a.innerIndexPtr() + a.outerIndexPtr()[c + 1];
    if (!std::binary_search(first, last, static_cast<int>(c))) return false;
  }
  return true;
}

// Of the pattern alone, which is half as long without values. Eigen's order wants entries on the diagonal.
inline std::vector<int> minimum_degree_order(const Eigen::SparseMatrix<double>& a) {
  Eigen::SparseMatrix<signed char> pattern(a.rows(), a.cols());
  pattern.resizeNonZeros(a.nonZeros());
  std::copy_n(a.outerIndexPtr(), a.cols() + 1, pattern.outerIndexPtr());
  std::copy_n(a.innerIndexPtr(), a.nonZeros(), pattern.innerIndexPtr());
  std::fill_n(pattern.valuePtr(), a.nonZeros(), static_cast<signed char>(1));
  if (!has_diagonal(a))
    for (Eigen::Index i = 0; i < a.cols(); ++i) pattern.coeffRef(i, i) = 1;
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  if (a.cols() > 0) Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Lower>(), order);
  return {order.indices().data(), order.indices().data() + order.indices().size()};
}

inline std::size_t hash_of_pattern(const Eigen::SparseMatrix<double>& a) {
  std::size_t hash = boost::hash_range(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1);
  boost::hash_range(hash, a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros());
  return hash;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Elimination::Elimination(const Eigen::SparseMatrix<double>& a)
    : Elimination(a, minimum_degree_order(a)) {}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Elimination::Elimination(const Eigen::SparseMatrix<double>& a, std::vector<int> order)
    : pattern(hash_of_pattern(a)), row(std::move(order)), place(row.size()) {
  if (!has_symmetric_pattern(a))
    throw std::invalid_argument("the matrix must be symmetric; give both triangles of it");
  for (std::size_t k = 0; k < row.size(); ++k) place[row_number(row[k])] = static_cast<int>(k);
  find_later(a);
  find_blocks();
  find_sequence();
  find_parts();
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

// Children are numbered before their parents: from the last on, each block gets the last places that are left of those of its parent.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Elimination::find_sequence() {
  const int n = static_cast<int>(block_begin.size()) - 1;
  std::vector<int> size(row_number(n), 1), end(row_number(n));
  for (int b = 0; b < n; ++b)
    if (const int above = parent(b); above >= 0) size[row_number(above)] += size[row_number(b)];
  sequence.resize(row_number(n));
  int last = n;
  for (int b = n - 1; b >= 0; --b) {
    const int above = parent(b);
    int& free = above >= 0 ? end[row_number(above)] : last;
    end[row_number(b)] = free - 1;
    sequence[row_number(free - 1)] = b;
    free -= size[row_number(b)];
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

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Ordered_laplacian::Ordered_laplacian(Matrix laplacian)
    : laplacian_(std::make_shared<const Matrix>(std::move(laplacian))) {
  constexpr Eigen::Index worth_a_thread = 2000;
  const auto find = [l = laplacian_] { return std::make_shared<const Elimination>(*l); };
  elimination_ = std::async(where_to_run(laplacian_->rows() >= worth_a_thread), find).share();
}

inline void expect_diagonal(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& d) {
  if (a.rows() != a.cols() || d.size() != a.rows())
    throw std::invalid_argument("a matrix with " + std::to_string(a.rows()) + " rows, " +
                                std::to_string(a.cols()) + " columns and " +
                                std::to_string(d.size()) + " diagonal entries cannot be factored");
  if (!d.allFinite()) throw std::invalid_argument("the diagonal must be finite");
}

inline void expect_laplacian(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& d) {
  expect_diagonal(a, d);
  if (!a.isCompressed()) throw std::invalid_argument("the matrix must be compressed");
  if (!Eigen::Map<const Eigen::VectorXd>(a.valuePtr(), a.nonZeros()).allFinite())
    throw std::invalid_argument("the matrix must be finite");
}

// Throws if the order of one matrix is not one for another.
inline void expect_same_pattern(const Elimination& e, const Eigen::SparseMatrix<double>& a) {
  if (static_cast<Eigen::Index>(e.row.size()) != a.cols() || e.pattern != hash_of_pattern(a))
    throw std::invalid_argument("the matrices must have the same pattern");
}

// Eliminates all places of a Laplacian, its weights times a unit, and a diagonal. \return a factor per matrix \throws Indefinite_matrix
template <class Number, class Diagonal>
auto eliminate_all(std::shared_ptr<const Elimination> elimination,
                   const Eigen::SparseMatrix<double>& laplacian, const Number& unit,
                   const Diagonal& diagonal) {
  const Elimination& e = *elimination;
  std::array<std::shared_ptr<Laplacian_factor>, size_of_pack<Number>> factors;
  std::array<double*, size_of_pack<Number>> value;
  for (std::size_t m = 0; m < factors.size(); ++m) {
    factors[m] = std::make_shared<Laplacian_factor>(elimination);
    value[m] = factors[m]->value.get();
  }
  Laplacian_elimination<Number> rest(e, laplacian, unit, value);
  const auto eliminate = [&](Elimination::Part part) { return rest.eliminate(part, diagonal); };
  auto other = std::async(where_to_run(e.has_halves()), eliminate, Elimination::second_half);
  const int first = eliminate(Elimination::first_half), second = other.get(),
            stopped = first >= 0 ? first : second;
  if (const int row = stopped >= 0 ? stopped : eliminate(Elimination::after_both); row >= 0)
    throw Indefinite_matrix(row);
  for (std::size_t m = 0; m < factors.size(); ++m) factors[m]->pivot = rest.pivots(m);
  return factors;
}

} // namespace internal

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Laplacian_factorization::Laplacian_factorization(const Matrix& laplacian,
                                                 const Eigen::VectorXd& diagonal) {
  internal::expect_laplacian(laplacian, diagonal);
  factor(laplacian, diagonal, std::make_shared<const internal::Elimination>(laplacian));
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Laplacian_factorization::Laplacian_factorization(const Matrix& laplacian,
                                                 const Eigen::VectorXd& diagonal,
                                                 const Laplacian_factorization& same_pattern) {
  internal::expect_laplacian(laplacian, diagonal);
  internal::expect_same_pattern(*same_pattern.factor_->elimination, laplacian);
  factor(laplacian, diagonal, same_pattern.factor_->elimination);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void
Laplacian_factorization::factor(const Matrix& laplacian, const Eigen::VectorXd& diagonal,
                                std::shared_ptr<const internal::Elimination> elimination) {
  factor_ = internal::eliminate_all(std::move(elimination), laplacian, 1.0,
                                    [&](int row) { return diagonal[row]; })[0];
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Laplacian_factorization::Laplacian_factorization(const internal::Ordered_laplacian& laplacian,
                                                 const Eigen::VectorXd& diagonal) {
  internal::expect_laplacian(*laplacian, diagonal);
  factor(*laplacian, diagonal, laplacian.elimination());
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::pair<Laplacian_factorization, Laplacian_factorization>
Laplacian_factorization::of_both(const Matrix& laplacian, const Eigen::VectorXd& diagonal,
                                 double multiple, const Eigen::VectorXd& diagonal_of_multiple) {
  internal::expect_laplacian(laplacian, diagonal);
  return of_both(internal::Ordered_laplacian(laplacian), diagonal, multiple, diagonal_of_multiple);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::pair<Laplacian_factorization, Laplacian_factorization>
Laplacian_factorization::of_both(const internal::Ordered_laplacian& laplacian,
                                 const Eigen::VectorXd& diagonal, double multiple,
                                 const Eigen::VectorXd& diagonal_of_multiple) {
  internal::expect_laplacian(*laplacian, diagonal);
  internal::expect_diagonal(*laplacian, diagonal_of_multiple);
  if (!std::isfinite(multiple)) throw std::invalid_argument("the multiple must be finite");
  const auto factors = internal::eliminate_all(
      laplacian.elimination(), *laplacian, Eigen::Array2d(1, multiple),
      [&](int row) { return Eigen::Array2d(diagonal[row], diagonal_of_multiple[row]); });
  return {Laplacian_factorization(factors[0]), Laplacian_factorization(factors[1])};
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Eigen::MatrixXd
Laplacian_factorization::solved(const Eigen::Ref<const Eigen::MatrixXd>& b) const {
  if (b.rows() != size())
    throw std::invalid_argument("the right side must have a row per row of the matrix, " +
                                std::to_string(size()) + ", not " + std::to_string(b.rows()));
  Eigen::MatrixXd x(b.rows(), b.cols());
  const internal::Laplacian_solver solver(*factor_);
  Eigen::Index c = 0;
  for (; c + 4 <= b.cols(); c += 4) solver.solve<Eigen::Array4d>(b, x, c);
  for (; c + 2 <= b.cols(); c += 2) solver.solve<Eigen::Array2d>(b, x, c);
  if (c < b.cols()) solver.solve<double>(b, x, c);
  return x;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_LAPLACIAN_FACTORIZATION_IMPL_H
