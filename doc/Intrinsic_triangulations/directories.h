// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only: what each directory of headers holds, from the highest layer to the lowest.

/*!
\dir CGAL/Intrinsic_triangulations
\brief All headers of the package but `CGAL/Intrinsic_triangulation.h`, the class that owns a triangulation, and
`CGAL/Intrinsic_triangulations.h`, which includes everything that needs neither Eigen nor OpenMesh. \ref page_reference
lists them by topic.

\dir CGAL/Intrinsic_triangulations/IO
\brief Files in and out: meshes, intrinsic triangulations, common subdivisions, pages that show them.

\dir CGAL/Intrinsic_triangulations/operators
\brief Matrices of finite elements, solutions, estimates of their errors and their transfer. Needs Eigen.

\dir CGAL/Intrinsic_triangulations/retriangulation
\brief Algorithms that change the triangulation: flips to Delaunay, refinement, optimal Delaunay triangulations.

\dir CGAL/Intrinsic_triangulations/correspondence
\brief Where intrinsic edges and vertices are on the input: representations, queries, the common subdivision.

\dir CGAL/Intrinsic_triangulations/metric
\brief Lengths, areas and the decisions that depend on them, in floating point and exactly.

\dir CGAL/Intrinsic_triangulations/connectivity
\brief Triangles that are glued together: data structures, adaptors of mesh types, moves without geometry, topology.
*/
