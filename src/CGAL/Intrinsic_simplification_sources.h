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
#include <CGAL/Intrinsic_simplification/embedding/compress_triangles.cpp>
#include <CGAL/Intrinsic_simplification/embedding/decrease_curvatures.cpp>
#include <CGAL/Intrinsic_simplification/embedding/doubly_covered_polygon.cpp>
#include <CGAL/Intrinsic_simplification/embedding/embed_convex.cpp>
#include <CGAL/Intrinsic_simplification/embedding/remove_flat.cpp>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Chart_grid.cpp>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Developed_faces.cpp>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Frame_maps.cpp>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Length_chain.cpp>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_charts.cpp>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Strip_names.cpp>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Value_recipes.cpp>
#include <CGAL/Intrinsic_simplification/isometry/lengths/chains_of_lengths.cpp>
#include <CGAL/Intrinsic_simplification/isometry/lengths/grid_points.cpp>
#include <CGAL/Intrinsic_simplification/isometry/search/Canonical_form.cpp>
#include <CGAL/Intrinsic_simplification/isometry/search/Dart_matching.cpp>
#include <CGAL/Intrinsic_simplification/isometry/search/Isometry_search.cpp>
#include <CGAL/Intrinsic_simplification/isometry/search/Length_classes.cpp>
#include <CGAL/Intrinsic_simplification/isometry/search/compare_sizes.cpp>
#include <CGAL/Intrinsic_simplification/isometry/search/find_isometries.cpp>
#include <CGAL/Intrinsic_simplification/isometry/search/hash_of_surface.cpp>
#include <CGAL/Intrinsic_simplification/isometry/search/refine_partition.cpp>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Dart_complex.cpp>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Doubled_surface.cpp>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Moved_triangulation.cpp>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Singular_surface.cpp>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/remove_vertices.cpp>
#include <CGAL/Intrinsic_simplification/simplification/Candidates.cpp>
#include <CGAL/Intrinsic_simplification/simplification/Coarse_mesh.cpp>
#include <CGAL/Intrinsic_simplification/simplification/Quadratic_form.cpp>
#include <CGAL/Intrinsic_simplification/simplification/Simplifier.cpp>
#include <CGAL/Intrinsic_simplification/simplification/Star_removal.cpp>
#include <CGAL/Intrinsic_simplification/simplification/Vertex_star.cpp>
#include <CGAL/Intrinsic_simplification/simplification/coarse_surface.cpp>
#include <CGAL/Intrinsic_simplification/simplification/flat_vertices.cpp>
#include <CGAL/Intrinsic_simplification/simplification/flatten.cpp>
#include <CGAL/Intrinsic_simplification/simplification/prolongation.cpp>
#include <CGAL/Intrinsic_simplification/simplification/removable_vertices.cpp>
#include <CGAL/Intrinsic_simplification/simplification/removal_costs.cpp>
#include <CGAL/Intrinsic_simplification/simplification/triangulate_star.cpp>

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SOURCES_H
