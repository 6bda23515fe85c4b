// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/enum.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

Map_certificate certify_map(const std::vector<std::array<std::uint32_t, 3>>& faces,
                            const std::vector<std::uint32_t>& face_numbers,
                            const std::vector<std::uint32_t>& border, const Eigen::MatrixX2d& uv) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  if (!uv.allFinite()) throw std::invalid_argument("the coordinates of a map must be finite");
  const auto point = [&uv](std::uint32_t v) {
    if (Eigen::Index{v} >= uv.rows())
      throw std::invalid_argument("the map has no row " + std::to_string(v));
    return Kernel::Point_2(uv(v, 0), uv(v, 1));
  };
  Map_certificate result;
  result.faces = faces.size();
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const CGAL::Orientation turn =
        CGAL::orientation(point(faces[f][0]), point(faces[f][1]), point(faces[f][2]));
    if (turn == CGAL::LEFT_TURN) continue;
    ++(turn == CGAL::COLLINEAR ? result.degenerate : result.flipped);
    result.bad_faces.push_back(face_numbers.empty() ? static_cast<std::uint32_t>(f)
                                                    : face_numbers[f]);
  }
  std::sort(result.bad_faces.begin(), result.bad_faces.end());
  std::vector<Kernel::Point_2> polygon;
  for (const std::uint32_t v : border) polygon.push_back(point(v));
  result.border_is_simple =
      polygon.size() >= 3 && CGAL::is_simple_2(polygon.begin(), polygon.end(), Kernel());
  return result;
}

// The sides without an opposite side, each after the one before it on the border.
static std::vector<std::uint32_t>
border_of_triangles(const std::vector<std::array<std::uint32_t, 3>>& faces) {
  using Side = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Side> sides;
  for (const auto& f : faces)
    for (std::size_t k = 0; k < 3; ++k) sides.emplace_back(f[k], f[(k + 1) % 3]);
  std::sort(sides.begin(), sides.end());
  if (std::adjacent_find(sides.begin(), sides.end()) != sides.end()) return {}; // no manifold
  std::map<std::uint32_t, std::uint32_t> next;
  for (const Side& s : sides)
    if (!std::binary_search(sides.begin(), sides.end(), Side(s.second, s.first)))
      if (!next.insert(s).second) return {};
  std::vector<std::uint32_t> border;
  if (next.empty()) return border;
  for (std::uint32_t v = next.begin()->first; border.size() < next.size();) {
    border.push_back(v);
    const auto after = next.find(v);
    if (after == next.end()) return {};
    v = after->second;
    if (v == border.front()) break;
  }
  if (border.size() < next.size()) border.clear();
  return border;
}

} // namespace internal

Map_certificate certify_map(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                            const Eigen::MatrixX2d& uv) {
  return internal::shortened(
      internal::certify_map(triangles, {}, internal::border_of_triangles(triangles), uv));
}

} // namespace CGAL::Intrinsic_triangulations
