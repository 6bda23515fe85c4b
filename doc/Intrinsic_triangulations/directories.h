// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only: what each directory of headers holds, from the highest to the lowest. The
// README of each package lists the rooms inside it.

/*!
\dir CGAL/Intrinsic_triangulations
\brief Triangulations, the first package. Beside this folder are the triangulations themselves,
`CGAL/Intrinsic_triangulation.h`, `CGAL/Corresponding_triangulation.h` and
`CGAL/Integer_only_triangulation.h`; and `CGAL/Intrinsic_triangulations.h`, which includes what most
programs need. \ref page_reference lists all names by topic.

\dir CGAL/Intrinsic_triangulations/IO
\brief Files in and out: meshes, intrinsic triangulations, common subdivisions, pages that show
them.

\dir CGAL/Intrinsic_operators
\brief Operators, the third package: matrices of finite elements, solvers, distances by heat,
vectors, maps to the plane, editing. `CGAL/Intrinsic_operators.h` includes most of it. Needs Eigen.

\dir CGAL/Intrinsic_geodesics
\brief Geodesics, the second package: curves that flips make geodesic, geodesics between points,
Bezier curves, exact distances. `CGAL/Intrinsic_geodesics.h` includes most of it.

\dir CGAL/Intrinsic_triangulations/retriangulation
\brief Algorithms that change the triangulation: flips to Delaunay, refinement, optimal Delaunay
triangulations.

\dir CGAL/Intrinsic_triangulations/correspondence
\brief Where intrinsic edges and vertices are on the input: models, curves, queries, the common
subdivision.

\dir CGAL/Intrinsic_triangulations/tracing
\brief Straight lines over faces: geodesics, directions at vertices.

\dir CGAL/Intrinsic_triangulations/triangulation
\brief Concepts, records of moves and sessions, which all triangulations share.

\dir CGAL/Intrinsic_triangulations/metric
\brief Lengths, areas and decisions on them, in floating point and exactly.

\dir CGAL/Intrinsic_triangulations/exact
\brief The ladder that decides a sign if intervals cannot.

\dir CGAL/Intrinsic_triangulations/input
\brief The surface before the first move, its construction, its names in the user's mesh, and other
metrics for it.

\dir CGAL/Intrinsic_triangulations/formulas
\brief One triangle, one diamond, one star.

\dir CGAL/Intrinsic_triangulations/connectivity
\brief Triangles that are glued together: data structures, adaptors of mesh types, moves without
geometry, topology; named parameters.
*/
