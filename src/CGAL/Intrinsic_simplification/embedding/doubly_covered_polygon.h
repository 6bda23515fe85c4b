// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_DOUBLY_COVERED_POLYGON_H
#define CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_DOUBLY_COVERED_POLYGON_H

#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Precise_points.h>
#include <CGAL/Intrinsic_simplification/embedding/decrease_curvatures.h>

#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

struct Covered_polygon {
  Precise_points corners; // of the front, in the plane z = 0
  double difference;      // from those of the back, at most
};

/*
If the surface is a convex polygon, front and back, the pyramids become flat: near the end the
dihedral angles are nearly 0 along the border of the polygon, and nearly straight elsewhere. Then
the edges along the border are cut, and the two parts are laid out in the plane, from lengths alone.
\return the polygon, if both parts are nearly the same, and all vertices are its corners
*/
std::optional<Covered_polygon> doubly_covered_polygon(const Glued_pyramids& p);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_DOUBLY_COVERED_POLYGON_H
