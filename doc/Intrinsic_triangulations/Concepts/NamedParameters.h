// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class NamedParameters parameters.h <CGAL/Intrinsic_triangulations/support/parameters.h>
\cgalConcept

The concept `NamedParameters` describes the options of a function: a chain of names with values, in
any order. A page of a function lists the names that it takes, with their meaning and default.

\cgalHasModel{what members of `CGAL::Intrinsic_triangulations::parameters` return\, and those of
`CGAL::parameters`}

\cgalHeading{Invariants}

- A name that the function does not take is a compile error, also one of CGAL's; so is a name that is
  given twice.
- Values are copied. `std::ref(visitor)` passes the object itself.

\cgalHeading{Complexity}

Compilers remove chains.
*/
class NamedParameters {};
