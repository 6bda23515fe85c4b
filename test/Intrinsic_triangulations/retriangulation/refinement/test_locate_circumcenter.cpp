// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/locate_circumcenter.h>

#include "meshes.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Kind = IT::Located_circumcenter::Kind;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>;
using View = IT::Intrinsic_view<Triangulation>;
using Point = std::array<double, 2>;

Triangulation triangulation(const meshes::Mesh& m) {
  IT::Intrinsic_input i = m.input();
  i.may_renumber = false;
  return Triangulation(std::move(i));
}

Point position(const View& view, const meshes::Mesh& m, const IT::Surface_point& p) {
  Point x{0, 0};
  std::uint32_t h = p.halfedge;
  for (std::size_t k = 0; k < 3; ++k, h = view.next(h))
    for (std::size_t d = 0; d < 2; ++d) x[d] += p.weights[k] * m.points[view.source(h)][d];
  return x;
}

/// In units of the plane; the metric is scaled.
double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

TEST(Locate_circumcenter, Has_the_same_distance_from_all_corners_in_the_plane) {
  const meshes::Mesh m = meshes::random_planar(60, 100, 3);
  const Triangulation t = triangulation(m);
  const View view(t);
  const auto is_border = [&](std::uint32_t h) { return view.is_border(h ^ 1U); };
  std::size_t inside = 0, beyond = 0;
  for (const auto f : faces(t.mesh())) {
    const std::uint32_t h = view.halfedge_of_face(t.index(f));
    const auto c = IT::locate_circumcenter(view, h, is_border);
    ASSERT_NE(c.kind, Kind::none);
    if (c.kind == Kind::segment) {
      EXPECT_TRUE(is_border(c.segment));
      ++beyond;
      continue;
    }
    ++inside;
    const Point p = position(view, m, c.point);
    double least = 1e300, greatest = 0;
    std::uint32_t g = h;
    for (int k = 0; k < 3; ++k, g = view.next(g)) {
      const meshes::Point& v = m.points[view.source(g)];
      const double d = distance(p, {v[0], v[1]});
      least = std::min(least, d);
      greatest = std::max(greatest, d);
    }
    // points are moved by at most 2^-30 of a height onto edges
    EXPECT_NEAR(least, greatest, 1e-7 * greatest);
  }
  EXPECT_GT(inside, 10U);
  EXPECT_GT(beyond, 3U);
}

TEST(Locate_circumcenter, Of_a_right_triangle_is_on_its_longest_side) {
  const Triangulation t = triangulation(meshes::grid(2, 2));
  const View view(t);
  for (const auto f : faces(t.mesh())) {
    const std::uint32_t h = view.halfedge_of_face(t.index(f));
    const auto c = IT::locate_circumcenter(view, h, [](std::uint32_t) { return false; });
    ASSERT_EQ(c.kind, Kind::point);
    int zeros = 0, halves = 0;
    for (const double w : c.point.weights) {
      zeros += w == 0 ? 1 : 0;
      halves += std::abs(w - 0.5) < 1e-15 ? 1 : 0;
    }
    EXPECT_EQ(zeros, 1);
    EXPECT_EQ(halves, 2);
    const auto stopped = IT::locate_circumcenter(view, h, [](std::uint32_t) { return true; });
    EXPECT_EQ(stopped.kind, Kind::segment);
    EXPECT_NEAR(view.squared_length(stopped.segment / 2),
                2 * std::min(view.squared_length(h / 2), view.squared_length(view.next(h) / 2)),
                1e-12);
  }
}

TEST(Locate_circumcenter, Of_a_face_without_area_is_nowhere) {
  IT::Intrinsic_input i = meshes::with_cap(meshes::grid(1, 1), 0).input();
  i.may_renumber = false;
  const Triangulation t(std::move(i));
  const View view(t);
  std::size_t nowhere = 0;
  for (const auto f : faces(t.mesh()))
    if (t.area(f) == 0)
      nowhere += IT::locate_circumcenter(
                     view, view.halfedge_of_face(t.index(f)),
                     [](std::uint32_t) {
                       return false;
                     }).kind == Kind::none
                     ? 1
                     : 0;
  EXPECT_EQ(nowhere, 1U);
}

} // namespace
