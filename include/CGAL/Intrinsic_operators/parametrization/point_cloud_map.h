// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_POINT_CLOUD_MAP_H
#define CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_POINT_CLOUD_MAP_H

#include <CGAL/Intrinsic_triangulations/support/defaults.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {
// `progress` is called before the factorization and after each solution.
Eigen::MatrixX2d conformal_map_of_points(const std::vector<std::array<double, 3>>& points,
                                         std::size_t neighbours,
                                         const std::function<bool(std::size_t)>& progress);
} // namespace internal

/*!
\brief maps a cloud of points near a disk to the plane with least conformal energy for the extent
  of its border (§6.2 of the course).

The energy is a third of the sum over all triangles at points among their neighbours, with equal
orientation (see `Point_cloud_vectors`): this needs no traced border, and no triangle has negative
energy. The map is the eigenvector of the least eigenvalue, as for `spectral_conformal_map()`; the
border consists of the points with unbounded cells. Points in a plane are only turned.
\param points the points, in any order
\param neighbours the number of neighbours to triangulate around each point; at least two
\param np see `least_squares_conformal_map()`
\return a point, x and y, per point, scaled to the area of the surface, the first point of the
  border on the positive x-axis; not numbers at points
  without triangles. If the visitor has ended the work, no points
\throws Invalid_input as `make_point_cloud()`; or if there is no border, the surface has one side,
  or is not connected
\complexity that of triangles at n points, O(n log n), and that of a sparse factorization of
  complex numbers and some solutions
*/
template <NamedParameters NP = parameters::Parameters<>>
Eigen::MatrixX2d conformal_map_of_points(const std::vector<std::array<double, 3>>& points,
                                         std::size_t neighbours = defaults::neighbors,
                                         const NP& np = parameters::default_values()) {
  internal::expect_names<internal::tags::visitor>(np);
  return internal::conformal_map_of_points(points, neighbours, internal::progress_of(np));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_POINT_CLOUD_MAP_H
