// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SOURCES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SOURCES_H

/*!
\file
All sources of the package `Intrinsic_simplification` and of those below it, for programs that do not link the library: exactly
one of their sources includes this file.
*/

#include <CGAL/Intrinsic_conformal_sources.h>
#include <CGAL/Intrinsic_simplification/embedding/Length_equations.cpp>
#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.cpp>
#include <CGAL/Intrinsic_simplification/embedding/Polyhedron_points.cpp>
#include <CGAL/Intrinsic_simplification/embedding/Pyramids.cpp>
#include <CGAL/Intrinsic_simplification/embedding/Whole_faces.cpp>
#include <CGAL/Intrinsic_simplification/embedding/certify_convex.cpp>
#include <CGAL/Intrinsic_simplification/embedding/decrease_curvatures.cpp>
#include <CGAL/Intrinsic_simplification/embedding/doubly_covered_polygon.cpp>
#include <CGAL/Intrinsic_simplification/embedding/embed_convex.cpp>
#include <CGAL/Intrinsic_simplification/embedding/remove_flat.cpp>

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SOURCES_H
