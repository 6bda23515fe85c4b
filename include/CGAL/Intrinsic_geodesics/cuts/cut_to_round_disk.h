// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CUTS_CUT_TO_ROUND_DISK_H
#define CGAL_INTRINSIC_GEODESICS_CUTS_CUT_TO_ROUND_DISK_H

#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief finds a cut that makes a disk of each component of a surface, in which all faces are near one
of them.

The cut is near the cut locus of that face: it consists of the edges that a tree of shortest ways
from the face to all others does not cross, without those that dangle. It is longer than that of
`cut_to_disk()`, but the disk is small: hyperbolic layouts, whose errors grow exponentially with
the distance from the centre, stay accurate. Fans that meet in a vertex are taken apart. A way
goes through the middles of sides.
\param s the surface, orientable or not, of any number of components; `is_kept` is not read
\param through vertices that the cut passes through
\param centers the number of faces of each component that are tried; that is kept whose farthest
  face is nearest
\return nonzero for both sides of each edge to cut, which `cut_open()` takes
\throws Invalid_input if sizes disagree, a vertex does not exist, or a sphere has less than two of
  the vertices
\pre `validate(s.gluing)` does not throw, and lengths are not negative
\complexity n log n for each center
*/
std::vector<char> cut_to_round_disk(const Surface_to_cut& s,
                                    std::span<const std::uint32_t> through = {},
                                    std::size_t centers = 8);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_CUTS_CUT_TO_ROUND_DISK_H
