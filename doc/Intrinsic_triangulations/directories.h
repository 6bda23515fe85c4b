// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only: what each directory of headers holds, from the highest to the lowest. The README of
// each package has the rooms inside them.

/*!
\dir CGAL/Intrinsic_triangulations
\brief Triangulations: all headers but those of triangulations: `CGAL/Intrinsic_triangulation.h`,
`CGAL/Corresponding_triangulation.h` and `CGAL/Integer_only_triangulation.h`; and `CGAL/Intrinsic_triangulations.h`, which
includes what most programs need. \ref page_reference lists all names by topic.

\dir CGAL/Intrinsic_triangulations/IO
\brief Files in and out: meshes, intrinsic triangulations, common subdivisions, pages that show them.

\dir CGAL/Intrinsic_operators
\brief Matrices of finite elements, solvers, and what they solve: distances, vectors, maps to the plane, editing. Needs Eigen.

\dir CGAL/Intrinsic_geodesics
\brief Curves along edges that flips make geodesic, geodesics between points, Bezier curves, exact distances.

\dir CGAL/Intrinsic_triangulations/retriangulation
\brief Algorithms that change the triangulation: flips to Delaunay, refinement, optimal Delaunay triangulations.

\dir CGAL/Intrinsic_triangulations/correspondence
\brief Where intrinsic edges and vertices are on the input: models, curves, queries, the common subdivision.

\dir CGAL/Intrinsic_triangulations/tracing
\brief Straight lines over faces: geodesics, directions at vertices.

\dir CGAL/Intrinsic_triangulations/triangulation
\brief What all triangulations share: concepts, records of moves, sessions.

\dir CGAL/Intrinsic_triangulations/metric
\brief Lengths, areas and the decisions that depend on them, in floating point and exactly.

\dir CGAL/Intrinsic_triangulations/exact
\brief What decides a sign where intervals cannot.

\dir CGAL/Intrinsic_triangulations/input
\brief The surface before the first move, its names in the user's mesh, and how it is made; other metrics for it.

\dir CGAL/Intrinsic_triangulations/formulas
\brief One triangle, one diamond, one star.

\dir CGAL/Intrinsic_triangulations/connectivity
\brief Triangles that are glued together: data structures, adaptors of mesh types, moves without geometry, topology; named
parameters.
*/
