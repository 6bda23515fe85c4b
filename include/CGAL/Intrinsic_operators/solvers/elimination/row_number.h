// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_ROW_NUMBER_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_ROW_NUMBER_H

#include <Eigen/Core>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// A row of a matrix as the index of a standard container: Eigen's indices have a sign. \pre not negative
inline std::size_t row_number(Eigen::Index row) { return static_cast<std::size_t>(row); }

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_ROW_NUMBER_H
