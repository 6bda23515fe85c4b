// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_SHORTEST_PATH_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_SHORTEST_PATH_H

#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a shortest path over the faces of a triangulation.
*/
struct Shortest_path {
  /// `done`; `stalled` if no source can be reached within the search; `inaccurate` or `cap` if
  /// rounding has led astray: the end of the path is there, its beginning is missing.
  Status status = Status::done;
  /// The source, a point on each edge that is crossed, the vertices that it goes through, and the
  /// end. The piece that begins at a point lies in the face of its halfedge. Where a path on a
  /// cover passes from one copy of a vertex to another, there are both.
  std::vector<Surface_point> points;
  /// Whether the points are those of the input, not of the triangulation: of a search on the faces
  /// under a cover.
  bool is_on_input = false;
  /// Its length, in the units of the input: the distance.
  double length = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_SHORTEST_PATH_H
