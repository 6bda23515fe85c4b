// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_DOUBLY_COVERED_POLYGON_H
#define CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_DOUBLY_COVERED_POLYGON_H

#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Polyhedron_points.h>
#include <CGAL/Intrinsic_simplification/embedding/decrease_curvatures.h>

#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

/*
If the surface is a convex polygon, front and back, the pyramids become flat: near the end the
dihedral angles are nearly 0 along the border of the polygon, and nearly straight elsewhere. Then
the edges along the border are cut, and the two parts are laid out in the plane, from lengths alone.
\return the corners in the plane z = 0, if both parts are the same polygon up to rounding, and all
  vertices are its corners
*/
std::optional<Space_points> doubly_covered_polygon(const Glued_pyramids& p);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_DOUBLY_COVERED_POLYGON_H
