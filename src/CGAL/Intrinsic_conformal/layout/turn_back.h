// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_LAYOUT_TURN_BACK_H
#define CGAL_INTRINSIC_CONFORMAL_LAYOUT_TURN_BACK_H

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Polygons divided from their first corners.
std::vector<std::array<std::uint32_t, 3>> triangles_of_pieces(const Common_subdivision& s);

// Whether a triangle is not counterclockwise, exactly.
bool is_turned(const Eigen::MatrixX2d& positions, const std::array<std::uint32_t, 3>& triangle);
// The same with geodesics of Poincaré's disk as sides.
bool is_turned_in_disk(const Eigen::MatrixX2d& positions,
                       const std::array<std::uint32_t, 3>& triangle);

// Turns triangles back that have turned over or lost their area because they are as small as the
// distance of doubles there: moves their vertices by amounts of that size. The number of such
// triangles, counted exactly, does not rise; it is zero afterwards where a local search succeeds
// (Freitag, Plassmann, Local optimization-based simplicial mesh untangling and improvement, 2000).
// Vertices move by less than 2^-44 of the extent.
void turn_back(const std::vector<std::array<std::uint32_t, 3>>& triangles,
               Eigen::MatrixX2d& positions);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_CONFORMAL_LAYOUT_TURN_BACK_H
