// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class RingNumber concepts.h <CGAL/Intrinsic_triangulations/formulas/concepts.h>
\cgalConcept

The concept `RingNumber` describes numbers that polynomials in lengths and areas are evaluated in.
Numbers may be exact, rounded, or enclosures.

\cgalRefines{CopyConstructible\, Assignable}

\cgalHasModel{all models of \ref ::FieldNumber\, `CGAL::Mpzf`\, `CGAL::Gmpz`\,
\itc{Expression_degree}}

\cgalHeading{Operations}

`+`, `-` and `*`. Results convert to the type, so that expression templates are
allowed.

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| \itf{squared_quadruple_area}, \itf{twice_inner_product}, \itc{Delaunay_expression} | `RingNumber` |
| \itf{flipped}, \itf{apex}, \itf{cotangent_weight}, \itc{Euclidean_traits} | \ref ::FieldNumber |
*/
class RingNumber {};

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
