// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_BEZIER_BEZIER_CURVE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_BEZIER_BEZIER_CURVE_H

#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_triangulations/geodesics/shortening/Shortening_result.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is the midpoint of a geodesic, where a curve was subdivided.
\tparam Triangulation the type of the triangulation
*/
template <class Triangulation>
struct Geodesic_midpoint {
  /// The vertex there.
  typename Triangulation::vertex_descriptor vertex;
  /// Where it is on the edge that it was inserted on, by the lengths of the halves: 0 at the source and 1 at the target. With exact
  /// traits it is rounded on the input, and told to 1e-12. Where no vertex can be, it is within 2^-10 of the middle of the side.
  double parameter = 0;
  /// Whether it was inserted; else it is a vertex that was there already.
  bool is_new = false;
};

/*!
\brief is a geodesic Bezier curve: the control polygon after some rounds of subdivision, along edges of an intrinsic triangulation.
\tparam Triangulation a model of `GeodesicTriangulation`
*/
template <class Triangulation>
struct Bezier_curve {
  /// `done`; `stalled` if control points are not connected or a midpoint could not be inserted; or that of `shorten_curves()`.
  /// Unless it is `done`, there is no curve.
  Status status = Status::done;
  /// Number of rounds.
  unsigned rounds = 0;
  /// Degree d of the curve.
  std::size_t degree = 0;
  /// Control points after all rounds, d 2^rounds + 1. Number k d is on the curve, at k / 2^rounds.
  std::vector<typename Triangulation::vertex_descriptor> control_points;
  /// The way from the first control point to the last one, through all of them, along edges.
  std::vector<typename Triangulation::halfedge_descriptor> halfedges;
  /// Midpoints, in the order in which they were found.
  std::vector<Geodesic_midpoint<Triangulation>> midpoints;
  /// Length of the control polygon, in the units of the input.
  double length = 0;
  /// What was done to make its sides geodesic.
  Shortening_result shortening;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_BEZIER_BEZIER_CURVE_H
