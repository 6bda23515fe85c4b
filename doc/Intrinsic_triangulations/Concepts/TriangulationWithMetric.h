// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class TriangulationWithMetric Scaled_metric.h <CGAL/Intrinsic_triangulations/input/metric_scaling/Scaled_metric.h>
\cgalConcept

The concept `TriangulationWithMetric` describes a triangulation with a metric of its own. Its points,
if it ever had any, say nothing of its edges.

\cgalHasModel{\itc{Intrinsic_triangulation}}

\cgalHeading{Operations}

`mesh()`; `approximate_squared_length(edge)` and `scale_exponent()` of `metric()`, as
\ref ::EuclideanMetric describes them. Those that read it also take `index(edge)` and the types
`Mesh` and `edge_descriptor`.

\cgalHeading{Complexity}

Constant time for all functions.
*/
class TriangulationWithMetric {};
