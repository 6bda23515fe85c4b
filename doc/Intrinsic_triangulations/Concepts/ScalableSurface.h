// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class ScalableSurface scale_metric.h <CGAL/Intrinsic_triangulations/input/metric_scaling/scale_metric.h>
\cgalConcept

The concept `ScalableSurface` describes a surface whose metric can be scaled: by
\itf{scale_conformally}, or \itf{scale_by_norm} with a norm per face.

\cgalHasModel{\itc{Intrinsic_input}\, all models of \ref ::TriangulationWithMetric\,
and of \ref ::ReadableFaceGraph with points}
*/
class ScalableSurface {};
