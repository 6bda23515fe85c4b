// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_SURFACE_POINT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_SURFACE_POINT_H

#include <array>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief locates a point on a triangulated surface: barycentric coordinates (§2.3.2 of the course) in
the face of a halfedge.

The same type is used on the input and on the intrinsic triangulation. A point on an edge has one
weight that is zero, a point at a vertex two; a point may have several descriptions.
*/
struct Surface_point {
  /// Number of a halfedge that has a face.
  std::uint32_t halfedge = 0;
  /// Weights of the source of the halfedge, its target, and the third corner; they sum to 1.
  std::array<double, 3> weights{1, 0, 0};
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_SURFACE_POINT_H
