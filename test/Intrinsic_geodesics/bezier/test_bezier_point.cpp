// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "planar_bezier.h"

#include <CGAL/Intrinsic_geodesics/bezier/bezier_point.h>
#include <CGAL/Intrinsic_geodesics/bezier/make_bezier_curve.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                          IT::Integer_coordinates>;
using meshes::Point;
using planar_bezier::distance;
using planar_bezier::planar;
using planar_bezier::vertex_at;

IT::Surface_point at_vertex(const Exact& t, std::uint32_t i) {
  const IT::Input& input = t.input();
  for (std::uint32_t h = 0;; ++h)
    if (!input.is_border(h) && input.names().row(input.source(h)) == i) return {h, {1, 0, 0}};
}

// the largest step between points of the curve at multiples of 1 / n
double largest_step(Exact& t, const meshes::Mesh& m, const std::vector<IT::Surface_point>& control,
                    int n) {
  IT::Geodesic_finder<Exact> find(t);
  double step = 0;
  Point before{};
  for (int i = 0; i <= n; ++i) {
    const IT::Bezier_point p = IT::bezier_point(t, find, control, static_cast<double>(i) / n);
    EXPECT_EQ(p.status, IT::Status::done);
    const Point at = IT::point_in_space(t, p.point, m.points);
    if (i > 0) step = std::max(step, distance(before, at));
    before = at;
  }
  return step;
}

} // namespace

TEST(Bezier_point, is_on_the_planar_curve_in_a_plane) {
  const meshes::Mesh m = meshes::grid(10, 10);
  const std::vector<std::array<double, 2>> places{{0, 0}, {2, 7}, {9, 8}, {10, 1}};
  Exact t(m.input());
  IT::Geodesic_finder<Exact> find(t);
  std::vector<IT::Surface_point> control;
  std::vector<Point> points;
  for (const auto& p : places) {
    control.push_back(at_vertex(t, vertex_at(m, p[0], p[1])));
    points.push_back({p[0], p[1], 0});
    const IT::Bezier_point b = IT::bezier_point(t, find, control, 0.3);
    ASSERT_EQ(b.status, IT::Status::done);
    // each of six divisions, and of insertions that they start from, rounds by a few 2^-52 of lengths up to 14
    EXPECT_LT(distance(IT::point_in_space(t, b.point, m.points), planar(points, 0.3)), 1e-12);
  }
}

TEST(Bezier_point, stays_at_control_points_that_are_one) {
  const meshes::Mesh m = meshes::grid(4, 4);
  Exact t(m.input());
  IT::Geodesic_finder<Exact> find(t);
  const IT::Surface_point p = at_vertex(t, vertex_at(m, 2, 1));
  const IT::Bezier_point b = IT::bezier_point(t, find, {p, p, p}, 0.4);
  EXPECT_EQ(distance(IT::point_in_space(t, b.point, m.points), {2, 1, 0}), 0);
}

TEST(Bezier_point, jumps_beside_a_peak) {
  // The peak is between the curve of three points and their polygon: the shortest path between the
  // points that divide the two sides leads round the peak on one side, then on the other, then on
  // the first one again.
  meshes::Mesh plane = meshes::grid(12, 12), peak = plane;
  peak.points[vertex_at(peak, 6, 7)][2] = 20;
  const auto step = [](const meshes::Mesh& m, int n) {
    Exact t(m.input());
    return largest_step(t, m,
                        {at_vertex(t, vertex_at(m, 0, 1)), at_vertex(t, vertex_at(m, 7, 11)),
                         at_vertex(t, vertex_at(m, 12, 2))},
                        n);
  };
  EXPECT_LT(step(plane, 256), 0.6 * step(plane, 128)); // goes to zero with 1 / n
  EXPECT_GT(step(peak, 256), 0.9 * step(peak, 128));
  EXPECT_GT(step(peak, 256), 0.5);
}
