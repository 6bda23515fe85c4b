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
\brief is a geodesic Bezier curve: the control polygon after some rounds of subdivision, along edges of an intrinsic triangulation.
\tparam Triangulation a model of `GeodesicTriangulation`
*/
template <class Triangulation>
struct Bezier_curve {
  /// `done`; `stalled` if control points are not connected or a vertex could not be inserted; or
  /// that of `Geodesic_finder`. Unless it is `done`, there is no curve.
  Status status = Status::done;
  /// Number of rounds.
  unsigned rounds = 0;
  /// Degree d of the curve.
  std::size_t degree = 0;
  /// Control points after all rounds, d 2^rounds + 1. Number k d is on the curve, at k / 2^rounds.
  std::vector<typename Triangulation::vertex_descriptor> control_points;
  /// The way from the first control point to the last one, through all of them, along edges. It may
  /// cross itself.
  std::vector<typename Triangulation::halfedge_descriptor> halfedges;
  /// Vertices where it crosses itself, but for control points. Like control points they are to be
  /// fixed in a network.
  std::vector<typename Triangulation::vertex_descriptor> crossings;
  /// Length of the control polygon, in the units of the input.
  double length = 0;
  /// What was done to make its sides geodesic.
  Shortening_result shortening;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_BEZIER_BEZIER_CURVE_H
