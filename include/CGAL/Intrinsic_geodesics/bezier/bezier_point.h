// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_BEZIER_BEZIER_POINT_H
#define CGAL_INTRINSIC_GEODESICS_BEZIER_BEZIER_POINT_H

#include <CGAL/Intrinsic_geodesics/queries/Geodesic_finder.h>
#include <CGAL/Intrinsic_geodesics/queries/point_on_curve.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a point that `bezier_point()` has found.
*/
struct Bezier_point {
  /// `done`, or why a geodesic was not found; then there is no point.
  Status status = Status::done;
  /// The point on the input.
  Surface_point point{};
};

/*!
\brief evaluates a Bezier curve at one parameter, by de Casteljau's algorithm with a new geodesic in every step.

Points next to each other are joined by geodesics, and these are divided as x to 1 - x, until one point is left (§5.3 of the course
with any parameter in place of 1/2). Every point is as it is whatever other points are; but where a geodesic changes from one side of a bump to the
other as x grows, the curve jumps. `make_bezier_curve()` does not.

Nothing is left behind in the triangulation. Sides of the control polygon may cross.
\tparam Triangulation a model of `RefinableTriangulation`, see `Geodesic_finder`
\param t the triangulation that `find` was made for
\param find finds geodesics in `t`
\param control_points points of the input, one at least
\param x the parameter, from 0 to 1
\complexity d (d + 1) / 2 queries of `find` for a curve of degree d
*/
template <class Triangulation>
Bezier_point bezier_point(const Triangulation& t, Geodesic_finder<Triangulation>& find,
                          std::vector<Surface_point> control_points, double x) {
  for (std::vector<Surface_point>& p = control_points; p.size() > 1; p.pop_back())
    for (std::size_t i = 0; i + 1 < p.size(); ++i) {
      const Geodesic_path path = find(std::vector<Surface_point>{p[i], p[i + 1]});
      if (path.status != Status::done) return {path.status, {}};
      if (path.points.size() > 1) p[i] = point_on_curve(t, path, x); // else they are one vertex
    }
  return {Status::done, control_points.front()};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_BEZIER_BEZIER_POINT_H
