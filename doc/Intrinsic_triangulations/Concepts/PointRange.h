// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

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
