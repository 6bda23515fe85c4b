// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_FACTORIZATION_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_FACTORIZATION_H

#include <Eigen/Core>

#include <concepts>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief asks for a matrix that was factored once, for any number of right sides.

Syntax of \ref ::Factorization, where its meaning is described.
*/
template <class F>
concept Factorization = std::copyable<F> && requires(const F& f, const typename F::Vectors& b) {
  typename F::Matrix;
  { f.size() } -> std::same_as<Eigen::Index>;
  { f.solve(b) } -> std::convertible_to<typename F::Vectors>;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_FACTORIZATION_H
