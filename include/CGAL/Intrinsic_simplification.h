// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_H
#define CGAL_INTRINSIC_SIMPLIFICATION_H

/*!
\file
Includes simplification with a proven stretch, isometries, convex polyhedra of metrics, and
`CGAL/Intrinsic_conformal.h`. Needs Eigen.
*/

#include <CGAL/Intrinsic_conformal.h>
#include <CGAL/Intrinsic_simplification/embedding/embed_convex.h>
#include <CGAL/Intrinsic_simplification/isometry/Canonical_form.h>
#include <CGAL/Intrinsic_simplification/isometry/find_isometries.h>
#include <CGAL/Intrinsic_simplification/simplification/hierarchy.h>
#include <CGAL/Intrinsic_simplification/simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplification/remove_flat_vertices.h>
#include <CGAL/Intrinsic_simplification/simplification/simplify.h>
#include <CGAL/Intrinsic_simplification/simplification/vector_prolongation.h>

#endif // CGAL_INTRINSIC_SIMPLIFICATION_H
