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
\brief places the borders of disks in the plane.
*/
struct Border_map {
  /// The rows of the vertices of each border, counterclockwise: the surface is on the left.
  std::vector<std::uint32_t> rows;
  /// A point for each, x and y.
  Eigen::MatrixX2d positions;
};

namespace internal {

// The border of a disk, counterclockwise, the lengths of its edges in scaled units, and its area.
struct Disk_border {
  std::vector<std::uint32_t> rows;
  std::vector<double> lengths; // from the vertex of the same place to the next
  double area = 0;
};

// The border of each component, in the order of their least rows.
// \throws Invalid_input if one is not a disk with three vertices on its border, or the surface is a
// cover
std::vector<Disk_border> disk_borders(const Face_table& table, std::uint32_t sheets);
template <NumberedTriangulation Triangulation>
std::vector<Disk_border> disk_borders(const Triangulation& t) {
  return disk_borders(face_table(t), t.input().names().sheets);
}

Border_map circular_border(const std::vector<Disk_border>& borders);
Border_map polygonal_border(const std::vector<Disk_border>& borders,
                            const std::vector<std::array<double, 2>>& corners);

} // namespace internal

/*!
\brief maps the border of a disk to the unit circle, in proportion to length.

Of several disks, the largest has a circle of radius 1, and areas of circles are in proportion to
those of disks, but none has a radius below 1/1000. They lie beside each other, see
`pack_components()`.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation of a disk, or of several
\return the map; of one disk, the first vertex, the one with the least row, is at (1, 0)
\throws Invalid_input if a component of the surface is not a disk: if it has handles, no or more
  than one border, or is not manifold; if its border has less than three vertices; or if the
  surface is a cover
\complexity linear, and O(n log n) in the number of disks
*/
template <NumberedTriangulation Triangulation>
Border_map circular_border(const Triangulation& t) {
  return internal::circular_border(internal::disk_borders(t));
}

/*!
\brief maps the border of a disk to a convex polygon, in proportion to length.

Each corner gets the vertex nearest to it in proportion to length. Between corners the map is
proportional to length. The first corner belongs to the vertex with the least row. Several disks
have polygons beside each other, with sizes as those of `circular_border()`.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation of a disk, or of several
\param corners the corners of the polygon, three at least \pre convex, counterclockwise
\return the map
\throws Invalid_input as `circular_border()` does
\throws std::invalid_argument if the polygon does not turn left at each corner, or has more corners
than a border has vertices
\complexity as that of `circular_border()`
*/
template <NumberedTriangulation Triangulation>
Border_map polygonal_border(const Triangulation& t,
                            const std::vector<std::array<double, 2>>& corners) {
  return internal::polygonal_border(internal::disk_borders(t), corners);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_DISK_BORDER_H
