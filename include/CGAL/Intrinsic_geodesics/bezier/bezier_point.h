// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_BEZIER_BEZIER_POINT_H
#define CGAL_INTRINSIC_GEODESICS_BEZIER_BEZIER_POINT_H

#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_geodesics/queries/Geodesic_finder.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// A point of a curve, and which of its pieces it is in.
struct Place_on_curve {
  std::size_t piece;
  Surface_point point;
};

// The point that divides a curve by length.
inline Place_on_curve place_on_curve(const Input& input, const Traced_curve& curve, double share) {
  const auto end_of_piece = [&](std::size_t piece, std::size_t end) {
    return seen_in_face(input, curve.points[piece + end], curve.faces[piece]);
  };
  std::vector<double> lengths;
  double all = 0;
  for (std::size_t i = 0; i < curve.faces.size(); ++i) {
    const Unscaled_vector v = vector_between(input, end_of_piece(i, 0), end_of_piece(i, 1));
    lengths.push_back(std::hypot(v[0], v[1]));
    all += lengths.back();
  }
  double left = share * all;
  std::size_t piece = 0;
  for (; piece + 1 < lengths.size() && left > lengths[piece]; ++piece) left -= lengths[piece];
  Surface_point p = end_of_piece(piece, 0);
  const Surface_point q = end_of_piece(piece, 1);
  double x = lengths[piece] > 0 ? std::clamp(left / lengths[piece], 0.0, 1.0) : 0.0;
  // Up to rounding of 8,000 sums it is an end of a piece, perhaps a vertex: that one is exact.
  for (const double end : {0., 1.})
    if (std::abs(x - end) * lengths[piece] <= 0x1p-40 * all) x = end;
  for (std::size_t k = 0; k < 3; ++k) p.weights[k] = (1 - x) * p.weights[k] + x * q.weights[k];
  return {piece, p};
}

} // namespace internal

/*!
\brief returns the point that divides a curve by length.
\tparam Triangulation a model of `NumberedTriangulation` that keeps its input
\param t the triangulation
\param curve the result of `trace_curve()` or a `Geodesic_finder`
\param share the length up to the point as a part of the whole; beyond 0 and 1 it is the start or
  the end
\return the point, rounded, in the face where that part of the curve is straight
\pre the curve has at least two points
\complexity linear
*/
template <NumberedTriangulation Triangulation>
Surface_point point_on_curve(const Triangulation& t, const Traced_curve& curve, double share) {
  return internal::place_on_curve(internal::kept_input(t), curve, share).point;
}

/*!
\brief is a point on a Bezier curve, see `bezier_point()`.
*/
struct Bezier_point {
  /// `done`; else the reason why the construction failed, and `point` is not set.
  Status status = Status::done;
  /// The point on the input.
  Surface_point point{};
};

/*!
\brief evaluates a Bezier curve at one parameter, by de Casteljau's algorithm with a new geodesic in
  every step.

In each step, geodesics join consecutive points and are divided as x to 1 - x, until one point
remains (§5.3 of the course with any parameter instead of 1/2). Each point depends on its parameter
only. So the curve jumps where a geodesic changes sides at a bump as x grows; that of
`make_bezier_curve()` does not.

The triangulation stays as it was. Sides of the control polygon may cross.
\tparam Triangulation a model of `GeodesicTriangulation` and of `RefinableTriangulation`
\param t the triangulation of `find`
\param find finds geodesics in `t`
\param control_points points of the input, one at least
\param x the parameter, from 0 to 1
\complexity d (d + 1) / 2 queries of `find` for a curve of degree d
*/
template <GeodesicTriangulation Triangulation>
  requires RefinableTriangulation<Triangulation>
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
