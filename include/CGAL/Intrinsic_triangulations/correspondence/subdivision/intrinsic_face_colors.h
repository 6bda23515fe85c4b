// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_INTRINSIC_FACE_COLORS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_INTRINSIC_FACE_COLORS_H

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// Red, green and blue, from 0 to 255.
using Rgb_color = std::array<std::uint8_t, 3>;

/*!
\brief chooses a colour for each intrinsic face, so that neighbours differ.

A face takes the first of twelve colours that its three neighbours do not have; its number
determines where the search starts.
\param s the subdivision
\pre `s` is the common subdivision of two triangulations
\return a colour for each number of an intrinsic face
\complexity linear
*/
std::vector<Rgb_color> intrinsic_face_colors(const Common_subdivision& s);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_INTRINSIC_FACE_COLORS_H
