// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_POINT_CLOUD_VECTORS_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_POINT_CLOUD_VECTORS_H

#include <CGAL/Intrinsic_operators/vectors/Heat_transport.h>
#include <CGAL/Intrinsic_operators/vectors/direction_field.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/support/defaults.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief transports tangent vectors over a cloud of points, and finds logarithmic maps and direction
  fields there (§6.2 of the course).

The surface of `make_point_cloud()` has several neighbourhoods at each point, and so no common
tangent plane. This class gives each point one plane, `axes()`: orthogonal to the mean normal of the
triangles at the point among its neighbours. Orientations agree along a minimum spanning tree of
edges of these triangles. The weight of an edge is a third of the sum of the cotangent weights of
all triangles at it, since each triangle occurs about three times. Its direction in both planes is
that of its projection. This gives a connection, as in a triangulation (`Vector_heat_method`). In
the plane logarithms are exact. Surfaces with one side have a seam, which no heat crosses.

Vectors are complex numbers in the axes of their point. Unknown ones are NaN: on components without
a source, and at points without triangles. A point at the place of an earlier one has its axes and
vectors.
*/
class Point_cloud_vectors {
public:
  using Complex = std::complex<double>; ///< a vector in the axes of a point
  /// Two orthonormal vectors.
  using Axes = std::array<std::array<double, 3>, 2>;

  /*!
  \brief finds tangent planes.
  \param points the points, in any order
  \param neighbours the number of neighbours to triangulate around each point; at least two
  \param time_factor the time of diffusion, in squares of the mean length of edges
  \throws Invalid_input as `make_point_cloud()`
  \throws std::invalid_argument if the time is not positive, or so long that heat is even everywhere
  \complexity that of triangles at n points, O(n log n); the first query factors matrices
  */
  explicit Point_cloud_vectors(const std::vector<std::array<double, 3>>& points,
                               std::size_t neighbours = defaults::neighbors,
                               double time_factor = defaults::time_factor);

  /// returns the number of points.
  std::size_t size() const { return points_.size(); }
  /// returns the axes of the tangent plane at a point, the first towards its nearest neighbour;
  /// zero vectors at points without
  /// triangles.
  const Axes& axes(std::size_t i) const { return axes_[i]; }
  /// returns a vector at a point in space.
  std::array<double, 3> in_space(std::size_t i, const Complex& z) const;

  /*!
  \brief extends values at points to all points, see `Vector_heat_method::extend_scalars()`.
  \param sources numbers of points, and their values
  \return a value per point; not a number on components without a source
  \throws std::invalid_argument if there is none, a number is out of range, a point has no
    triangles, or a value is not finite
  */
  std::vector<double>
  extend_scalars(const std::vector<std::pair<std::size_t, double>>& sources) const;

  /*!
  \brief transports vectors from points to all points, see `Vector_heat_method::transport()`.
  \param sources numbers of points, and vectors in their axes
  \throws std::invalid_argument if there is none, a number is out of range, a point has no
    triangles, or a vector is not finite
  */
  Tangent_field transport(const std::vector<std::pair<std::size_t, Complex>>& sources) const;

  /*!
  \brief finds the logarithmic map of a point by affine heat: for each point the vector along the
    shortest path to it, as long as the path.
  \param i number of the point
  \return vectors in the axes of point `i`, no shorter than chords
  \throws std::invalid_argument if the number is out of range, or the point has no triangles
  */
  std::vector<Complex> logarithmic_map(std::size_t i) const;

  /*!
  \brief finds the smoothest field of directions, see
  `smoothest_direction_field()`.
  \param degree the number of equivalent directions at a point
  \param fixed points, and their fixed directions in their axes
  \param np see there
  \throws std::invalid_argument if the degree is not positive, or a direction cannot be fixed
  */
  template <NamedParameters NP = parameters::Parameters<>>
  Direction_field
  smoothest_direction_field(int degree,
                            const std::vector<std::pair<std::size_t, Complex>>& fixed = {},
                            const NP& np = parameters::default_values()) const {
    internal::expect_names<internal::tags::visitor>(np);
    return direction_field(degree, fixed, internal::progress_of(np));
  }

  /// returns the number of edges at which the orientations of tangent planes differ: zero unless
  /// the surface has one side, or is
  /// sampled too coarsely.
  std::size_t seam_edges() const { return seam_edges_; }

private:
  // the first point at the place of a point, which has a plane
  std::size_t with_plane(std::size_t i) const;
  // the values of the first point at each place
  template <class Value, class Values>
  std::vector<Value> at_all_points(const Values& values) const {
    std::vector<Value> result;
    for (const std::uint32_t i : first_at_place_) result.push_back(values[i]);
    return result;
  }
  Direction_field direction_field(int degree,
                                  const std::vector<std::pair<std::size_t, Complex>>& fixed,
                                  const std::function<bool(Direction_step)>& progress) const;

  std::vector<std::array<double, 3>> points_;
  std::vector<std::uint32_t> first_at_place_; // of each point
  int exponent_ = 0;                          // computations use the points times 2^-exponent
  std::vector<Axes> axes_;
  std::size_t seam_edges_ = 0;
  std::optional<internal::Heat_transport> heat_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_POINT_CLOUD_VECTORS_H
