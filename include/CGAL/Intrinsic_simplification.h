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

#endif // CGAL_INTRINSIC_SIMPLIFICATION_H
