// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_METRIC_HYPERBOLIC_METRIC_H
#define CGAL_INTRINSIC_CONFORMAL_METRIC_HYPERBOLIC_METRIC_H

#include <CGAL/Intrinsic_conformal/angles/Ideal_surface_of.h>
#include <CGAL/Intrinsic_conformal/angles/Prescribed_angles.h>
#include <CGAL/Intrinsic_conformal/metric/conformal_metric.h>
#include <CGAL/Intrinsic_conformal/metric/flat_surface.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief finds scale factors with which the surface is hyperbolic, with prescribed angles: the
discrete uniformization of surfaces of genus 2 and more.

The triangles are hyperbolic ones, whose edges have the lengths l with
\f$2 \sinh(l_{ij} / 2) = w_i \lambda_{ij} w_j\f$, in the units of the user: that is the distance in
space of points of the hyperboloid model at the distance l. Any positive angles that leave an area
are those of exactly one metric: F faces have the area F pi minus the sum of all angles (Gauss and
Bonnet). On closed surfaces without cones, with full turns at all vertices, the area is -2 pi times
the Euler characteristic (Gu, Guo, Luo, Sun and Wu, A discrete uniformization theorem for
polyhedral surfaces II, 2018; Springborn, Ideal hyperbolic polyhedra and discrete uniformization,
2020). It is the minimum of a convex energy (Bobenko, Pinkall and Springborn, Discrete conformal
maps and ideal hyperbolic polyhedra, 2015, §6), with the gradient

    prescribed angle - sum of the angles of hyperbolic triangles

and a second derivative that is positive definite. `conformal_metric()` has the same solver, which
also flips in the same way: an edge is Delaunay among hyperbolic triangles if and only if it is
ideal Delaunay for the lambda lengths. The circumcircle of a triangle with corners in the
hyperboloid is a circle in the plane through these corners. There the angle A opposite an edge with
s = sinh(l/2) is that of the Euclidean triangle with sides lambda, and in the hyperbolic plane the
radius to an end of the edge meets the edge at the angle d with

    sin d = cos A / sqrt(1 + s^2).

Hyperbolic circles are empty if d + d' >= 0 for the two triangles of each edge, ideal ones if
cos A + cos A' >= 0, which is the same since s is. Triangle inequalities of lambda lengths, which
hold in ideal Delaunay triangulations, imply those of l, since the inverse of sinh is concave.

\tparam Triangulation, Parameters see `conformal_metric()`
\param t the triangulation. It is scaled by the result and ideal Delaunay afterwards
\param angles the angle around each vertex of the user; `flat_angles()` prescribes full turns
\param np the named parameters of `conformal_metric()`
\return the scale factors. The mean of u is not zero: it depends on the unit of lengths
\throws Invalid_input if the surface has a border; if there is not one angle per vertex, an angle is
  not positive, or angles leave no area to a component without free vertices
\complexity a sparse factorization and the flips for each of usually 5 to 10 steps
*/
template <IndexedTriangulation Triangulation, NamedParameters Parameters = parameters::Parameters<>>
  requires internal::Has_horocycles<Triangulation>
      Conformal_metric hyperbolic_metric(Triangulation& t, const Prescribed_angles& angles,
                                         const Parameters& np = parameters::default_values()) {
    internal::Ideal_surface_of<Triangulation> surface(t);
    return internal::conformal_metric(
        surface, angles, internal::conformal_options(np, internal::Geometry::hyperbolic));
  }

/*!
\brief takes lambda lengths of an ideal Delaunay triangulation as hyperbolic triangles, as
`hyperbolic_metric()` does.
\tparam Triangulation see `flat_surface()`
\param t the triangulation
\return the surface with the hyperbolic lengths of its sides; faces in the order of
  `faces(t.mesh())`, vertices by number
\complexity linear
*/
template <IndexedTriangulation Triangulation>
  requires internal::Has_horocycles<Triangulation>
      Surface_to_cut hyperbolic_surface(const Triangulation& t) {
    Surface_to_cut s = flat_surface(t);
    for (double& length : s.length) length = 2 * std::asinh(length / 2);
    s.vector.clear(); // in Euclid's plane
    return s;
  }

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_EUCLIDEAN(hyperbolic_metric, "uniformize()")
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_CONFORMAL_METRIC_HYPERBOLIC_METRIC_H
