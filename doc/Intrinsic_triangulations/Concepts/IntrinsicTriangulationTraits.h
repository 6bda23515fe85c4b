// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class IntrinsicTriangulationTraits concepts.h <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
\cgalConcept

The concept `IntrinsicTriangulationTraits` chooses the arithmetic of an intrinsic triangulation: the
number type of the stored values, and the metric that stores them and decides.

Unlike traits of CGAL's planar triangulations it has no functors on points, as there are no points. What an operation
computes it computes through `Metric`, by the numbers of edges and faces; so the page of \ref ::IntrinsicMetric says
which operation needs which function, and there is one thing to write: a metric.

\cgalHasModel{\itc{Exact_euclidean_traits}\,
\itc{Euclidean_traits}\,
\itc{Tolerant_traits}\,
\itc{Interval_traits}; traits of one's own: own_traits.cpp among the examples}

\cgalHeading{Types}

`FT` and `Metric`, below.

\cgalHeading{Operations}

None: objects of the class are never made.

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| all of \itc{Intrinsic_triangulation} | `FT`, `Metric` |

\cgalHeading{Invariants}

`FT` is the same type as `Metric::FT`.
*/
class IntrinsicTriangulationTraits {
public:
  /// Number type of the stored values; the same as `Metric::FT`.
  typedef unspecified_type FT;
  /// A model of \ref ::IntrinsicMetric.
  typedef unspecified_type Metric;
};
