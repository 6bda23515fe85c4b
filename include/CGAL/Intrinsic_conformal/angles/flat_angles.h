// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_ANGLES_FLAT_ANGLES_H
#define CGAL_INTRINSIC_CONFORMAL_ANGLES_FLAT_ANGLES_H

#include <CGAL/Intrinsic_conformal/angles/Ideal_surface_of.h>
#include <CGAL/Intrinsic_conformal/angles/Prescribed_angles.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// A full turn at each row; rows on the mirror of a doubled surface are free. \throws Invalid_input
Prescribed_angles flat_angles(const Ideal_surface& surface);

// Places cones in each component. \throws Invalid_input if that many cannot have its curvature
void place_cones(Ideal_surface& surface, std::size_t number, Prescribed_angles& angles);

// Places cones until the scale is predicted to stay in a range. \throws Invalid_input if it does
// not, however many there are
void place_cones_within(Ideal_surface& surface, double ratio, Prescribed_angles& angles);

} // namespace internal

/*!
\brief prescribes a flat surface: a full turn at each vertex; the border, if there is one, is free.

The scale factor of a free vertex stays 1, so that the map is as isometric there as it can be
(Springborn, Schröder and Pinkall, Conformal equivalence of triangle meshes, 2008).

\tparam Triangulation see `conformal_metric()`
\param t the triangulation, the double of a surface with border
\throws Invalid_input if `t` has a border
\complexity linear
*/
template <IndexedTriangulation Triangulation>
  requires internal::Has_horocycles<Triangulation> Prescribed_angles flat_angles(Triangulation& t) {
    return internal::flat_angles(internal::Ideal_surface_of<Triangulation>(t));
  }

/*!
\brief places cones where a flat metric is distorted most, and prescribes a full turn elsewhere.

One after another: the linear problem \f$L u = K^T - K\f$ is solved, where K is the curvature of the
surface, and \f$K^T\f$ that of the cones so far, with the rest spread over the surface; the next
cone is where |u| is largest (Ben-Chen, Gotsman and Bunin, Conformal flattening by curvature
prescription and metric scaling, 2008). Angles are multiples of a quarter turn, so that layouts fit
together across cuts by quarter turns: \f$3\pi/2\f$ where u is negative, as at the tips of fingers,
\f$5\pi/2\f$ where it is positive, and others where their sum demands it. On the cover of a cloud
of points, whose sheets share faces, the curvature may be no multiple of a quarter turn; then the
last cone has an angle that is none.

\tparam Triangulation see `conformal_metric()`
\param t the triangulation, which becomes ideal Delaunay with all scale factors 1
\param number how many cones each component gets; its border, if there is one, is free
\return the angles, all of them multiples of pi
\throws Invalid_input if `t` has a border, or if so many cones cannot have the curvature of a
  component: a sphere needs at least three, a torus none or two
\complexity a sparse factorization, and a solution for each cone
*/
template <IndexedTriangulation Triangulation>
  requires internal::Has_horocycles<Triangulation>
      Prescribed_angles place_cones(Triangulation& t, std::size_t number) {
    internal::Ideal_surface_of<Triangulation> surface(t);
    Prescribed_angles angles = internal::flat_angles(surface);
    internal::place_cones(surface, number, angles);
    return angles;
  }

/*!
\brief places as many cones as keep the scale of the surface in a range, and prescribes a full turn
elsewhere.

Numbers of cones are tried in growing order, with steps of a quarter, for each of which
`place_cones(t, number)` chooses the cones. The first one is taken for which the linear problem has
\f$e^{u}\f$ within the range. It predicts the scale of `conformal_metric()`, which is not computed;
where u is large, that scale differs by more.

\tparam Triangulation see `conformal_metric()`
\param t the triangulation, which becomes ideal Delaunay with all scale factors 1
\param ratio of the largest to the least scale \f$e^u\f$ of lengths in each component, free vertices
  included; above 1
\return the angles, all of them multiples of pi
\throws Invalid_input if `t` has a border, or no number of cones is enough
\complexity a sparse factorization for each number that is tried, and a solution for each cone
*/
template <IndexedTriangulation Triangulation>
  requires internal::Has_horocycles<Triangulation>
      Prescribed_angles place_cones_within(Triangulation& t, double ratio) {
    internal::Ideal_surface_of<Triangulation> surface(t);
    Prescribed_angles angles = internal::flat_angles(surface);
    internal::place_cones_within(surface, ratio, angles);
    return angles;
  }

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_EUCLIDEAN(flat_angles, "uniformize()")
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_EUCLIDEAN(place_cones, "uniformize()")
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_EUCLIDEAN(place_cones_within, "uniformize()")
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_CONFORMAL_ANGLES_FLAT_ANGLES_H
