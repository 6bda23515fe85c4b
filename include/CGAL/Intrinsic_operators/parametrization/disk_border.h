// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_DISK_BORDER_H
#define CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_DISK_BORDER_H

#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief places the border of a disk in the plane.
*/
struct Border_map {
  /// The rows of the vertices of the border, counterclockwise: the surface is on the left.
  std::vector<std::uint32_t> rows;
  /// A point for each, x and y.
  Eigen::MatrixX2d positions;
};

namespace internal {

// The border of a disk, counterclockwise, and the lengths of its edges in scaled units.
struct Disk_border {
  std::vector<std::uint32_t> rows;
  std::vector<double> lengths; // from the vertex of the same place to the next
};

// \throws Invalid_input if the surface is not a disk with three vertices on its border, or is a
// cover
Disk_border disk_border(const Face_table& table, std::uint32_t sheets);
template <NumberedTriangulation Triangulation>
Disk_border disk_border(const Triangulation& t) {
  return disk_border(face_table(t), t.input().names().sheets);
}

Border_map circular_border(const Disk_border& border);
Border_map polygonal_border(const Disk_border& border,
                            const std::vector<std::array<double, 2>>& corners);

} // namespace internal

/*!
\brief maps the border of a disk to the unit circle, in proportion to length.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation of a disk
\return the map; the first vertex, the one with the least row, is at (1, 0)
\throws Invalid_input if the surface is not a disk: not connected, with handles, with no or more
  than one border, not manifold; if its border has less than three vertices; or if it is a cover
\complexity linear
*/
template <NumberedTriangulation Triangulation>
Border_map circular_border(const Triangulation& t) {
  return internal::circular_border(internal::disk_border(t));
}

/*!
\brief maps the border of a disk to a convex polygon, in proportion to length.

Each corner gets the vertex nearest to it in proportion to length. Between corners the map is
proportional to length. The first corner belongs to the vertex with the least row.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation of a disk
\param corners the corners of the polygon, three at least \pre convex, counterclockwise
\return the map
\throws Invalid_input as `circular_border()` does
\throws std::invalid_argument if the polygon does not turn left at each corner, or has more corners
than the border has vertices
\complexity linear
*/
template <NumberedTriangulation Triangulation>
Border_map polygonal_border(const Triangulation& t,
                            const std::vector<std::array<double, 2>>& corners) {
  return internal::polygonal_border(internal::disk_border(t), corners);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_DISK_BORDER_H
