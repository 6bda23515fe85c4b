// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_LAPLACIAN_FACTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_LAPLACIAN_FACTOR_H

#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/Elimination.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/row_number.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The factor of a Laplacian and a diagonal: unit triangular, minus `value` below the diagonal, times the pivots, times its transpose.
struct Laplacian_factor {
  // leaves the numbers to be written
  explicit Laplacian_factor(std::shared_ptr<const Elimination> e)
      : elimination(std::move(e)), value(std::make_unique_for_overwrite<double[]>(
                                       row_number(elimination->column_begin.back()))) {}

  std::shared_ptr<const Elimination> elimination;
  std::unique_ptr<double[]> value; // not a vector, which would write megabytes of zeros first
  std::vector<double> pivot;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_LAPLACIAN_FACTOR_H
