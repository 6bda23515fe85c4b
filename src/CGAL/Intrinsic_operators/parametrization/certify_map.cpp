// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/enum.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polygon = std::vector<Kernel::Point_2>;

bool is_simple(const Polygon& polygon) {
  return polygon.size() >= 3 && CGAL::is_simple_2(polygon.begin(), polygon.end(), Kernel());
}

bool have_disjoint_boxes(const std::vector<Polygon>& polygons) {
  using Box = CGAL::Box_intersection_d::Box_d<double, 2>;
  std::vector<Box> boxes;
  for (const Polygon& polygon : polygons) {
    CGAL::Bbox_2 box;
    for (const Kernel::Point_2& p : polygon) box += p.bbox();
    boxes.emplace_back(box);
  }
  bool result = true;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
                                [&result](const Box&, const Box&) { result = false; });
  return result;
}

} // namespace

Map_certificate certify_map(const std::vector<std::array<std::uint32_t, 3>>& faces,
                            const std::vector<std::uint32_t>& face_numbers,
                            const std::vector<std::vector<std::uint32_t>>& borders,
                            const Eigen::MatrixX2d& uv) {
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
  std::vector<std::vector<Kernel::Point_2>> polygons;
  for (const std::vector<std::uint32_t>& border : borders) {
    polygons.emplace_back();
    for (const std::uint32_t v : border) polygons.back().push_back(point(v));
  }
  result.border_is_simple = !polygons.empty() && std::ranges::all_of(polygons, is_simple) &&
                            (polygons.size() == 1 || have_disjoint_boxes(polygons));
  return result;
}

// The border of each component: the sides without an opposite side, each after the one before it.
// Nothing if a component does not have one border.
static std::vector<std::vector<std::uint32_t>>
borders_of_triangles(const std::vector<std::array<std::uint32_t, 3>>& faces) {
  using Side = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Side> sides;
  std::uint32_t vertices = 0;
  for (const auto& f : faces)
    for (std::size_t k = 0; k < 3; ++k) {
      sides.emplace_back(f[k], f[(k + 1) % 3]);
      vertices = std::max(vertices, f[k] + 1);
    }
  std::sort(sides.begin(), sides.end());
  if (std::adjacent_find(sides.begin(), sides.end()) != sides.end()) return {}; // no manifold
  std::map<std::uint32_t, std::uint32_t> next;
  for (const Side& s : sides)
    if (!std::binary_search(sides.begin(), sides.end(), Side(s.second, s.first)))
      if (!next.insert(s).second) return {};
  const std::vector<std::uint32_t> component = joined_sets(vertices, [&](const auto& join) {
    for (const Side& s : sides) join(s.first, s.second);
  });
  std::set<std::uint32_t> without_border;
  for (const auto& f : faces) without_border.insert(component[f[0]]);
  std::vector<std::vector<std::uint32_t>> borders;
  while (!next.empty()) {
    std::vector<std::uint32_t>& border = borders.emplace_back();
    std::uint32_t v = next.begin()->first;
    if (without_border.erase(component[v]) == 0) return {};
    for (auto after = next.find(v); after != next.end(); after = next.find(v)) {
      border.push_back(v);
      v = after->second;
      next.erase(after);
    }
    if (v != border.front()) return {};
  }
  if (!without_border.empty()) borders.clear();
  return borders;
}

} // namespace internal

Map_certificate certify_map(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                            const Eigen::MatrixX2d& uv) {
  return internal::shortened(
      internal::certify_map(triangles, {}, internal::borders_of_triangles(triangles), uv));
}

Map_certificate certify_map(const Input& input, const Eigen::MatrixX2d& uv) {
  std::vector<std::array<std::uint32_t, 3>> triangles(input.number_of_faces());
  for (std::uint32_t f = 0; f < triangles.size(); ++f) {
    std::uint32_t h = input.halfedge_of_face(f);
    for (std::uint32_t& row : triangles[f]) {
      row = input.names().row(input.source(h));
      h = input.next(h);
    }
  }
  return certify_map(triangles, uv);
}

} // namespace CGAL::Intrinsic_triangulations
