// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_EDITING_HEAT_FLOW_H
#define CGAL_INTRINSIC_OPERATORS_EDITING_HEAT_FLOW_H

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/solvers/Chosen_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>

#include <stdexcept>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief smooths functions by letting heat flow for a time, one step of the implicit Euler method:

    (M + t L) x = M x_0

with the cotangent Laplacian L and the lumped mass M. It is stable for any time. On a Delaunay
triangulation of a cover, or one without obtuse angles at the border, the maximum principle holds:
no value leaves the range of the old values. Sums weighted by mass stay the same.

The coordinates of the vertices in space are functions too: smoothing them is implicit fairing
(Desbrun, Meyer, Schröder and Barr 1999), a step of mean curvature flow. For the next step build the
triangulation of the new points. Steps with the same operator are conformalized flow, which does not
pinch (Kazhdan, Solomon and Ben-Chen 2012).

Rows are those of vertices, `t.input_vertex(v)`. Isolated ones keep their values.
*/
class Heat_flow {
public:
  /*!
  \brief factors the operator.
  \tparam Triangulation a model of `MeasuredTriangulation`
  \param t the triangulation; no reference to it is kept
  \param time the time, in units of area: about the square of the radius of averaging
  \param solver how to solve for steps, of any number of functions
  \throws std::invalid_argument if the time is negative or not finite
  \throws Invalid_input if a face has no area
  \complexity that of a sparse factorization
  */
  template <MeasuredTriangulation Triangulation>
  Heat_flow(const Triangulation& t, double time, Linear_solver solver = Linear_solver::automatic)
      : mass_(lumped_mass_matrix(t).diagonal()),
        solver_(internal::chosen_factorization(checked(time) * cotangent_laplacian(t),
                                               positive(mass_), solver)) {}

  /*!
  \brief lets the heat flow.
  \param values a row per vertex, a column per function
  \return the new values
  \throws std::invalid_argument if there is not a row per vertex
  \throws No_convergence if an iteration does not converge
  \complexity linear in the entries of the factor, for each column
  */
  Eigen::MatrixXd step(const Eigen::MatrixXd& values) const;

private:
  static double checked(double time) {
    if (!(time >= 0) || !std::isfinite(time))
      throw std::invalid_argument("the time must be finite and not negative");
    return time;
  }

  static const Eigen::VectorXd& positive(Eigen::VectorXd& mass) {
    for (double& m : mass)
      if (!(m > 0)) m = 1; // any positive mass: isolated vertices exchange no heat
    return mass;
  }

  Eigen::VectorXd mass_;
  internal::Chosen_factorization<double> solver_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_EDITING_HEAT_FLOW_H
