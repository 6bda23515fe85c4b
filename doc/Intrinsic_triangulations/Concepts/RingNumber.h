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
