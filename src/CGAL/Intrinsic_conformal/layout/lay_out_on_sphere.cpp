// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/layout/Glued_pieces.h>
#include <CGAL/Intrinsic_conformal/layout/Sphere_centring.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_in_plane.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_on_sphere.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/enum.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

void check_sphere(const Surface_to_cut& s, std::uint32_t pole, std::span<const double> weights) {
  const Gluing& g = s.gluing;
  expect_closed(g, 0, "sphere");
  if (pole >= g.number_of_vertices)
    throw Invalid_input::about(Element_kind::vertex, pole,
                               ", which is to be at infinity, does not exist");
  if (!weights.empty() && weights.size() != g.number_of_vertices)
    throw Invalid_input(Element_kind::none, 0,
                        std::to_string(weights.size()) +
                            " weights are given; give one for each of the " +
                            std::to_string(g.number_of_vertices) + " vertices of the sphere");
  for (std::size_t v = 0; v < weights.size(); ++v)
    if (!(weights[v] >= 0 && std::isfinite(weights[v])))
      throw Invalid_input::about(Element_kind::vertex, v,
                                 " has a weight that is negative or not finite; correct it");
}

// The triangles without a vertex; all vertices keep their numbers.
Surface_to_cut without_star(const Surface_to_cut& s, std::uint32_t pole) {
  const Gluing& g = s.gluing;
  Surface_to_cut rest;
  rest.gluing.number_of_vertices = g.number_of_vertices;
  std::vector<std::uint32_t> side(g.origin.size(), Gluing::none);
  std::uint32_t kept = 0;
  for (std::uint32_t f = 0; f < g.number_of_faces(); ++f) {
    const auto corners = std::span(g.origin).subspan(3 * std::size_t{f}, 3);
    if (std::find(corners.begin(), corners.end(), pole) == corners.end())
      for (std::uint32_t k = 0; k < 3; ++k) side[3 * f + k] = kept++;
  }
  for (std::uint32_t h = 0; h < side.size(); ++h) {
    if (side[h] == Gluing::none) continue;
    rest.gluing.origin.push_back(g.origin[h]);
    rest.gluing.glue.push_back(side[g.glue[h]]);
    rest.length.push_back(s.length[h]);
    if (!s.vector.empty()) rest.vector.push_back(s.vector[h]);
  }
  return rest;
}

Flat_layout planar_rest(const Surface_to_cut& s, std::uint32_t pole) {
  const Surface_to_cut rest = without_star(s, pole);
  const auto fail = [pole] {
    throw Invalid_input::about(
        Element_kind::vertex, pole,
        " cannot be at infinity: the triangles without it are not a disk with "
        "all other vertices; choose another vertex");
  };
  std::vector<char> is_used(s.gluing.number_of_vertices, 1); // or isolated
  for (const std::uint32_t v : s.gluing.origin) is_used[v] = 0;
  is_used[pole] = 1;
  for (const std::uint32_t v : rest.gluing.origin) is_used[v] = 1;
  if (rest.gluing.origin.empty() || std::count(is_used.begin(), is_used.end(), 0) > 0) fail();
  Flat_layout layout = lay_out_in_plane(rest);
  if (!layout.seams.empty() || layout.surface.original_vertex.size() != is_used.size() ||
      connected_components(Gluing_map::from_valid(layout.surface.gluing)).count != 1)
    fail();
  return layout;
}

// Projects the plane, seen from below, from (0, 0, 1): seen from outside, triangles keep their
// orientation. About half of the points come to either half of the sphere.
std::vector<Eigen::Vector3d> on_sphere(const Eigen::MatrixX2d& plane, std::uint32_t pole) {
  Eigen::RowVector2d mean = Eigen::RowVector2d::Zero();
  std::vector<double> distances;
  for (Eigen::Index v = 0; v < plane.rows(); ++v)
    if (v != Eigen::Index{pole}) mean += plane.row(v) / static_cast<double>(plane.rows() - 1);
  for (Eigen::Index v = 0; v < plane.rows(); ++v)
    if (v != Eigen::Index{pole}) distances.push_back((plane.row(v) - mean).norm());
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  std::vector<Eigen::Vector3d> result;
  for (Eigen::Index v = 0; v < plane.rows(); ++v) {
    const Eigen::RowVector2d z = (plane.row(v) - mean) / *middle;
    const double n = z.squaredNorm(), scale = 1 / (1 + n);
    result.emplace_back(2 * scale * z[0], -2 * scale * z[1], (n - 1) * scale);
  }
  result[pole] = {0, 0, 1};
  return result;
}

// Reflects the sphere twice, such that `p` comes to (0, 0, 1).
void turn_to_pole(std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& p) {
  const Eigen::Vector3d north(0, 0, 1);
  const Eigen::Vector3d first = p.z() > 0 ? Eigen::Vector3d(1, 0, 0) : north;
  const auto reflected = [](const Eigen::Vector3d& q, const Eigen::Vector3d& normal) {
    const double square = normal.squaredNorm();
    return square > 0 ? Eigen::Vector3d(q - 2 * normal.dot(q) / square * normal) : q;
  };
  // the second reflection takes the image of p to the pole
  const Eigen::Vector3d second = reflected(p, first) - north;
  const bool is_there = second.squaredNorm() == 0;
  for (Eigen::Vector3d& q : points)
    q = reflected(reflected(q, first), is_there ? Eigen::Vector3d(1, 0, 0) : second);
}

std::size_t count_flipped(const Gluing& g, const std::vector<std::array<double, 3>>& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto point = [&](std::uint32_t h) {
    const std::array<double, 3>& p = points[g.origin[h]];
    return Kernel::Point_3(p[0], p[1], p[2]);
  };
  const Kernel::Point_3 centre(0, 0, 0);
  std::size_t flipped = 0;
  for (std::uint32_t h = 0; h < g.origin.size(); h += 3)
    if (CGAL::orientation(centre, point(h), point(h + 1), point(h + 2)) != CGAL::POSITIVE)
      ++flipped;
  return flipped;
}

} // namespace

} // namespace internal

Sphere_layout lay_out_on_sphere(const Surface_to_cut& s, std::uint32_t pole,
                                std::span<const double> weights) {
  internal::check_sphere(s, pole, weights);
  const Flat_layout plane = internal::planar_rest(s, pole);
  internal::Sphere_centring centring;
  centring.points = internal::on_sphere(plane.positions, pole);
  centring.weights.setOnes(static_cast<Eigen::Index>(centring.points.size()));
  for (std::size_t v = 0; v < weights.size(); ++v)
    centring.weights[static_cast<Eigen::Index>(v)] = weights[v];
  centring.weights /= centring.weights.sum();
  centring.run();
  internal::turn_to_pole(centring.points, Eigen::Vector3d(centring.points[pole]));
  Sphere_layout result;
  result.pole = pole;
  result.distance_of_mean = centring.mean().norm();
  result.iterations = centring.iterations;
  result.is_centred = centring.is_centred;
  result.largest_side_error = plane.largest_side_error;
  for (const Eigen::Vector3d& p : centring.points) result.positions.push_back({p[0], p[1], p[2]});
  result.flipped_faces = internal::count_flipped(s.gluing, result.positions);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
