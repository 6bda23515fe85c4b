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

/*!
\class PointRange triangle_soup.h <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>
\cgalConcept

The concept `PointRange` describes a range of points in space.

\cgalHasModel{`std::vector<CGAL::Epick::Point_3>`\, `std::vector<std::array<double\, 3>>`}

\cgalHeading{Operations}

`std::begin()` and `std::end()` of the range; `x()`, `y()` and `z()` of each point, or `[0]`, `[1]`
and `[2]`, whose values `CGAL::to_double()` converts.
*/
class PointRange {};
