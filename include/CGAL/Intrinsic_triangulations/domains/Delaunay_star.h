// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_DELAUNAY_STAR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_DELAUNAY_STAR_H

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Finds the triangles at the origin in the Delaunay triangulation of the origin and points in the
// plane: they are the facets of the hull of the inverted points that face it. The plane was turned
// or bent to the points, differently at each center. Where four are nearly on a circle there, or on
// one in space, their places in space decide, so that all stars have the same diagonal: it ends at
// the two corners of the quadrilateral with the larger sum of angles, which is Delaunay if they are
// in a plane. If the sums are equal up to rounding, the edge stays and is marked as tied; three
// points are on a line up to rounding, too. So the result depends neither on how points are turned
// nor on their order.
class Delaunay_star {
public:
  // Far above rounding, of coordinates a million times as large as distances, too; far below what
  // changes a surface.
  static constexpr double tie = 0x1p-30;

  struct Neighbour {
    std::array<double, 2> at; // in the plane
    std::uint32_t number;
    std::array<double, 3> in_space; // from the origin
    double direction = 0; // set here: grows with the angle, from 0 to 4, half a turn is 2; rounded
    double distance = 0;  // set here: from the origin, in the plane
    // set here: by how much the edge is Delaunay; 1 at the ends of an open star
    double strength = 1;

    // Whether the origin, this point and those around it are on a circle: the edge may be left out.
    bool is_tied() const { return std::abs(strength) <= tie; }
  };

  enum class Extent : char {
    closed, // the last and the first corner are those of a triangle, too: the star goes all around
    open,   // it has a gap of half a turn
    bent    // it was opened where the points turn in space
  };
  // \param neighbours which are sorted and thinned out; those left are the corners of triangles,
  // counterclockwise
  static Extent find(std::vector<Neighbour>& neighbours);
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_DELAUNAY_STAR_H
