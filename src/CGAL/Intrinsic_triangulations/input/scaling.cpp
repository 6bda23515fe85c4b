// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/scaling.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

static double largest_coordinate(const std::vector<std::array<double, 3>>& points) {
  double largest = 0;
  for (std::size_t v = 0; v < points.size(); ++v)
    for (const double x : points[v]) {
      if (!std::isfinite(x))
        throw Invalid_input::about(Element_kind::vertex, v,
                                   " has a coordinate that is not finite; repair or remove it");
      largest = std::max(largest, std::abs(x));
    }
  return largest;
}

} // namespace internal

int scale_points(const Gluing_map& mesh, std::vector<std::array<double, 3>>& points) {
  const double largest = internal::largest_coordinate(points);
  // max-norm lengths of coordinates of at most 1: their sum does not overflow
  const int first = largest > 0 ? -std::ilogb(largest) - 1 : 0;
  const internal::Power_of_two unit(first + 1);
  const std::uint32_t samples = std::min(mesh.number_of_edges(), 4096U);
  double sum = 0;
  for (std::uint32_t i = 0; i < samples; ++i) {
    const auto e = static_cast<std::uint32_t>(std::uint64_t{mesh.number_of_edges()} * i / samples);
    const auto& p = points[mesh.source({2 * e}).index];
    const auto& q = points[mesh.target({2 * e}).index];
    sum += unit(std::max({std::abs(p[0] / 2 - q[0] / 2), std::abs(p[1] / 2 - q[1] / 2),
                          std::abs(p[2] / 2 - q[2] / 2)}));
  }
  const int exponent = sum > 0 ? first - std::ilogb(sum / samples) : 0;
  const internal::Power_of_two power(exponent);
  for (std::size_t v = 0; v < points.size(); ++v)
    for (double& x : points[v])
      if (!power.scale(x))
        throw Invalid_input::about(Element_kind::vertex, v,
                                   " has a coordinate more than 2^1000 times smaller than the mean "
                                   "edge; set it to 0");
  return exponent;
}

int scale_squared_lengths(std::vector<double>& squared_lengths) {
  double largest = 0;
  for (std::size_t e = 0; e < squared_lengths.size(); ++e) {
    const double x = squared_lengths[e];
    if (!std::isfinite(x) || x < 0)
      throw Invalid_input::about(
          Element_kind::edge, e,
          " has a squared length that is negative or not finite; correct it");
    largest = std::max(largest, x);
  }
  const int exponent = largest > 0 ? -std::ilogb(largest) / 2 : 0;
  const internal::Power_of_two power(2 * exponent);
  for (std::size_t e = 0; e < squared_lengths.size(); ++e)
    if (!power.scale(squared_lengths[e]))
      throw Invalid_input::about(Element_kind::edge, e,
                                 " has a squared length more than 2^1000 times smaller than the "
                                 "largest; set it to 0");
  return exponent;
}

} // namespace CGAL::Intrinsic_triangulations
