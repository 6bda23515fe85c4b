// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_VORONOI_WEIGHTED_SITE_H
#define CGAL_INTRINSIC_GEODESICS_VORONOI_WEIGHTED_SITE_H

#include <CGAL/Intrinsic_geodesics/distance/Distance_field.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

/*!
\file
Distances in the plane of a face: the least of the distances from weighted points, each seen from a
wedge only. On a segment, the least of them is found piece by piece.
*/

namespace CGAL::Intrinsic_triangulations::internal {

/// A point of the plane.
using Plane_point = Plane_vector<double>;

/*!
\brief is the place of a source in the plane of a face, and where paths from it are straight.

The wedge is bounded by two rays from the place; it is all of the plane if they have no direction.
*/
struct Weighted_site {
  Plane_point place;          ///< of the source
  double weight;              ///< distance of the source from the nearest true one
  std::uint32_t label;        ///< cell of that true one
  Plane_point to_begin{0, 0}; ///< direction of a ray that has the wedge on its right
  Plane_point to_end{0, 0};   ///< direction of a ray that has the wedge on its left

  /// returns the distance of a point by way of the source, in the wedge or not.
  double distance(Plane_point p) const { return weight + std::hypot(p.x - place.x, p.y - place.y); }
  /// returns how far a point is within the bounds of the wedge, up to factors: not negative inside.
  Plane_point inside(Plane_point p) const {
    return {cross(p - place, to_begin), cross(to_end, p - place)};
  }
  /// returns whether a point is in the wedge.
  bool sees(Plane_point p) const {
    const Plane_point in = inside(p);
    return in.x >= 0 && in.y >= 0;
  }
};

/// What a search found, and the cell of each of its sources.
struct Labelled_field {
  const Distance_field& field;
  std::span<const std::uint32_t> cell_of_source; ///< by the index of the source

  /// returns the cell of the true source where the shortest path to the source of a window begins;
  /// `Gluing::none` if there is none.
  std::uint32_t label(std::uint32_t source) const {
    const std::uint32_t origin = field.origin(source);
    return origin == Gluing::none ? origin : cell_of_source[origin];
  }
};

/// returns the sites of a face, in the frame of its first side: what windows show in it, its
/// corners, and the sources in it. \pre windows are kept
std::vector<Weighted_site> sites_of_face(const Labelled_field& labelled, std::uint32_t face);

/// returns the sites of a side that has faces on both sides, in its frame: what windows of both
/// show, and its ends.
std::vector<Weighted_site> sites_of_edge(const Labelled_field& labelled, std::uint32_t side);

/// returns the least distance of a point from sites that see it, infinity if none does.
double least_distance(std::span<const Weighted_site> sites, Plane_point p);

/// A part of a segment in one cell.
struct Labelled_piece {
  double end;          ///< where it ends, from the begin of the segment on
  std::uint32_t label; ///< the cell; `Gluing::none` if there is none
};

/*!
\brief finds the parts of a segment that are in one cell each.
\param sites the sites
\param from the begin of the segment
\param to its end
\param shortest shorter parts, as rounding makes them where sources tie, go to neighbours
\return the parts in order; neighbours have different labels
\complexity O(n k) for n sites and k parts with one nearest site
*/
std::vector<Labelled_piece> nearest_on_segment(std::span<const Weighted_site> sites,
                                               Plane_point from, Plane_point to, double shortest);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_VORONOI_WEIGHTED_SITE_H
