// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_POINT_CLOUD_VECTORS_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_POINT_CLOUD_VECTORS_H

#include <CGAL/Intrinsic_operators/vectors/Direction_problem.h>
#include <CGAL/Intrinsic_operators/vectors/Heat_transport.h>
#include <CGAL/Intrinsic_operators/vectors/direction_field.h>
#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#if CGAL_INTRINSIC_TRIANGULATIONS_DEFINES(VECTORS)
#include <CGAL/Intrinsic_operators/vectors/Cloud_connection.h>
#endif

namespace CGAL::Intrinsic_triangulations {

/*!
\brief transports tangent vectors over a cloud of points, and finds logarithmic maps and direction
  fields there (§6.2 of the course).

The surface of `make_point_cloud()` has several neighbourhoods at each point, and so no tangent
plane that is the point's own. Here each point has one: orthogonal to
the mean normal of the triangles at the point among its neighbours, `axes()`. Planes are oriented
alike along a minimum spanning tree of edges of these triangles.
An edge has the cotangent weight of all triangles at it, a third of the sum as they are there about
three times, and in both
planes the direction of its projection: that is a connection, for which all works as in a
triangulation (`Vector_heat_method`). In the plane logarithms are
exact. Surfaces with one side have a seam, which no heat crosses.

Vectors are complex numbers in the axes of their point. Those that are not known are not numbers:
on components without a source, and at points without triangles.
*/
class Point_cloud_vectors {
public:
  using Complex = std::complex<double>; ///< a vector in the axes of a point
  /// Two orthonormal vectors.
  using Axes = std::array<std::array<double, 3>, 2>;

  /*!
  \brief finds tangent planes.
  \param points the points, in any order
  \param neighbours how many are triangulated around each point; two at least
  \param time_factor the time of diffusion, in squares of the mean length of edges
  \throws Invalid_input as `make_point_cloud()`
  \throws std::invalid_argument if the time is not positive, or so long that heat is even everywhere
  \complexity that of triangles at n points, O(n log n); the first question factors matrices
  */
  explicit Point_cloud_vectors(const std::vector<std::array<double, 3>>& points,
                               std::size_t neighbours = 30, double time_factor = 1);

  /// returns the number of points.
  std::size_t size() const { return points_.size(); }
  /// returns the axes of the tangent plane at a point, the first towards its nearest neighbour;
  /// zero vectors at points without
  /// triangles.
  const Axes& axes(std::size_t i) const { return axes_[i]; }
  /// returns a vector at a point in space.
  std::array<double, 3> in_space(std::size_t i, const Complex& z) const;

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
  \brief finds the smoothest field of directions, see the function of this name.
  \param degree the number of directions at a point that are alike
  \param fixed points, and directions in their axes that are not to change
  \throws std::invalid_argument if the degree is not positive, or a direction cannot be fixed
  */
  Direction_field
  smoothest_direction_field(int degree,
                            const std::vector<std::pair<std::size_t, Complex>>& fixed = {}) const;

  /// returns the number of edges at which the orientations of tangent planes differ: zero unless
  /// the surface has one side, or is
  /// sampled too coarsely.
  std::size_t seam_edges() const { return seam_edges_; }

private:
  void expect_plane(std::size_t i) const;

  std::vector<std::array<double, 3>> points_;
  int exponent_ = 0; // points times 2^-exponent are what is computed with
  std::vector<Axes> axes_;
  std::size_t seam_edges_ = 0;
  std::optional<internal::Heat_transport> heat_;
};

} // namespace CGAL::Intrinsic_triangulations

#if CGAL_INTRINSIC_TRIANGULATIONS_DEFINES(VECTORS)
namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Point_cloud_vectors::Point_cloud_vectors(const std::vector<std::array<double, 3>>& points,
                                         std::size_t neighbours, double time_factor)
    : points_(points) {
  const internal::Cloud_connection connection(points, neighbours);
  exponent_ = connection.exponent();
  const auto vector = [](const Eigen::Vector3d& v) { return std::array{v[0], v[1], v[2]}; };
  for (std::size_t i = 0; i < points.size(); ++i)
    axes_.push_back({vector(connection.first_axis(i)), vector(connection.second_axis(i))});
  seam_edges_ = connection.seam_edges();
  heat_.emplace(connection.graph(), time_factor);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::array<double, 3> Point_cloud_vectors::in_space(std::size_t i, const Complex& z) const {
  std::array<double, 3> result{};
  for (std::size_t c = 0; c < 3; ++c)
    result[c] = z.real() * axes_[i][0][c] + z.imag() * axes_[i][1][c];
  return result;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void Point_cloud_vectors::expect_plane(std::size_t i) const {
  if (i >= size())
    throw std::invalid_argument("there is no point " + std::to_string(i) + "; there are " +
                                std::to_string(size()));
  if (axes_[i][0] == std::array<double, 3>{})
    throw std::invalid_argument("point " + std::to_string(i) +
                                " has no triangles, and so no vectors: it lies on a line with its "
                                "neighbours, or an earlier point has the same place");
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Tangent_field
Point_cloud_vectors::transport(const std::vector<std::pair<std::size_t, Complex>>& sources) const {
  if (sources.empty()) throw std::invalid_argument("there must be a source; none is given");
  internal::Vector_sources s(size());
  for (const auto& [i, z] : sources) {
    expect_plane(i);
    if (!internal::is_known(z))
      throw std::invalid_argument("the vectors of sources must be finite");
    const auto row = static_cast<Eigen::Index>(i);
    s.weights[row] += 1;
    s.lengths[row] += std::abs(z);
    s.vectors[row] += z;
  }
  const Eigen::VectorXcd z = heat_->transported(s);
  return {z.begin(), z.end()};
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::vector<std::complex<double>> Point_cloud_vectors::logarithmic_map(std::size_t i) const {
  expect_plane(i);
  const std::vector<internal::Source_corner> source{{static_cast<int>(i), 1, 0, 1}};
  const Eigen::VectorXcd z = heat_->affine_logarithm(source);
  std::vector<Complex> result(size());
  for (std::size_t j = 0; j < size(); ++j)
    result[j] = std::ldexp(1., exponent_) * z[static_cast<Eigen::Index>(j)];
  internal::lengthen_to_chords(points_, source, 1, result);
  return result;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Direction_field Point_cloud_vectors::smoothest_direction_field(
    int degree, const std::vector<std::pair<std::size_t, Complex>>& fixed) const {
  if (degree < 1)
    throw std::invalid_argument("a field has at least one direction at a vertex, not " +
                                std::to_string(degree));
  internal::Direction_problem problem{
      degree, Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(size())), 0, {}};
  for (const auto& [i, z] : fixed) {
    expect_plane(i);
    const Complex u = internal::unit_vector(z);
    if (u == 0.)
      throw std::invalid_argument("the direction at point " + std::to_string(i) +
                                  " cannot be fixed: it is zero or not finite");
    problem.fixed.push_back({i, internal::power_of(u, degree)});
  }
  return {degree, internal::solve(problem, heat_->graph(), {})};
}

} // namespace CGAL::Intrinsic_triangulations
#endif

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_POINT_CLOUD_VECTORS_H
