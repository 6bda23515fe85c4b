// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_CAPS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_CAPS_H

#include <cstdint>

// Where algorithms stop by default that rounding, or an angle out of reach, may keep from ending.

namespace CGAL::Intrinsic_triangulations::internal {

// Flips, with inexact numbers. No mesh of the data set needs one for two edges.
inline std::uint64_t flip_cap(std::uint64_t edges) { return 1000000 + 100 * edges; }

// Insertions. For angles of 25 degrees no mesh of the data set needs five for a face.
inline std::uint64_t insertion_cap(std::uint64_t faces) { return 1000000 + 10 * faces; }

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_CAPS_H
