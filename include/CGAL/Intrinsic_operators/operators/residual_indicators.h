// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_OPERATORS_RESIDUAL_INDICATORS_H
#define CGAL_INTRINSIC_OPERATORS_OPERATORS_RESIDUAL_INDICATORS_H

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/reaction_diffusion.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// The norm in which an error is estimated.
enum class Error_norm {
  energy, ///< |||e|||^2 = integral of a |grad e|^2 + c e^2
  L2      ///< |e|^2 = integral of e^2
};

/// The condition on the border.
enum class Border_condition {
  natural, ///< no flux through it
  values   ///< given values: no error is estimated there
};

namespace internal {

// Computes the indicators of one solution.
template <class Triangulation>
class Residual_estimator {
  using Mesh = typename Triangulation::Mesh;
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Face = typename Triangulation::face_descriptor;
  using Real = long double; // fourth powers of lengths are in its range, whatever the unit

public:
  Residual_estimator(const Triangulation& t, const Reaction_diffusion& equation,
                     const Eigen::VectorXd& u, const Eigen::VectorXd& f, Error_norm norm,
                     Border_condition border)
      : t_(t), mesh_(t.mesh()), equation_(equation), u_(u), f_(f), norm_(norm), border_(border) {}

  double indicator(Face f) const {
    const Halfedge h = halfedge(f, mesh_), n = next(h, mesh_), l = next(n, mesh_);
    const Real size = std::max({length(h), length(n), length(l)});
    Real sum = face_weight(size) * squared_residual(f, {h, n, l});
    for (const Halfedge g : {h, n, l}) sum += edge_weight(length(g)) * squared_jump(g) * length(g);
    const auto result = static_cast<double>(std::sqrt(sum));
    if (!std::isfinite(result)) throw_degenerate_face(t_, f);
    return result;
  }

private:
  Real squared_length(Halfedge h) const { return t_.squared_length(edge(h, mesh_)); }
  Real length(Halfedge h) const { return std::sqrt(squared_length(h)); }
  bool is_border(Halfedge h) const {
    return face(h, mesh_) == boost::graph_traits<Mesh>::null_face();
  }
  // at the corner where a halfedge starts
  Real at(const Eigen::VectorXd& function, Halfedge h) const {
    return function[t_.input_vertex(source(h, mesh_))];
  }

  // min(h, sqrt(a/c)): beyond that length diffusion has no effect
  Real resolved(Real size) const {
    return std::min(size, std::sqrt(Real(equation_.diffusion) / equation_.reaction));
  }
  Real norm_weight(Real s) const {
    return norm_ == Error_norm::L2 ? s * s / equation_.diffusion : 1;
  }
  Real face_weight(Real size) const {
    const Real s = resolved(size);
    return norm_weight(s) * s * s / equation_.diffusion;
  }
  Real edge_weight(Real size) const {
    const Real s = resolved(size);
    return norm_weight(s) * s / equation_.diffusion;
  }

  // the integral of (f - c u)^2 over a face; div grad u is zero there
  Real squared_residual(Face f, const std::array<Halfedge, 3>& sides) const {
    std::array<Real, 3> r;
    for (std::size_t k = 0; k < 3; ++k)
      r[k] = at(f_, sides[k]) - equation_.reaction * at(u_, sides[k]);
    return t_.area(f) / 6 *
           (r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[0] * r[1] + r[1] * r[2] + r[2] * r[0]);
  }

  // the share of a face in the squared jump of the flux across one of its sides
  Real squared_jump(Halfedge h) const {
    const Halfedge o = opposite(h, mesh_);
    if (is_border(o)) {
      const Real flux = border_ == Border_condition::natural ? outward_flux(h) : 0;
      return flux * flux;
    }
    const Real jump = outward_flux(h) + outward_flux(o);
    return jump * jump / 2;
  }

