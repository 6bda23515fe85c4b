// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_METRIC_CONFORMAL_METRIC_H
#define CGAL_INTRINSIC_CONFORMAL_METRIC_CONFORMAL_METRIC_H

#include <CGAL/Intrinsic_conformal/angles/Ideal_surface_of.h>
#include <CGAL/Intrinsic_conformal/angles/Prescribed_angles.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds the scale factors of a metric with prescribed angles, as `conformal_metric()` and
`hyperbolic_metric()` find them.
*/
struct Conformal_metric {
  /// `done`: the residual is at most the tolerance; `cap`: the number of iterations was reached;
  /// `stalled`: rounding hides how to go on; `cancelled`: by the visitor.
  Status status = Status::done;
  /// u at each vertex of the user, rounded to doubles: zero where it is free or isolated, and with
  /// mean zero on components without free vertices if the metric is flat.
  std::vector<double> u;
  /// The doubles nearest exp(u/2), for u before it is rounded.
  std::vector<double> scale_factors;
  /// What rounding took from the scale factors. Sums w of both define the metric: lambda_ij becomes
  /// w_i lambda_ij w_j exactly. Needles need these digits, see `scale_vertices()`.
  std::vector<double> scale_rests;
  /// Steps of Newton's method.
  unsigned iterations = 0;
  /// Flips in all.
  std::size_t flips = 0;
  /// The largest difference between an angle and the prescribed one, in radians, with all digits of
  /// the factors, computed in doubles. On a cover the angle is that of all copies of a vertex,
  /// divided by the number of sheets.
  double residual = std::numeric_limits<double>::infinity();
  /// A bound of this difference that is proven for `scale_factors`, and for `u` as it is, by
  /// enclosures of all angles; nothing if the arithmetic of the triangulation does not enclose
  /// values. A large u has fewer digits than its factor: u = 40 leaves 15 times the error.
  std::optional<double> proven_residual;
};

/// What a visitor of `conformal_metric()` or `hyperbolic_metric()` gets after each step.
struct Conformal_progress {
  unsigned iteration = 0; ///< from 1
  double residual = 0;    ///< see `Conformal_metric`
  double step = 1;        ///< the part of Newton's step that was taken
  std::size_t flips = 0;  ///< up to now
};

namespace internal {

struct Conformal_options {
  Geometry geometry = Geometry::euclidean;
  unsigned maximum_iterations = 300;
  double tolerance = 1e-10;
  std::function<bool(const Conformal_progress&)> progress{};
};

template <class Parameters>
Conformal_options conformal_options(const Parameters& np, Geometry geometry) {
  expect_names<tags::number_of_iterations, tags::tolerance, tags::visitor>(np);
  Conformal_options options;
  options.geometry = geometry;
  options.maximum_iterations = value_or<tags::number_of_iterations>(np, options.maximum_iterations);
  options.tolerance = value_or<tags::tolerance>(np, options.tolerance);
  options.progress = progress_of(np);
  return options;
}

// Throws as `conformal_metric()` and `hyperbolic_metric()` do.
Conformal_metric conformal_metric(Ideal_surface& surface, const Prescribed_angles& angles,
                                  const Conformal_options& options);

} // namespace internal

/*!
\brief finds scale factors with which the surface has prescribed angles: a discrete conformal map,
with flips.

Two metrics of a triangulation are discretely conformal if their lengths differ by factors at
vertices: \f$\tilde\lambda_{ij} = e^{(u_i + u_j)/2} \lambda_{ij}\f$, where Ptolemy's flips keep the
triangulation ideal Delaunay (§6.3 of the course). Among all of them exactly one, up to its size,
has given positive angles that satisfy the theorem of Gauss and Bonnet (Gu, Luo, Sun and Wu, A
discrete uniformization theorem for polyhedral surfaces, 2018; Springborn, Ideal hyperbolic
polyhedra and discrete uniformization, 2020). It is the minimum of a convex energy with the gradient

    prescribed angle - sum of the angles of Euclidean triangles with sides lambda

and the cotangent Laplacian of the ideal Delaunay triangulation as second derivative. Newton's
method finds it, in which a step is halved until neither the energy (Campen, Capouellez, Shen, Zhu,
Panozzo and Zorin, Efficient and robust discrete conformal equivalence with boundary, 2021) nor the
norm of its gradient rises at its end. All flips start from the triangulation of the step before.
Where rounding hides how to go on far from the solution, as factors differ by many powers of ten,
vertices are first scaled such that the lambda lengths at each have the same mean of logarithms.

The surface has no border. `make_domain()` with `Domain_kind::closed` makes the double of one that
has: two copies, glued along the border. Angles and results go by vertices of the user, so that both
copies get the same.

\tparam Triangulation a model of `IndexedTriangulation` with the traits
  `Ideal_hyperbolic_traits<FT>` or `Exact_ideal_hyperbolic_traits`
\tparam Parameters a model of `NamedParameters`
\param t the triangulation. It is scaled by the result and ideal Delaunay afterwards
\param angles the angle around each vertex of the user
\param np `number_of_iterations` (default: 300), a cap; `tolerance` (default: 1e-10), the residual
  in radians at which to stop; `visitor`, an object with `bool progress(const
  Conformal_progress&)`, which returns whether to go on
\throws Invalid_input if the surface has a border; if there is not one angle per vertex, an angle is
  not positive, or angles break the theorem of Gauss and Bonnet in a component without free
  vertices. That is checked in rational numbers if all angles are multiples of pi; else their sum
  may be wrong by 16 units in the last place of each angle, which are spread over all vertices
\complexity a sparse factorization and the flips for each of usually 5 to 8 steps
*/
template <IndexedTriangulation Triangulation, NamedParameters Parameters = parameters::Parameters<>>
  requires internal::Has_horocycles<Triangulation>
      Conformal_metric conformal_metric(Triangulation& t, const Prescribed_angles& angles,
                                        const Parameters& np = parameters::default_values()) {
    internal::Ideal_surface_of<Triangulation> surface(t);
    return internal::conformal_metric(
        surface, angles, internal::conformal_options(np, internal::Geometry::euclidean));
  }

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_EUCLIDEAN(conformal_metric, "uniformize()")
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_CONFORMAL_METRIC_CONFORMAL_METRIC_H
