// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_EXPECT_MIDDLE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_EXPECT_MIDDLE_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Merged_edges.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Piece_gluer.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <cstddef>
#include <cstdint>
#include <vector>

// Whether two subdivisions have a triangulation in common, the middle one: intrinsic in the first
// one, the input in the second one. All checks are linear.

namespace CGAL::Intrinsic_triangulations::internal {

// \throws Invalid_input naming an element of the middle triangulation with which a subdivision
//   disagrees, and the remedy
[[noreturn]] void fail_middle(Element_kind kind, std::size_t element, Subdivided middle);

// Sizes agree, numbers are in range, and each face is in one face of the middle triangulation.
// \param others how many halfedges the other triangulation of the subdivision has
void expect_arrays(const Common_subdivision& s, Subdivided middle, const Gluing_map& mesh,
                   std::size_t others);

// Each edge of the middle triangulation is a path between its ends, with pieces on both sides.
// \param glue `pieces.run()`
void expect_paths(const Piece_gluer& pieces, const std::vector<std::uint32_t>& glue,
                  Subdivided middle, const Corners_along& along, const Gluing_map& mesh);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_EXPECT_MIDDLE_H
