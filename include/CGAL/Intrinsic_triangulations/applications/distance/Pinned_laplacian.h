// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_DISTANCE_PINNED_LAPLACIAN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_DISTANCE_PINNED_LAPLACIAN_H

#include <CGAL/Intrinsic_triangulations/operators/Cholesky_factorization.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SparseCore>

#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The rows and columns of a symmetric matrix that are kept.
template <class Scalar>
Eigen::SparseMatrix<Scalar> principal_submatrix(const Eigen::SparseMatrix<Scalar>& a,
                                                const std::vector<int>& kept) {
  std::vector<int> place(static_cast<std::size_t>(a.cols()), -1);
  for (std::size_t i = 0; i < kept.size(); ++i)
    place[static_cast<std::size_t>(kept[i])] = static_cast<int>(i);
  const auto size = static_cast<Eigen::Index>(kept.size());
  Eigen::SparseMatrix<Scalar> part(size, size);
  part.reserve(a.nonZeros());
  for (int c = 0; c < size; ++c) {
    part.startVec(c);
    for (typename Eigen::SparseMatrix<Scalar>::InnerIterator i(a, kept[static_cast<std::size_t>(c)]);
         i; ++i)
      if (const int r = place[static_cast<std::size_t>(i.row())]; r >= 0)
        part.insertBack(r, c) = i.value(); // `kept` is sorted, so are rows
  }
  part.finalize();
  return part;
}

/*!
Solves L x = b with given values in some rows, the *pins*, as for distances, the Laplacian of which is always the same and the
pins are not: where a component has no pin, x is infinite.

Of a component with one pin, x follows from any solution by adding a constant. For few pins, there are few numbers more, by
Lagrange: L x = b + sum over pins of l_s e_s, where values are right and all l sum to zero; the factorization of L is the
same for all of them. For more pins than that is worth, their rows are eliminated and what is left is factored, and kept
for the next right side with pins in the same rows.
*/
class Pinned_laplacian {
public:
  using Pins = std::map<int, double>; // by rows

  // \param component of each row, as the least of its rows
  Pinned_laplacian(const Eigen::SparseMatrix<double>& laplacian, std::vector<int> component)
      : laplacian_(laplacian), component_(std::move(component)) {}

  Eigen::VectorXd solve(const Eigen::VectorXd& b, const Pins& pins) {
    std::vector<char> is_reached(component_.size(), 0); // of the least rows
    for (const auto& [row, value] : pins) is_reached[number(component_[number(row)])] = 1;
    Eigen::VectorXd x =
        pins.size() <= few_pins ? solve_for_few(b, pins) : solve_by_elimination(b, pins, is_reached);
    for (Eigen::Index r = 0; r < x.size(); ++r)
      if (is_reached[number(component_[number(r)])] == 0)
        x[r] = std::numeric_limits<double>::infinity();
    for (const auto& [row, value] : pins) x[row] = value;
    return x;
  }

private:
  using Factorization = Cholesky_factorization<double>;

  // a factorization takes the time of about so many solutions
  static constexpr std::size_t few_pins = 8;

  static std::size_t number(Eigen::Index i) { return static_cast<std::size_t>(i); }

  // To one diagonal entry per component something is added: for right sides that sum to zero, this fixes a value, zero. Isolated
  // vertices have a row of zeros.
  const Factorization& factorization() {
    if (!factored_) {
      Eigen::SparseMatrix<double> regular = laplacian_;
      for (int r = 0; r < regular.cols(); ++r)
        if (component_[number(r)] == r) {
          double& diagonal = regular.coeffRef(r, r);
          diagonal = diagonal > 0 ? 2 * diagonal : 1;
        }
      factored_ = std::make_unique<Factorization>(regular);
    }
    return *factored_;
  }

  Eigen::VectorXd solve_for_few(const Eigen::VectorXd& b, const Pins& pins) {
    std::map<int, std::vector<int>> rows; // the pins of each component
    for (const auto& [row, value] : pins) rows[component_[number(row)]].push_back(row);
    std::vector<int> sources; // rows with an unknown strength
    for (const auto& [root, of_component] : rows)
      if (of_component.size() > 1)
        sources.insert(sources.end(), of_component.begin(), of_component.end());
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(b.size(), static_cast<Eigen::Index>(sources.size()) + 1);
    right.col(0) = b;
    for (std::size_t i = 0; i < sources.size(); ++i)
      right(sources[i], static_cast<Eigen::Index>(i) + 1) = 1;
    const Eigen::MatrixXd solved = factorization().solve(right);
    Eigen::VectorXd x = solved.col(0);
    Eigen::Index column = 1;
    for (const auto& [root, of_component] : rows) {
      Eigen::VectorXd correction;
      if (of_component.size() == 1)
        correction = Eigen::VectorXd::Constant(
            x.size(), pins.at(of_component[0]) - x[of_component[0]]);
      else
        correction = strengths(solved, column, of_component, pins);
      for (Eigen::Index r = 0; r < x.size(); ++r)
        if (component_[number(r)] == root) x[r] += correction[r];
    }
    return x;
  }

  // what pins of a component add to the solution in column 0; theirs are from `column` on
  static Eigen::VectorXd strengths(const Eigen::MatrixXd& solved, Eigen::Index& column,
                                   const std::vector<int>& rows, const Pins& pins) {
    const auto n = static_cast<Eigen::Index>(rows.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n + 1, n + 1);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n + 1);
    for (Eigen::Index i = 0; i < n; ++i) {
      const int row = rows[number(i)];
      for (Eigen::Index j = 0; j < n; ++j) a(i, j) = solved(row, column + j);
      a(i, n) = a(n, i) = 1;
      b[i] = pins.at(row) - solved(row, 0);
    }
    const Eigen::VectorXd l = a.fullPivLu().solve(b);
    Eigen::VectorXd result = solved.middleCols(column, n) * l.head(n);
    result.array() += l[n];
    column += n;
    return result;
  }

  Eigen::VectorXd solve_by_elimination(const Eigen::VectorXd& b, const Pins& pins,
                                       const std::vector<char>& is_reached) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
    std::vector<int> rows, free;
    for (const auto& [row, value] : pins) {
      rows.push_back(row);
      x[row] = value;
    }
    if (rows != eliminated_rows_ || !eliminated_) {
      free_rows_.clear();
      for (int r = 0; r < x.size(); ++r)
        if (is_reached[number(component_[number(r)])] != 0 && pins.count(r) == 0)
          free_rows_.push_back(r);
      eliminated_rows_ = rows;
      eliminated_ = free_rows_.empty() ? nullptr
                                       : std::make_unique<Factorization>(
                                             principal_submatrix(laplacian_, free_rows_));
    }
    if (free_rows_.empty()) return x;
    const Eigen::VectorXd rest = b - laplacian_ * x;
    const Eigen::VectorXd solved = eliminated_->solve(Eigen::VectorXd(rest(free_rows_)));
    x(free_rows_) = solved;
    return x;
  }

  Eigen::SparseMatrix<double> laplacian_;
  std::vector<int> component_;
  std::unique_ptr<Factorization> factored_;
  std::vector<int> eliminated_rows_, free_rows_;
  std::unique_ptr<Factorization> eliminated_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_DISTANCE_PINNED_LAPLACIAN_H
