// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class FaceRange triangle_soup.h <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>
\cgalConcept

The concept `FaceRange` describes a range of ranges of integers: the numbers of the vertices of each
face, in their order around it. Faces have any number of vertices.

\cgalHasModel{`std::vector<std::vector<std::size_t>>`\,
`std::vector<std::array<std::uint32_t\, 3>>`}

\cgalHeading{Operations}

`std::begin()` and `std::end()` of the range and of each face, whose values convert to
`std::int64_t`.
*/
class FaceRange {};
