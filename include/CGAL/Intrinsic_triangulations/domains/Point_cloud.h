// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_POINT_CLOUD_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_POINT_CLOUD_H

#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief reports what was found in a point cloud.
*/
struct Point_cloud_report {
  /// Number of triangulated neighbours of each point: smaller than the option if there are fewer
  /// points.
  std::size_t neighbours = 0;
  /// Number of triangles before covering; most of them occur three times, once per corner.
  std::size_t triangles = 0;
  /// Number of points that coincide with an earlier one: they are left out, and their rows are
  /// zero; their values are those of the earlier one, see `Twin_points`.
  std::size_t duplicated_points = 0;
  /// Number of points without triangles, because their neighbours lie on a line or are missing.
  /// Their rows may be zero.
  std::size_t points_without_triangles = 0;
  /// For each point whether it is on the border: its cell among those of its neighbours is not
  /// bounded.
  std::vector<char> is_on_border;
};

namespace internal {

// For each point the first one at the same place: itself, unless it is duplicated.
// \throws Invalid_input if a coordinate is not finite
std::vector<std::uint32_t> first_points_at_places(const std::vector<std::array<double, 3>>& points);

} // namespace internal

/*!
\brief finds the triangles at each point of a cloud among its neighbours, see `make_point_cloud()`:
the point first, then counterclockwise, seen from either side of the surface; in an order that
depends neither on axes nor, but for ties, on numbers.
\param points the points, in any order
\param neighbours how many are triangulated around each point
\param report gets what was found
\throws Invalid_input if a coordinate is not finite, or no three points make a triangle
\complexity see `make_point_cloud()`
*/
std::vector<std::array<std::uint32_t, 3>>
triangles_at_points(const std::vector<std::array<double, 3>>& points, std::size_t neighbours,
                    Point_cloud_report& report);

/*!
\brief holds what a triangulation of a point cloud can be built from.
*/
struct Point_cloud : Domain {
  /// what was found
  Point_cloud_report points;
};

/*!
\brief makes a surface of points near a surface in space (§6.2 of the course, Sharp and Crane 2020).

The nearest neighbours of each point are turned about it into the plane that fits them best, with
their distances from it. The triangles at the point in their planar Delaunay triangulation
approximate the surface there. Where four points are nearly on a circle in the plane, their angles
in space decide, the same ones at each of the four, so that lattices on curved surfaces are covered
evenly. If those are equal up to rounding (2^-30), the edge stays if other points have it; if all
points of a circle have it, any diagonals do. Neighbours that are as far as the last one count, too.
A star is open where it turns by more than 60 degrees across a wide angle, if those at both sides of
the angle are open, too. So Laplacians and lumped masses stay the same if points are turned or
numbered otherwise, but for quadrilaterals that are not planar and whose diagonals a half turn of
the whole cloud exchanges: there the numbers of points decide. The union of these triangles over all
points has every neighbourhood about three times. The surface is its tufted cover (see
`make_domain()`), in which the triangles of a point are glued to each other; it has six sheets, and
matrices are divided by that many: they approximate those of the surface. With exact traits no
weight of the Delaunay Laplacian is negative. Rows are points.

\param points the points, in any order
\param neighbours how many are triangulated around each point; two at least
\param mollification treatment of degenerate faces
\throws Invalid_input naming a point with a coordinate that is not finite; or if there is no
  triangle, since the points lie on a line
\complexity \f$n (\log n + k \log k)\f$ for n points and k neighbours
*/
Point_cloud make_point_cloud(const std::vector<std::array<double, 3>>& points,
                             std::size_t neighbours = 30,
                             Mollification mollification = Mollification::automatic);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_POINT_CLOUD_H
