// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIGRID_AGGREGATES_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIGRID_AGGREGATES_H

#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Groups of unknowns that strong entries of a Hermitian matrix connect. A smooth function is nearly
constant on a group, times the phase of each unknown. The phase is 1 for weights; for connections it
turns the vector of the group along edges. Rows without connections, as those of fixed values, are
in no group: smoothing solves them.
*/
template <class Number>
class Aggregates {
public:
  using Matrix = Eigen::SparseMatrix<Number>;

  explicit Aggregates(const Matrix& a)
      : group(row_number(a.cols()), -1), phase(group.size(), Number(1)), a_(a),
        greatest_(group.size(), 0) {
    for (int i = 0; i < a.cols(); ++i)
      for_each_neighbour(i, [&](int, const Number& w) {
        greatest_[row_number(i)] = std::max(greatest_[row_number(i)], std::norm(w));
      });
    for (int i = 0; i < a.cols(); ++i)
      if (is_free_with_neighbours(i)) begin_group(i);
    const std::vector<int> begun = group;
    for (int i = 0; i < a.cols(); ++i)
      if (group[row_number(i)] < 0) join(i, begun);
    for (int i = 0; i < a.cols(); ++i)
      if (group[row_number(i)] < 0 && greatest_[row_number(i)] > 0) begin_group(i);
  }

  // whether an entry is not small beside the greatest ones of its row and of its column
  bool is_strong(int i, int j, const Number& w) const {
    constexpr double small = 0.0064; // 0.08^2
    const double n = std::norm(w);
    return n > small * std::max(greatest_[row_number(i)], greatest_[row_number(j)]) ||
           n >= greatest_[row_number(i)] || n >= greatest_[row_number(j)];
  }

  std::vector<int> group; // -1: none
  std::vector<Number> phase;
  int groups = 0;

private:
  // Calls `visit` with the other unknowns of a row, and minus their entries in it.
  template <class Visit>
  void for_each_neighbour(int i, const Visit& visit) const {
    for (typename Matrix::InnerIterator e(a_, i); e; ++e)
      if (e.row() != i && e.value() != Number(0))
        visit(static_cast<int>(e.row()), Number(-Eigen::numext::conj(e.value())));
  }

  bool is_free_with_neighbours(int i) const {
    bool is_free = group[row_number(i)] < 0 && greatest_[row_number(i)] > 0;
    for_each_neighbour(i, [&](int j, const Number& w) {
      is_free = is_free && (group[row_number(j)] < 0 || !is_strong(i, j, w));
    });
    return is_free;
  }

  // Real numbers keep their sign: smooth functions do not change it, also where a few entries are
  // positive.
  static Number turned(const Number& w, const Number& phase) {
    if constexpr (sizeof(Number) == sizeof(double))
      return phase;
    else
      return w / std::abs(w) * phase;
  }

  void begin_group(int i) {
    group[row_number(i)] = groups;
    for_each_neighbour(i, [&](int j, const Number& w) {
      if (group[row_number(j)] >= 0 || !is_strong(i, j, w)) return;
      group[row_number(j)] = groups;
      phase[row_number(j)] = turned(Eigen::numext::conj(w), phase[row_number(i)]);
    });
    ++groups;
  }

  // Joins the group of the strongest neighbour that is in one.
  void join(int i, const std::vector<int>& begun) {
    double strongest = 0;
    for_each_neighbour(i, [&](int j, const Number& w) {
      if (begun[row_number(j)] < 0 || !is_strong(i, j, w) || std::norm(w) <= strongest) return;
      strongest = std::norm(w);
      group[row_number(i)] = begun[row_number(j)];
      phase[row_number(i)] = turned(w, phase[row_number(j)]);
    });
  }

  const Matrix& a_;
  std::vector<double> greatest_; // squared magnitude off the diagonal of each row
};

/*
The prolongation from aggregates: their phases, after one step of the damped method of Jacobi with
the matrix whose weak entries are added to its diagonal. It makes the functions of groups overlap.
The diagonal is without the excess, so that constants stay constants.
\param excess a number per row: of real matrices the sum of the row, else zero
*/
template <class Number>
Eigen::SparseMatrix<Number> smoothed_prolongation(const Eigen::SparseMatrix<Number>& a,
                                                  const Eigen::VectorXd& excess) {
  constexpr double damping = 2. / 3;
  const Aggregates<Number> aggregates(a);
  Eigen::SparseMatrix<Number, Eigen::RowMajor> result(a.rows(), aggregates.groups);
  std::vector<Number> value(row_number(aggregates.groups), Number(0));
  std::vector<int> columns;
  result.reserve(3 * a.rows());
  for (int i = 0; i < a.cols(); ++i) {
    columns.clear();
    result.startVec(i);
    if (aggregates.group[row_number(i)] < 0) continue;
    const auto add = [&](int j, const Number& factor) {
      const int c = aggregates.group[row_number(j)];
      if (std::find(columns.begin(), columns.end(), c) == columns.end()) {
        columns.push_back(c);
        value[row_number(c)] = 0;
      }
      value[row_number(c)] += factor * aggregates.phase[row_number(j)];
    };
    double diagonal = -excess[i];
    for (typename Eigen::SparseMatrix<Number>::InnerIterator e(a, i); e; ++e)
      if (e.row() == i || !aggregates.is_strong(i, static_cast<int>(e.row()), e.value()))
        diagonal += std::real(e.value());
    add(i, diagonal > 0 ? 1 - damping : 1);
    if (diagonal > 0)
      for (typename Eigen::SparseMatrix<Number>::InnerIterator e(a, i); e; ++e)
        if (const int j = static_cast<int>(e.row());
            j != i && aggregates.is_strong(i, j, e.value()))
          add(j, Number(-damping / diagonal * Eigen::numext::conj(e.value())));
    std::sort(columns.begin(), columns.end());
    for (const int c : columns) result.insertBack(i, c) = value[row_number(c)];
  }
  result.finalize();
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIGRID_AGGREGATES_H
