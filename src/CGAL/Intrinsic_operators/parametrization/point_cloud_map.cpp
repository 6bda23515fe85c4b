// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/parametrization/Border_spectrum.h>
#include <CGAL/Intrinsic_operators/parametrization/point_cloud_map.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_operators/vectors/Cloud_connection.h>
#include <CGAL/Intrinsic_triangulations/domains/Point_cloud.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// A third of the area of all triangles, as a form of the complex places of their corners.
static Complex_matrix area_form(const Cloud_connection& cloud) {
  std::vector<Eigen::Triplet<std::complex<double>>> entries;
  for (const auto& t : cloud.triangles())
    for (std::size_t k = 0; k < 3; ++k) { // 1/2 Im(conj(w_i) w_j) on each side
      const auto i = static_cast<int>(t[k]), j = static_cast<int>(t[(k + 1) % 3]);
      entries.emplace_back(i, j, std::complex<double>(0, -1. / 12));
      entries.emplace_back(j, i, std::complex<double>(0, 1. / 12));
    }
  const auto n = static_cast<Eigen::Index>(cloud.places().size());
  return matrix_of(n, n, entries);
}

// Half of the Dirichlet energy, minus the area.
static Complex_matrix conformal_energy(const Cloud_connection& cloud, const Complex_matrix& area) {
  std::vector<Eigen::Triplet<std::complex<double>>> entries;
  for (const Cloud_edge& e : cloud.edges()) {
    const auto i = static_cast<int>(e.source), j = static_cast<int>(e.target);
    for (const int k : {i, j}) entries.emplace_back(k, k, e.weight / 2);
    entries.emplace_back(i, j, -e.weight / 2);
    entries.emplace_back(j, i, -e.weight / 2);
  }
  Complex_matrix energy = matrix_of(area.rows(), area.cols(), entries);
  energy -= area;
  energy.makeCompressed();
  return energy;
}

// The points on the border, with equal weights.
static Disk_border cloud_border(const Cloud_connection& cloud) {
  const auto refuse = [](const std::string& why) {
    throw Invalid_input(Element_kind::none, 0, why);
  };
  if (cloud.seam_edges() > 0)
    refuse("tangent planes of the points cannot be oriented alike: the surface has one side, or "
           "the points are too few; give points of a disk, or more of them");
  const std::vector<std::uint32_t> part = cloud.graph().parts();
  Disk_border border;
  std::uint32_t first = static_cast<std::uint32_t>(part.size());
  for (const auto& t : cloud.triangles()) {
    if (first == part.size()) first = part[t[0]];
    if (part[t[0]] != first)
      refuse("points " + std::to_string(first) + " and " + std::to_string(t[0]) +
             " are not connected by triangles; give points of one component");
  }
  for (std::uint32_t i = 0; i < part.size(); ++i)
    if (cloud.report().is_on_border[i] != 0 && cloud.first_axis(i).norm() > 0)
      border.rows.push_back(i);
  if (border.rows.size() < 3)
    refuse("the points have no border, so that no map to the plane has the least conformal "
           "energy; give points of a disk");
  border.lengths.assign(border.rows.size(), 1);
  return border;
}

Eigen::MatrixX2d conformal_map_of_points(const std::vector<std::array<double, 3>>& points,
                                         std::size_t neighbours,
                                         const std::function<bool(std::size_t)>& progress) {
  if (!progress(0)) return {};
  const Cloud_connection cloud(points, neighbours);
  const Disk_border border = cloud_border(cloud);
  const Complex_matrix form = area_form(cloud);
  std::size_t solutions = 0;
  Eigen::VectorXcd w = first_of_border_spectrum(conformal_energy(cloud, form), border,
                                                [&] { return progress(++solutions); });
  if (w.size() == 0) return {};
  const std::complex<double> start = w[border.rows[0]];
  if (std::abs(start) > 0) w *= std::conj(start) / std::abs(start);
  double area = 0;
  for (const double a : cloud.graph().areas) area += a;
  const double of_image = std::real(w.dot(form * w));
  w *= std::ldexp(of_image > 0 ? std::sqrt(area / of_image) : 1, cloud.exponent());
  const std::vector<std::uint32_t> first_at_place = first_points_at_places(points);
  Eigen::MatrixX2d result(w.size(), 2);
  for (Eigen::Index i = 0; i < w.size(); ++i) {
    const std::uint32_t first = first_at_place[static_cast<std::size_t>(i)];
    const bool is_known = cloud.first_axis(first).norm() > 0;
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    result.row(i) << (is_known ? w[first].real() : unknown), (is_known ? w[first].imag() : unknown);
  }
  return result;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
