// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_EDITING_INTERPOLATE_HARMONICALLY_H
#define CGAL_INTRINSIC_OPERATORS_EDITING_INTERPOLATE_HARMONICALLY_H

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <stdexcept>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief interpolates values at some vertices by the harmonic function, which has the least Dirichlet
energy, the integral of |grad x|^2.

On a Delaunay triangulation no weight of an inner edge is negative, so no value leaves the range of
the given ones (maximum principle). If border edges face obtuse angles, this needs a cover or a
refined triangulation. Values that rounding moves out of the range are set back.
\tparam Triangulation a model of `MeasuredTriangulation`
\param t the triangulation
\param rows vertices with values, by their rows
\param values a value per row
\param solver how to solve the linear problem
\return a value per vertex, at `t.input_vertex(v)`
\throws std::invalid_argument if sizes do not fit, a value is not finite, a row has two values, or a
component has none (the message names one of its rows)
\throws Invalid_input if a face has no area
\throws No_convergence if you asked for an iteration, and it does not converge
\complexity that of a sparse factorization, or linear for each step of an iteration
*/
template <MeasuredTriangulation Triangulation>
Eigen::VectorXd interpolate_harmonically(const Triangulation& t,
                                         std::span<const std::uint32_t> rows,
                                         const Eigen::VectorXd& values,
                                         Linear_solver solver = Linear_solver::automatic) {
  if (values.size() != static_cast<Eigen::Index>(rows.size()))
    throw std::invalid_argument("there must be a value per row that has one");
  const Eigen::SparseMatrix<double> l = cotangent_laplacian(t);
  Eigen::VectorXd x =
      solve_with_fixed_values(l, Eigen::VectorXd::Zero(l.rows()), rows, values, solver);
  if (rows.size() > 0 && internal::has_no_positive_entry_off_diagonal(l))
    x = x.cwiseMax(values.minCoeff()).cwiseMin(values.maxCoeff());
  return x;
}

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(interpolate_harmonically)
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_EDITING_INTERPOLATE_HARMONICALLY_H
