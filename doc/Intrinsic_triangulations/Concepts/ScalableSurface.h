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

/*!
\class ScalableSurface scale_metric.h <CGAL/Intrinsic_triangulations/input/metric_scaling/scale_metric.h>
\cgalConcept

The concept `ScalableSurface` describes a surface whose metric can be scaled: by
\itf{scale_conformally}, or \itf{scale_by_norm} with a norm per face.

\cgalHasModel{\itc{Intrinsic_input}\, all models of \ref ::TriangulationWithMetric\,
and of \ref ::ReadableFaceGraph with points}
*/
class ScalableSurface {};

/*!
\class VertexFactors scale_metric.h <CGAL/Intrinsic_triangulations/input/metric_scaling/scale_metric.h>
\cgalConcept

The concept `VertexFactors` describes numbers at the vertices of a surface: a functor, or a readable
property map. The vertices are those of the surface, those of `mesh()` of a triangulation, or those
of \itc{Gluing_map} for an \itc{Intrinsic_input}.

\cgalHeading{Operations}

A call with a vertex, or `get()`, whose result `CGAL::to_double()` converts.
*/
class VertexFactors {};

/*!
\class FaceNorm scale_metric.h <CGAL/Intrinsic_triangulations/input/metric_scaling/scale_metric.h>
\cgalConcept

The concept `FaceNorm` describes a functor that measures vectors in the faces of a surface: in the
frame of a face, or in space.

\cgalHeading{Operations}

A call with a face and a vector, whose result `CGAL::to_double()` converts.

\cgalHeading{Invariants}

The result is not negative, and grows by |x| if the vector grows by x.
*/
class FaceNorm {};
