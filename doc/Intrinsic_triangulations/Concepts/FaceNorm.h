// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

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
