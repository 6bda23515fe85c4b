// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\cgalConcept

The concept `IntrinsicTriangulationTraits` chooses the arithmetic of an intrinsic triangulation: the
number type of the stored values, and the metric that stores them and decides.

Everything that an operation computes it computes through `Metric`; the page of `IntrinsicMetric` says
which operation needs which function.

\cgalHasModel{`CGAL::Intrinsic_triangulations::Euclidean_traits<FT>`\,
`CGAL::Intrinsic_triangulations::Tolerant_traits<FT\, Tolerance>`\,
`CGAL::Intrinsic_triangulations::Interval_traits`\,
`CGAL::Intrinsic_triangulations::Exact_euclidean_traits`}
*/
class IntrinsicTriangulationTraits {
public:
  /// Number type of the stored values; the same as `Metric::FT`.
  typedef unspecified_type FT;
  /// A model of `IntrinsicMetric`.
  typedef unspecified_type Metric;
};
