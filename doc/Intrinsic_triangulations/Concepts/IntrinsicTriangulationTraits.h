// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class IntrinsicTriangulationTraits metric_concepts.h <CGAL/Intrinsic_triangulations/triangulation/metric_concepts.h>
\cgalConcept

The concept `IntrinsicTriangulationTraits` chooses the arithmetic of an intrinsic triangulation: the
number type of the stored values, and the metric that stores them and decides.

Traits of CGAL's planar triangulations have functors on points. This concept has none, since there
are no points. Operations compute through `Metric`, by the numbers of edges and faces. So the page
of
\ref ::IntrinsicMetric, and that of \ref ::EuclideanMetric, say which operation needs which function, and you write only one class: a
metric.

\cgalHasModel{\itc{Exact_euclidean_traits}\,
\itc{Euclidean_traits}\,
\itc{Tolerant_traits}\,
\itc{Interval_traits}\,
\itc{Exact_ideal_hyperbolic_traits}\,
\itc{Integer_only_traits}\,
\itc{Ideal_hyperbolic_traits}; your own traits: own_traits.cpp among the examples}

\cgalHeading{Types}

`FT` and `Metric`, below.

\cgalHeading{Operations}

None: the package never makes objects of the class.

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
