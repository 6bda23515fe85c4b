// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_to_target.h>

#include "meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Geodesic_target;
using IT::Input;
using IT::Surface_point;
using IT::internal::Geodesic_to_target;
using Walk = IT::internal::Geodesic_walk<Input>;
using Point = std::array<double, 3>;
// A correspondence whose input must keep its surface.
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>,
                                                  IT::Integer_coordinates>;

/// A triangulation of points with small integer coordinates in the plane.
struct Planar {
  meshes::Mesh mesh;
  Input surface;
  double unit;

  explicit Planar(meshes::Mesh m) : mesh(std::move(m)) {
    IT::Intrinsic_input input = mesh.input();
    input.may_renumber = false;
    const Triangulation t(std::move(input));
    surface = t.input();
    unit = std::ldexp(1.0, t.metric().scale_exponent());
  }
  const Point& corner(std::uint32_t h) const { return mesh.points[surface.source(h)]; }
};

double turn(const Point& a, const Point& b, const Point& c) { // exact for small integers
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Whether a vertex is inside a segment.
bool meets_a_vertex(const meshes::Mesh& m, const Point& a, const Point& b) {
  for (const Point& p : m.points) {
    const double along = (p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1]);
    const double all = (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]);
    if (turn(a, b, p) == 0 && along > 0 && along < all) return true;
  }
  return false;
}

/// A halfedge from each vertex that has a face.
std::vector<std::uint32_t> outgoing(const Input& s) {
  std::vector<std::uint32_t> result(s.number_of_vertices());
  for (std::uint32_t h = 0; h < s.number_of_halfedges(); ++h)
    if (!s.is_border(h)) result[s.source(h)] = h;
  return result;
}

struct Attempt {
  Point from, to;
  Geodesic_to_target result;
  std::vector<IT::internal::Strip_side> strip;
};

/// Traces from vertex to vertex in a direction and for a length that are slightly wrong.
Attempt attempt(const Planar& p, std::uint32_t h, std::uint32_t w, double bend, double stretch) {
  Attempt a{p.corner(h), p.mesh.points[w], {}, {}};
  const Point& b = p.corner(h ^ 1U);
  double angle = std::atan2(turn(a.from, b, a.to), (b[0] - a.from[0]) * (a.to[0] - a.from[0]) +
                                                       (b[1] - a.from[1]) * (a.to[1] - a.from[1]));
  const double length = std::hypot(a.to[0] - a.from[0], a.to[1] - a.from[1]) * p.unit;
  const Walk walk(p.surface, IT::Corner_direction{h, angle + bend});
  a.result = IT::internal::trace_to_target(p.surface, walk, Geodesic_target::at_vertex(w),
                                           length * (1 + stretch), a.strip);
  return a;
}

} // namespace

TEST(Geodesic_to_target, Joins_vertices_in_the_plane_by_the_segment_between_them) {
  for (unsigned seed = 1; seed < 5; ++seed) {
    const Planar p(meshes::random_planar(80, 1000, seed));
    const std::vector<std::uint32_t> from = outgoing(p.surface);
    std::mt19937 random(seed);
    int reached = 0;
    for (int i = 0; i < 300; ++i) {
      const std::uint32_t v = static_cast<std::uint32_t>(random() % from.size());
      const std::uint32_t w = static_cast<std::uint32_t>(random() % from.size());
      if (v == w) continue;
      const Attempt a = attempt(p, from[v], w, 1e-10, -1e-9);
      const bool meets = meets_a_vertex(p.mesh, a.from, a.to);
      EXPECT_FALSE(meets && a.result.is_certain);
      if (meets || !a.result.is_reached) continue; // it may leave through the border: too bent
      ++reached;
      EXPECT_TRUE(a.result.is_certain);
      EXPECT_NEAR(a.result.slope, -1e-10, 1e-13);
      for (const IT::internal::Strip_side& s : a.strip) {
        const Point &c = p.corner(s.halfedge), &d = p.corner(s.halfedge ^ 1U);
        const double right = -turn(a.from, a.to, c), left = turn(a.from, a.to, d);
        ASSERT_GE(right, 0);
        ASSERT_GE(left, 0);
        EXPECT_NEAR(s.parameter(a.result.slope), right / (right + left), 1e-11);
      }
    }
    EXPECT_GT(reached, 200);
  }
}

TEST(Geodesic_to_target, Does_not_claim_a_target_that_is_elsewhere) {
  const Planar p(meshes::random_planar(80, 1000, 7));
  const std::vector<std::uint32_t> from = outgoing(p.surface);
  std::mt19937 random(7);
  for (int i = 0; i < 500; ++i) {
    const std::uint32_t v = static_cast<std::uint32_t>(random() % from.size());
    const std::uint32_t w = static_cast<std::uint32_t>(random() % from.size());
    if (v == w) continue;
    EXPECT_FALSE(attempt(p, from[v], w, 0.05, 0).result.is_reached);
    EXPECT_FALSE(attempt(p, from[v], w, 0, 0.05).result.is_reached);
    EXPECT_FALSE(attempt(p, from[v], w, 0, -0.05).result.is_reached);
  }
}

TEST(Geodesic_to_target, Tells_edges_and_parts_of_edges_that_it_runs_along) {
  const Planar p(meshes::random_planar(40, 1000, 9));
  const std::vector<std::uint32_t> from = outgoing(p.surface);
  std::vector<IT::internal::Strip_side> strip;
  for (std::uint32_t h = 0; h < p.surface.number_of_halfedges(); ++h) {
    const double length = std::sqrt(p.surface.squared_length(h / 2));
    for (const double bend : {0.0, 1e-14, -1e-14}) {
      const Walk walk(p.surface, IT::Corner_direction{h, bend});
      const Geodesic_to_target r = IT::internal::trace_to_target(
          p.surface, walk, Geodesic_target::at_vertex(p.surface.target(h)), length, strip);
      if (!r.is_reached) continue; // bent out of the surface
      EXPECT_EQ(r.along, h);
      EXPECT_TRUE(strip.empty());
    }
    if (p.surface.is_border(h)) continue;
    const Surface_point a{h, {0.75, 0.25, 0}}, b{h, {0.125, 0.875, 0}};
    for (const auto& [x, y, sign] : {std::tuple{a, b, 1.0}, {b, a, -1.0}}) {
      const Geodesic_to_target r = IT::internal::trace_to_target(
          p.surface, Walk(p.surface, x, {sign, 0}), Geodesic_target::at_point(p.surface, y),
          0.625 * length, strip);
      EXPECT_TRUE(r.is_reached);
      EXPECT_EQ(r.along, sign > 0 ? h : h ^ 1U);
    }
  }
}
