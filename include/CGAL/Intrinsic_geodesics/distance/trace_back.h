// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_TRACE_BACK_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_TRACE_BACK_H

#include <CGAL/Intrinsic_geodesics/distance/Distance_field.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

/*!
\file
Shortest paths, from the point back to the source. The image of the source gives the straight line
of a piece of a path: the faces along it are laid out one after the other, and no window is
needed. Where rounding may decide on which side of a vertex the line passes, the path goes through
the vertex, and on by the last piece of the shortest path to it: so a walk always finds its way.
*/

namespace CGAL::Intrinsic_triangulations::internal {

/// A point of a face: the side in whose order weights are given.
struct Path_place {
  std::uint32_t side;            ///< a corner
  std::array<double, 3> weights; ///< of the source of the side, its target, the apex
};

/// A shortest path, followed backwards.
struct Traced_back {
  /// `done`, or why the source was not found.
  Status status;
  /// The path from the point to the source; a piece lies in the face of the place where it ends.
  std::vector<Path_place> places;
  /// A direction in which the path leaves the last of its places, in the frame of the side there:
  /// far along the first piece of the path.
  Plane_vector<double> departure;
};

/// follows the path from a vertex, through a number of straight pieces at most.
Traced_back trace_back(const Distance_field& field, std::uint32_t v,
                       std::size_t pieces = std::numeric_limits<std::size_t>::max());
/// follows the path from a point in a face.
Traced_back trace_back(const Distance_field& field, const Point_in_face& p);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_TRACE_BACK_H
