// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Polyhedron_points.h>
#include <CGAL/Intrinsic_simplification/embedding/Precise_points.h>
#include <CGAL/Intrinsic_simplification/embedding/Pyramids.h>
#include <CGAL/Intrinsic_simplification/embedding/decrease_curvatures.h>
#include <CGAL/Intrinsic_simplification/embedding/doubly_covered_polygon.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

using Polygon_point = std::array<Double_double, 2>;

// For each halfedge, whether its edge is folded by more than a right angle.
std::vector<char> folded(const Metric_triangles& t, const Pyramids& pyramids) {
  std::vector<char> result(t.number_of_halfedges());
  const auto cosine = [&](std::uint32_t h) { // of the dihedral angle under one face
    return pyramids.foot[h] / std::hypot(pyramids.foot[h], pyramids.height[h / 3]);
  };
  for (std::uint32_t h = 0; h < t.number_of_halfedges(); ++h)
    result[h] = cosine(h) + cosine(t.opposite(h)) > 1 ? 1 : 0;
  return result;
}

// A halfedge of the front along the border, if each vertex is on the border once.
std::uint32_t border_halfedge(const Metric_triangles& t, const std::vector<char>& is_folded) {
  std::vector<std::uint32_t> ends(t.number_of_vertices(), 0);
  std::uint32_t result = Gluing::none;
  for (std::uint32_t h = 0; h < t.number_of_halfedges(); ++h) {
    if (is_folded[h] == 0) continue;
    ++ends[t.source(h)];
    result = h;
  }
  const bool is_cycle = std::all_of(ends.begin(), ends.end(), [](auto n) { return n == 2; });
  return is_cycle ? result : Gluing::none;
}

// The point at the end of the face on the left of h.
Polygon_point third_corner(const Metric_triangles& t, std::uint32_t h, const Polygon_point& p,
                           const Polygon_point& q) {
  const Double_double &a = t.squared_length(h), &b = t.squared_length(Metric_triangles::next(h)),
                      &c = t.squared_length(Metric_triangles::previous(h));
  const Double_double twice = a + a, x = (a + c - b) / twice, squared = c / a - x * x;
  const Double_double y = squared.to_double() > 0 ? sqrt(squared) : Double_double(0);
  const Double_double dx = q[0] - p[0], dy = q[1] - p[1];
  return {p[0] + x * dx - y * dy, p[1] + x * dy + y * dx};
}

// Lays out the part on the left of h up to folded edges, with the side of h on an axis.
// \return whether the part has all vertices and is a disk
bool lay_out_part(const Metric_triangles& t, const std::vector<char>& is_folded, std::uint32_t h,
                  std::vector<Polygon_point>& points) {
  std::vector<char> is_placed(t.number_of_vertices(), 0);
  points.assign(t.number_of_vertices(), {});
  points[t.target(h)] = {sqrt(t.squared_length(h)), Double_double(0)};
  if (t.source(h) == t.target(h)) return false;
  is_placed[t.source(h)] = is_placed[t.target(h)] = 1;
  std::size_t placed = 2;
  std::vector<std::uint32_t> stack{h};
  while (!stack.empty()) {
    const std::uint32_t k = stack.back(), last = Metric_triangles::previous(k), v = t.source(last);
    stack.pop_back();
    if (is_placed[v] != 0) return false; // a disk without inner vertices meets each vertex once
    is_placed[v] = 1;
    ++placed;
    points[v] = third_corner(t, k, points[t.source(k)], points[t.target(k)]);
    for (const std::uint32_t side : {Metric_triangles::next(k), last})
      if (is_folded[side] == 0) stack.push_back(t.opposite(side));
  }
  return placed == t.number_of_vertices();
}

} // namespace

std::optional<Covered_polygon> doubly_covered_polygon(const Glued_pyramids& p) {
  constexpr double same = 1e-10;
  const Metric_triangles& t = p.triangles;
  Pyramids pyramids;
  if (!pyramids.build(t, p.radii)) return {};
  const std::vector<char> is_folded = folded(t, pyramids);
  const std::uint32_t h = border_halfedge(t, is_folded);
  std::vector<Polygon_point> front, back;
  if (h == Gluing::none || !lay_out_part(t, is_folded, h, front) ||
      !lay_out_part(t, is_folded, t.opposite(h), back))
    return {};
  Covered_polygon result{{}, 0};
  for (std::size_t v = 0; v < front.size(); ++v) { // the back starts at the other end of h
    const Double_double x = front[v][0] + back[v][0] - sqrt(t.squared_length(h)),
                        y = front[v][1] - back[v][1];
    result.difference = std::max(result.difference, std::hypot(x.to_double(), y.to_double()));
    result.corners.push_back({front[v][0], front[v][1], Double_double(0)});
  }
  if (result.difference > same * extent_of(result.corners)) return {};
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
