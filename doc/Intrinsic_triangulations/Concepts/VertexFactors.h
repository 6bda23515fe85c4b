// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

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
