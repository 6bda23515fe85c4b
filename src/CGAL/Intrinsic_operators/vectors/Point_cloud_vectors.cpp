// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/vectors/Cloud_connection.h>
#include <CGAL/Intrinsic_operators/vectors/Direction_problem.h>
#include <CGAL/Intrinsic_operators/vectors/Heat_transport.h>
#include <CGAL/Intrinsic_operators/vectors/Point_cloud_vectors.h>
#include <CGAL/Intrinsic_operators/vectors/direction_field.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/domains/Point_cloud.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>

#include <array>
#include <complex>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

Point_cloud_vectors::Point_cloud_vectors(const std::vector<std::array<double, 3>>& points,
                                         std::size_t neighbours, double time_factor)
    : points_(points), first_at_place_(internal::first_points_at_places(points)) {
  const internal::Cloud_connection connection(points, neighbours);
  exponent_ = connection.exponent();
  const auto vector = [](const Eigen::Vector3d& v) { return std::array{v[0], v[1], v[2]}; };
  for (const std::uint32_t i : first_at_place_)
    axes_.push_back({vector(connection.first_axis(i)), vector(connection.second_axis(i))});
  seam_edges_ = connection.seam_edges();
  heat_.emplace(connection.graph(), time_factor);
}

std::array<double, 3> Point_cloud_vectors::in_space(std::size_t i, const Complex& z) const {
  std::array<double, 3> result{};
  for (std::size_t c = 0; c < 3; ++c)
    result[c] = z.real() * axes_[i][0][c] + z.imag() * axes_[i][1][c];
  return result;
}

std::size_t Point_cloud_vectors::with_plane(std::size_t i) const {
  if (i >= size())
    throw std::invalid_argument("there is no point " + std::to_string(i) + "; there are " +
                                std::to_string(size()));
  if (axes_[i][0] == std::array<double, 3>{})
    throw std::invalid_argument("point " + std::to_string(i) +
                                " has no triangles, and so no vectors: it lies on a line with its "
                                "neighbours");
  return first_at_place_[i];
}

std::vector<double> Point_cloud_vectors::extend_scalars(
    const std::vector<std::pair<std::size_t, double>>& sources) const {
  internal::Vector_sources s(size());
  for (const auto& [i, value] : sources) {
    s.add(static_cast<Eigen::Index>(with_plane(i)), 1, value);
  }
  return at_all_points<double>(heat_->extended(s));
}

Tangent_field
Point_cloud_vectors::transport(const std::vector<std::pair<std::size_t, Complex>>& sources) const {
  internal::Vector_sources s(size());
  for (const auto& [i, z] : sources) {
    const auto row = static_cast<Eigen::Index>(with_plane(i));
    s.add(row, 1, std::abs(z));
    s.vectors[row] += z;
  }
  return at_all_points<Complex>(heat_->transported(s, heat_->extended(s)));
}

std::vector<std::complex<double>> Point_cloud_vectors::logarithmic_map(std::size_t i) const {
  const std::size_t at = with_plane(i);
  std::vector<Complex> result =
      at_all_points<Complex>(heat_->affine_logarithm(static_cast<Eigen::Index>(at)));
  for (Complex& z : result) z *= std::ldexp(1., exponent_);
  internal::lengthen_to_chords(points_, {}, at, 1, result);
  return result;
}

Direction_field
Point_cloud_vectors::direction_field(int degree,
                                     const std::vector<std::pair<std::size_t, Complex>>& fixed,
                                     const std::function<bool(Direction_step)>& progress) const {
  if (degree < 1)
    throw std::invalid_argument("a field has at least one direction at a vertex, not " +
                                std::to_string(degree));
  internal::Direction_problem problem{
      degree, Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(size())), 0, {}};
  for (const auto& [i, z] : fixed) {
    const std::size_t point = with_plane(i);
    const Complex u = internal::unit_vector(z);
    if (u == 0.)
      throw std::invalid_argument("the direction at point " + std::to_string(i) +
                                  " cannot be fixed: it is zero or not finite");
    problem.fixed.push_back({point, internal::power_of(u, degree)});
  }
  Direction_field field{degree, internal::solve(problem, heat_->graph(), progress)};
  if (field.powers.empty() && size() > 0)
    field.status = Status::cancelled;
  else
    field.powers = at_all_points<Complex>(field.powers);
  return field;
}

} // namespace CGAL::Intrinsic_triangulations
