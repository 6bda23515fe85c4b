// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_H

/*!
\file
All of the package that needs neither Eigen nor OpenMesh. Operators are in
`CGAL/Intrinsic_triangulations/operators/`, the adaptors of OpenMesh and `CGAL::Polyhedron_3` in
`CGAL/Intrinsic_triangulations/connectivity/`.
*/

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/is_delaunay.h>

#endif // CGAL_INTRINSIC_TRIANGULATIONS_H
