// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_PACK_COMPONENTS_H
#define CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_PACK_COMPONENTS_H

#include <Eigen/Core>

#include <cstdint>
#include <span>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief moves the components of a map to the plane beside each other, so that their bounding boxes
are disjoint.

Boxes are put on shelves, one above the other, by falling height: a shelf is filled from left to
right, and is as high as its first box. Components move without turning and keep their sizes. The
lower left corner of all is the origin, and the width is about the height. One component alone stays
where it is.
\param uv a point, x and y, per row; it is moved, so that its coordinates are rounded
\param component a number for each row, the same for all rows of a component; `Gluing::none` for
  rows that belong to none and stay where they are
\param margin the distance between boxes, as a part of the side of a square with the area of all
\throws Invalid_input if sizes disagree, or a coordinate that is to be moved is not finite
\pre the margin is positive
\complexity O(n log n)
*/
void pack_components(Eigen::MatrixX2d& uv, std::span<const std::uint32_t> component,
                     double margin = 0.02);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_PACK_COMPONENTS_H
