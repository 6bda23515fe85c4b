// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_LAYOUT_LAY_OUT_IN_PLANE_H
#define CGAL_INTRINSIC_CONFORMAL_LAYOUT_LAY_OUT_IN_PLANE_H

#include <CGAL/Intrinsic_geodesics/cuts/cut_open.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/*!
\file
Layouts in the plane of surfaces that are flat except at cones: the surface is cut to disks through
all cones, and each disk is developed, triangle after triangle.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a part of a cut with one motion of the plane: it takes the places of points on one side to
those on the other.
*/
struct Layout_seam {
  /// Sides of faces with the one copy of the seam, one after another.
  std::vector<std::uint32_t> sides;
  /// The sides with the other copy, in the same order; each runs against its partner.
  std::vector<std::uint32_t> partners;
  /// The angle of the motion in radians, between -pi and pi.
  double rotation = 0;
  /// What the motion adds after the rotation about the origin.
  std::array<double, 2> translation{};
};

/*!
\brief is the layout of a flat surface in the plane.
*/
struct Flat_layout {
  /// The surface cut open: disks, and their vertices.
  Opened_surface surface;
  /// The place of each vertex of `surface`, in the units of the lengths. A component begins at the
  /// origin; components may overlap.
  Eigen::MatrixX2d positions;
  /// The parts of the cut.
  std::vector<Layout_seam> seams;
  /// The largest difference of a side in the plane, as a vector, from the side of the triangle in
  /// its direction, relative to the longest side of the triangle.
  double largest_side_error = 0;
  /// The largest distance by which the motion of a seam misses a vertex, relative to the extent of
  /// the layout.
  double largest_seam_error = 0;
};

/*!
\brief lays a surface that is flat except at cones out in the plane.

The surface is cut by `cut_to_disk()`, through all cones. Directions of triangles follow from one to
the next, breadth first; places are then those of least squares, for the differences of sides in the
plane from the sides of triangles relative to their lengths, so that rounding does not accumulate.
The layout is an immersion: parts may overlap.

\param s the surface with Euclid's lengths, with any number of components, handles and borders
\param cones the vertices inside where angles do not sum to 2 pi
\param roots how many roots the search for a short cut tries
\return the layout. Where the surface is not flat at a vertex that is not a cone, the errors tell.
\throws Invalid_input if the surface is not oriented, if no triangle has the sides of a face, and as
  `cut_to_disk()` does
\pre `validate(s.gluing)` does not throw
\complexity those of `cut_to_disk()` and of a sparse factorization
*/
Flat_layout lay_out_in_plane(const Surface_to_cut& s, std::span<const std::uint32_t> cones = {},
                             std::size_t roots = 8);

/*!
\brief certifies, with exact predicates, that no triangle of a layout turns over.
\param layout the layout
\return the certificate; the border is simple only if the layout is one disk that does not overlap
\complexity O(n log n)
*/
Map_certificate certify_map(const Flat_layout& layout);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_CONFORMAL_LAYOUT_LAY_OUT_IN_PLANE_H
