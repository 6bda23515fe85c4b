// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class TriangleRange build_gluing.h <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
\cgalConcept

The concept `TriangleRange` describes a range, of known size, of triples of numbers: the vertices of
each triangle in their order around it. Numbers that are negative or too large are found when the
range is read.

\cgalHasModel{`std::vector<std::array<std::uint32_t\, 3>>`\,
`std::vector<std::vector<std::size_t>>`\, `std::span<const std::array<int\, 3>>`}

\cgalHeading{Operations}

`size()`, `begin()` and `end()`; `[0]`, `[1]` and `[2]` of a triangle, which are standard
integers.
*/
class TriangleRange {};
