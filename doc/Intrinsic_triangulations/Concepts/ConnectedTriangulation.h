// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class ConnectedTriangulation Connection_graph.h <CGAL/Intrinsic_operators/operators/Connection_graph.h>
\cgalConcept

The concept `ConnectedTriangulation` describes what matrices on tangent vectors are assembled from.
Its name comes from the connection, the parallel transport along edges; the surface may have several
components.

\cgalRefines{\ref ::MeasuredTriangulation and \ref ::NumberedTriangulation}

\cgalHasModel{\itc{Intrinsic_triangulation}}

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| \itf{connection_laplacian}, \itf{smoothest_direction_field}, \itc{Vector_heat_method}, \itf{logarithmic_map} | all |
*/
class ConnectedTriangulation {};
