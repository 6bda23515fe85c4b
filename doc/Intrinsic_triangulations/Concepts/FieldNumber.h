// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class FieldNumber concepts.h <CGAL/Intrinsic_triangulations/formulas/concepts.h>
\cgalConcept

The concept `FieldNumber` describes the number type of a metric, and of the formulas that flips and
insertions need. It requires less than CGAL's `Field`: no comparison, no default constructor, and no
`Algebraic_structure_traits`. A metric also takes signs of numbers by `CGAL::sign()`.

\cgalRefines{\ref ::RingNumber}

\cgalHasModel{`float`\, `double`\, `long double`\, `CGAL::Interval_nt`\, `CGAL::Gmpq`\,
`CORE::Expr`\, `boost::multiprecision::number`\, \itc{Recorded_number}}

\cgalHeading{Operations}

`/`, and construction from `int` and `double`.
*/
class FieldNumber {};