  // a times the normal derivative of u on side ij of face ijk: from k to the foot of its altitude
  // p, u changes by u(p) - u_k over the length 2A / |ij|
  Real outward_flux(Halfedge h) const {
    const Halfedge jk = next(h, mesh_), ki = next(jk, mesh_);
    const Real ij = squared_length(h);
    const Real x = (ij + squared_length(ki) - squared_length(jk)) / (2 * ij);
    const Real u_i = at(u_, h), u_k = at(u_, ki);
    const Real rise = (u_i - u_k) + x * (at(u_, jk) - u_i);
    return equation_.diffusion * rise * std::sqrt(ij) / (2 * t_.area(face(h, mesh_)));
  }

  const Triangulation& t_;
  const Mesh& mesh_;
  const Reaction_diffusion& equation_;
  const Eigen::VectorXd& u_;
  const Eigen::VectorXd& f_;
  Error_norm norm_;
  Border_condition border_;
};

} // namespace internal

/*!
\brief estimates the error of a solution of -a div grad u + c u = f by its residual (Verfürth 1998):

    eta_T^2 = w_T |f - c u|^2_T  +  1/2 sum over sides E of T of w_E |[a du/dn]|^2_E
    w_T = s_T^2 / a,      w_E = s_E / a            in the energy norm
    w_T = s_T^4 / a^2,    w_E = s_E^3 / a^2        in the L2 norm
    s = min(h, sqrt(a/c)),    h_T the longest side of T, h_E the length of E

where [a du/dn] is the jump of the flux across a side; on the border it is the flux, and counts
twice. Only lengths and areas of the intrinsic triangulation enter.

Let u be the solution by the method of Galerkin (with the Galerkin mass matrix, not the lumped one),
and f piecewise linear. In the energy norm, the root of the sum of the squares bounds the error up
to a factor that depends on the least angle of the faces only, not on a, c and h; and the error
bounds it likewise (Verfürth, Robust a posteriori error estimators for a singularly perturbed
reaction-diffusion equation, Numerische Mathematik 78, 1998).

In the L2 norm the factor depends on the surface too (Aubin and Nitsche's trick), and needs
solutions with square integrable second derivatives. Where a total angle is above 2 pi, the border
is reentrant or h is larger than sqrt(a/c), eta_T is only an indicator.

**Point sources** at vertices have infinite energy: estimate in the L2 norm. They do not change the
indicators, since the bound uses an interpolant that is exact at vertices (Araya, Behrens,
Rodríguez, A posteriori error estimates for elliptic problems with Dirac delta source terms,
Numerische Mathematik 105, 2006): f is the density without them.

\tparam Triangulation a model of `MeasuredTriangulation`
\param t the triangulation
\param equation the coefficients
\param u the solution, at the vertices in the numbering of the input
\param f the right side, likewise
\param norm the norm of the error
\param np optional named parameters:
  - `border_condition(x)`: the condition on the border, a `Border_condition`. Default: `natural`.
\return eta_T, at the numbers of faces; zero at numbers without a face
\throws std::invalid_argument if a coefficient is out of its range, or a vector has the wrong size
\throws Invalid_input if a face has no area
\complexity linear
*/
template <MeasuredTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
std::vector<double> residual_indicators(const Triangulation& t, const Reaction_diffusion& equation,
                                        const Eigen::VectorXd& u, const Eigen::VectorXd& f,
                                        Error_norm norm,
                                        const NP& np = parameters::default_values()) {
  internal::expect_names<internal::tags::border_condition>(np);
  const auto border =
      internal::value_or<internal::tags::border_condition>(np, Border_condition::natural);
  internal::check(equation);
  const int size = checked_matrix_size(t);
  if (u.size() != size || f.size() != size)
    throw std::invalid_argument("the solution and the right side must have a value per vertex");
  const internal::Residual_estimator<Triangulation> estimator(t, equation, u, f, norm, border);
  std::vector<double> indicators(t.numbers().face_capacity(t.mesh()), 0);
  for (const typename Triangulation::face_descriptor face : faces(t.mesh()))
    indicators[t.index(face)] = estimator.indicator(face);
  return indicators;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_OPERATORS_RESIDUAL_INDICATORS_H
