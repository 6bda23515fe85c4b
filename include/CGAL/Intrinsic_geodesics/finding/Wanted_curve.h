// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_FINDING_WANTED_CURVE_H
#define CGAL_INTRINSIC_GEODESICS_FINDING_WANTED_CURVE_H

#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>

#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// What the places of a curve are for.
enum class Curve_kind : std::uint8_t {
  geodesic, ///< a path or a loop leads through them
  bezier,   ///< they are the control points of a Bezier curve, see `make_bezier_curve()`
  tree      ///< geodesics lead from the first to all vertices, see `flip_to_geodesic_tree()`
};

/// A curve to be found.
struct Wanted_curve {
  std::vector<Place> places;              ///< two at least; three of a loop; one of a tree
  bool is_loop = false;                   ///< whether it returns to the first place
  bool stays_at_places = false;           ///< whether it stays at all places, or only at its ends
  Curve_kind kind = Curve_kind::geodesic; ///< what the places are for
  std::string name{};                     ///< what errors begin with; empty: nothing
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_FINDING_WANTED_CURVE_H
