// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/tracing/trace_geodesic.h>

#include "gallery.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Corner_direction;
using IT::Geodesic_crossing;
using IT::Input;
using IT::Status;
using IT::Surface_point;
using IT::internal::Geodesic_end;
using Point = std::array<double, 3>;
using Vector = IT::Plane_vector<double>;
// A correspondence whose input must keep its surface.
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>,
                                                  IT::Integer_coordinates>;

constexpr double pi = std::numbers::pi;

/// A surface with the position of each of its vertices, in its scaled units.
struct Placed {
  Input surface;
  std::vector<Point> points;

  explicit Placed(const meshes::Mesh& m) : points(m.points) {
    IT::Intrinsic_input input = m.input();
    input.may_renumber = false;
    const Triangulation t(std::move(input));
    surface = t.input();
    for (Point& p : points)
      for (double& x : p) x = std::ldexp(x, t.metric().scale_exponent());
  }
  /// Scale of a length that is given in the units of the mesh.
  double unit(const meshes::Mesh& m) const {
    for (std::size_t v = 0; v < points.size(); ++v)
      for (std::size_t k = 0; k < 3; ++k)
        if (m.points[v][k] != 0) return points[v][k] / m.points[v][k];
    return 1;
  }
  Point corner(std::uint32_t h) const { return points[surface.source(h)]; }
  Point position(const Surface_point& p) const { return meshes::position(surface, points, p); }
  Point position(const Geodesic_crossing& c) const {
    Point x{0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k)
      x[k] = (1 - c.parameter) * corner(c.halfedge)[k] + c.parameter * corner(c.halfedge ^ 1U)[k];
    return x;
  }
  /// The direction in space of a vector in the frame of a halfedge.
  Point in_space(std::uint32_t h, const Vector& v) const {
    const Point a = corner(h), b = corner(h ^ 1U), c = corner(surface.next(surface.next(h)));
    Point e{}, f{};
    double l = 0, ef = 0, ff = 0;
    for (std::size_t k = 0; k < 3; ++k) e[k] = b[k] - a[k], l += e[k] * e[k];
    l = std::sqrt(l);
    for (std::size_t k = 0; k < 3; ++k) e[k] /= l, ef += e[k] * (c[k] - a[k]);
    for (std::size_t k = 0; k < 3; ++k) f[k] = c[k] - a[k] - ef * e[k], ff += f[k] * f[k];
    ff = std::sqrt(ff);
    if (a[2] == 0 && b[2] == 0 && c[2] == 0) f = {-e[1], e[0], 0}, ff = 1; // free of cancellation
    Point d{};
    for (std::size_t k = 0; k < 3; ++k) d[k] = v[0] * e[k] + v[1] * f[k] / ff;
    return d;
  }
};

using meshes::distance;

/// Length of the polyline from a start through crossings to an end.
double polyline_length(const Placed& s, const Surface_point& start,
                       const std::vector<Geodesic_crossing>& crossings, const Surface_point& end) {
  double sum = 0;
  Point last = s.position(start);
  for (const Geodesic_crossing& c : crossings) {
    sum += distance(last, s.position(c));
    last = s.position(c);
  }
  return sum + distance(last, s.position(end));
}

struct Random {
  std::mt19937 engine;
  double operator()() { return static_cast<double>(engine()) / 0x1p32; }
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(engine() % n); }
  Surface_point point(const Input& s) {
    std::uint32_t h = below(s.number_of_halfedges());
    if (s.is_border(h)) h ^= 1U;
    double a = (*this)(), b = (*this)();
    if (a + b > 1) a = 1 - a, b = 1 - b;
    return {h, {1 - a - b, a, b}};
  }
  Vector direction() {
    const double a = 2 * pi * (*this)();
    return {std::cos(a), std::sin(a)};
  }
};

void expect_point_of_a_face(const Surface_point& p) {
  EXPECT_NEAR(p.weights[0] + p.weights[1] + p.weights[2], 1, 1e-14);
  for (const double w : p.weights) EXPECT_GE(w, 0);
}

/// Traces in the plane, where the end is known, and the bound of the error is a bound.
void expect_straight_lines(const meshes::Mesh& mesh, unsigned seed, double length, int count) {
  const Placed s(mesh);
  Random random{std::mt19937(seed)};
  double size = 0;
  for (const Point& p : s.points) size = std::max({size, std::abs(p[0]), std::abs(p[1])});
  for (int i = 0; i < count; ++i) {
    const Surface_point start = random.point(s.surface);
    const Vector d = random.direction();
    std::vector<Geodesic_crossing> crossings;
    const double asked = length * s.unit(mesh) * random();
    const Geodesic_end end = IT::internal::trace_geodesic(s.surface, start, d, asked, crossings);
    ASSERT_NE(end.status, Status::cap) << seed << ' ' << i;
    expect_point_of_a_face(end.point);
    if (end.status == Status::done) {
      ASSERT_EQ(end.length, asked);
    }
    const Point u = s.in_space(start.halfedge, d), from = s.position(start);
    Point to{};
    for (std::size_t k = 0; k < 3; ++k) to[k] = from[k] + end.length * u[k];
    // the error of the trace, and that of the reference: positions are rounded
    const double tolerance = 4 * end.error + 32 * 0x1p-53 * (size + asked);
    ASSERT_LE(distance(to, s.position(end.point)), tolerance) << seed << ' ' << i;
    const double l = polyline_length(s, start, crossings, end.point);
    ASSERT_NEAR(l, end.length, tolerance * static_cast<double>(crossings.size() + 1));
  }
}

} // namespace

// The angle from a halfedge that starts at the vertex is that on the surface, not scaled.
template <class Complex>
Geodesic_end trace_from_vertex(const Complex& complex, Corner_direction start, double length,
                               std::vector<Geodesic_crossing>& crossings) {
  return IT::internal::finish_walk(complex, IT::internal::Geodesic_walk<Complex>(complex, start),
                                   length, {}, crossings);
}

TEST(Trace_geodesic, Is_a_straight_line_in_the_plane) {
  expect_straight_lines(meshes::grid(20, 20), 1, 15, 500);
  for (unsigned seed = 2; seed < 6; ++seed)
    expect_straight_lines(meshes::random_planar(60, 1000, seed), seed, 600, 500);
}

TEST(Trace_geodesic, Is_a_straight_line_across_needles_and_caps) {
  expect_straight_lines(meshes::sheared_grid(6, 6, 1000), 7, 5, 500);
  expect_straight_lines(meshes::random_planar(60, 1U << 20U, 8), 8, 600000, 500);
  expect_straight_lines(meshes::parabola_fan(60), 9, 1000, 500);
  for (const double off : {1e-3, 1e-6, 1e-9}) {
    meshes::Mesh m = meshes::grid(4, 4);
    for (std::size_t f = 0; f < 8; f += 2) m = meshes::with_needle(m, f, 0.5 * off);
    for (std::size_t v = 25; v < m.points.size(); ++v) m.points[v][1] += 0.25 * off;
    expect_straight_lines(m, 10, 3, 300);
  }
}

TEST(Trace_geodesic, Goes_there_and_back) {
  const Placed s(meshes::potato(3, 1));
  Random random{std::mt19937(11)};
  for (int i = 0; i < 500; ++i) {
    const Surface_point start = random.point(s.surface);
    std::vector<Geodesic_crossing> there, back;
    const Geodesic_end e =
        IT::internal::trace_geodesic(s.surface, start, random.direction(), 2, there);
    ASSERT_EQ(e.status, Status::done);
    ASSERT_NEAR(polyline_length(s, start, there, e.point), 2, 1e-12);
    const Geodesic_end r = IT::internal::trace_geodesic(
        s.surface, e.point, {-e.direction[0], -e.direction[1]}, 2, back);
    ASSERT_EQ(r.status, Status::done);
    EXPECT_LE(distance(s.position(start), s.position(r.point)), 8 * (e.error + r.error));
    ASSERT_EQ(there.size(), back.size());
    for (std::size_t k = 0; k < there.size(); ++k)
      EXPECT_EQ(there[k].halfedge, back[back.size() - 1 - k].halfedge ^ 1U);
  }
}

TEST(Trace_geodesic, Unfolds_the_belt_of_a_cube) {
  const meshes::Mesh m = meshes::box(3, 3, 3);
  const Placed s(m);
  const double unit = s.unit(m);
  // the sides unrolled: s from 0 to 12 along the belt, z from 0 to 3
  const auto belt = [&](double along, double z) -> Point {
    along = std::fmod(along, 12);
    const double a = std::fmod(along, 3);
    const std::array<Point, 4> at{{{a, 0, z}, {3, a, z}, {3 - a, 3, z}, {0, 3 - a, z}}};
    Point p = at[static_cast<std::size_t>(along / 3)];
    for (double& x : p) x *= unit;
    return p;
  };
  Random random{std::mt19937(12)};
  for (int i = 0; i < 300; ++i) {
    Surface_point start = random.point(s.surface);
    Point p = s.position(start);
    if (std::abs(p[1]) > 1e-9) continue; // those on the side y = 0
    const double x = p[0] / unit, z = p[2] / unit, to = 3 * random(), along = 40 * random();
    const double length = std::hypot(along, to - z);
    const Point u{along / length, 0, (to - z) / length};
    const Point ex = s.in_space(start.halfedge, {1, 0}), ey = s.in_space(start.halfedge, {0, 1});
    const Vector d{u[0] * ex[0] + u[2] * ex[2], u[0] * ey[0] + u[2] * ey[2]};
    std::vector<Geodesic_crossing> crossings;
    const Geodesic_end e =
        IT::internal::trace_geodesic(s.surface, start, d, length * unit, crossings);
    EXPECT_EQ(e.status, Status::done);
    EXPECT_LE(distance(belt(x + along, to), s.position(e.point)), 8 * e.error + 1e-14);
  }
}

TEST(Trace_geodesic, Follows_straight_lines_on_flat_tori) {
  for (const auto& [n, m] : {std::array<std::uint32_t, 2>{4, 3}, {2, 1}, {1, 1}}) {
    const gallery::Surface torus = gallery::flat_torus(n, m);
    IT::Intrinsic_input input(IT::Gluing_map(torus.gluing), gallery::squared_lengths(torus),
                              IT::Mollification::none);
    input.may_renumber = false;
    const Triangulation t(std::move(input));
    const Input& s = t.input();
    const double unit = std::ldexp(1.0, t.metric().scale_exponent());
    // corners of the faces of cell (i, j), by halfedge
    std::vector<std::array<double, 2>> corner(s.number_of_halfedges());
    for (std::uint32_t f = 0; f < 2 * n * m; ++f) {
      const double x = f / 2 % n, y = f / 2 / n;
      const double sign = f % 2 == 0 ? 1 : -1, x0 = f % 2 == 0 ? x : x + 1,
                   y0 = f % 2 == 0 ? y : y + 1;
      std::uint32_t h = s.halfedge_of_face(f);
      corner[h] = {x0, y0};
      corner[h = s.next(h)] = {x0 + sign, y0};
      corner[s.next(h)] = {x0 + sign, y0 + sign};
    }
    Random random{std::mt19937(13)};
    for (int i = 0; i < 300; ++i) {
      const std::uint32_t h = random.below(s.number_of_halfedges());
      const std::uint32_t n1 = s.next(h);
      const double angle = 2 * pi * random(), length = 30 * random();
      std::vector<Geodesic_crossing> crossings;
      const Geodesic_end e = trace_from_vertex(s, {h, angle}, length * unit, crossings);
      ASSERT_EQ(e.status, Status::done);
      const double base = std::atan2(corner[n1][1] - corner[h][1], corner[n1][0] - corner[h][0]);
      std::array<double, 2> to{corner[h][0] + length * std::cos(base + angle),
                               corner[h][1] + length * std::sin(base + angle)};
      std::uint32_t g = e.point.halfedge;
      for (const double w : e.point.weights) {
        to[0] -= w * corner[g][0];
        to[1] -= w * corner[g][1];
        g = s.next(g);
      }
      EXPECT_LE(std::abs(std::remainder(to[0], n)), 4 * e.error / unit + 1e-13);
      EXPECT_LE(std::abs(std::remainder(to[1], m)), 4 * e.error / unit + 1e-13);
    }
  }
}

TEST(Trace_geodesic, Leaves_a_cone_vertex_with_equal_angles_on_both_sides) {
  const Placed s(meshes::sphere(0)); // an octahedron: four angles of pi / 3 at each vertex
  const double side = std::sqrt(s.surface.squared_length(0));
  for (std::uint32_t h = 0; h < s.surface.number_of_halfedges(); ++h) {
    // along an edge, then on along the one across the vertex, four times around
    std::vector<Geodesic_crossing> crossings;
    const Geodesic_end e = trace_from_vertex(s.surface, {h, 0}, 3.5 * side, crossings);
    ASSERT_EQ(e.status, Status::done);
    const Point a = s.corner(h), b = s.corner(h ^ 1U), p = s.position(e.point);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(p[k], 0.5 * (a[k] - b[k]), 1e-14);
    // to a vertex along a height of a face: straightest is the height of the face opposite
    const std::uint32_t apex = s.surface.next(s.surface.next(h));
    const double height = side * std::sqrt(0.75);
    crossings.clear();
    const Geodesic_end f = IT::internal::trace_geodesic(s.surface, Surface_point{h, {0.5, 0.5, 0}},
                                                        Vector{0, 1}, 2 * height, crossings);
    ASSERT_EQ(f.status, Status::done);
    const Point q = s.position(f.point), v = s.corner(apex);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(q[k], -0.5 * (a[k] + b[k]), 1e-14);
    EXPECT_NEAR(distance(q, v), height, 1e-14);
  }
}

TEST(Trace_geodesic, Stops_at_the_border_and_at_border_vertices) {
  const meshes::Mesh m = meshes::grid(2, 2);
  const Placed s(m);
  const double unit = s.unit(m);
  const auto halfedge = [&](std::uint32_t a, std::uint32_t b) {
    for (std::uint32_t h = 0; h < s.surface.number_of_halfedges(); ++h)
      if (s.surface.source(h) == a && s.surface.target(h) == b) return h;
    return 0U;
  };
  std::vector<Geodesic_crossing> crossings;
  const auto trace = [&](std::uint32_t h, double angle, double length) {
    crossings.clear();
    return trace_from_vertex(s.surface, {h, angle}, length * unit, crossings);
  };
  Geodesic_end e = trace(halfedge(4, 5), 0.25, 10); // from the middle to the right side
  EXPECT_EQ(e.status, Status::border);
  EXPECT_NEAR(s.position(e.point)[0], 2 * unit, 1e-15);
  EXPECT_NEAR(s.position(e.point)[1], (1 + std::tan(0.25)) * unit, 1e-15);
  EXPECT_NEAR(e.length, unit / std::cos(0.25), 1e-15);
  e = trace(halfedge(4, 8), 0, 10); // to a corner
  EXPECT_EQ(e.status, Status::border);
  EXPECT_LE(distance(s.position(e.point), s.points[8]), 1e-15);
  e = trace(halfedge(0, 1), 0, 10); // along the border: to the next border vertex
  EXPECT_EQ(e.status, Status::border);
  EXPECT_LE(distance(s.position(e.point), s.points[1]), 1e-15);
  e = trace(halfedge(0, 1), 0, 1); // just to it
  EXPECT_EQ(e.status, Status::done);
  e = trace(halfedge(0, 1), 2, 1); // out of the corner, which has an angle of pi / 2
  EXPECT_EQ(e.status, Status::border);
  EXPECT_EQ(e.length, 0);
  e = trace(halfedge(0, 1), pi / 2, 0.5);
  EXPECT_EQ(e.status, Status::done);
  e = trace(halfedge(1, 0), -1, 0.5); // from a border halfedge clockwise
  EXPECT_EQ(e.status, Status::done);
  EXPECT_NEAR(s.position(e.point)[0], (1 - 0.5 * std::cos(1.0)) * unit, 1e-15);
  EXPECT_NEAR(s.position(e.point)[1], 0.5 * std::sin(1.0) * unit, 1e-15);
}

TEST(Trace_geodesic, Is_not_upset_by_vertices_that_it_nearly_hits) {
  const meshes::Mesh m = meshes::grid(8, 8);
  const Placed s(m);
  const double unit = s.unit(m);
  for (std::uint32_t h = 0; h < s.surface.number_of_halfedges(); ++h) {
    if (s.surface.is_border(h)) continue;
    for (double offset = 1e-10; offset > 1e-20; offset /= 7)
      for (const double sign : {1.0, -1.0}) {
        // along a row of vertices from the middle of an edge, a little beside it
        const Surface_point p{h, {0.5 - offset, 0.5, offset}};
        std::vector<Geodesic_crossing> crossings;
        const Geodesic_end e = IT::internal::trace_geodesic(s.surface, p, Vector{1, sign * offset},
                                                            3.25 * unit, crossings);
        ASSERT_NE(e.status, Status::cap);
        const Point u = s.in_space(h, {1, sign * offset}), a = s.position(p),
                    b = s.position(e.point);
        // a point within 2^-40 of a side starts on it
        const double moved = offset < 0x1p-39 ? 2 * offset * unit : 0;
        for (std::size_t k = 0; k < 3; ++k)
          ASSERT_NEAR(b[k], a[k] + e.length * u[k], 4 * e.error + 1e-14 + moved);
        ASSERT_LE(crossings.size(), 40U);
      }
  }
}

TEST(Trace_geodesic, Gives_up_after_as_many_faces_as_allowed) {
  const Placed s(meshes::box(1, 1, 1));
  std::vector<Geodesic_crossing> crossings;
  const Geodesic_end e = IT::internal::trace_geodesic(
      s.surface, Surface_point{0, {0.5, 0.25, 0.25}}, Vector{1, 0.3}, 1e9, crossings, {100, true});
  EXPECT_EQ(e.status, Status::cap);
  EXPECT_EQ(crossings.size(), 99U);
  EXPECT_NEAR(polyline_length(s, {0, {0.5, 0.25, 0.25}}, crossings, e.point), e.length, 1e-11);
}

TEST(Trace_geodesic, Ends_on_every_surface_of_the_gallery) {
  Random random{std::mt19937(14)};
  for (const gallery::Surface& g : gallery::oriented()) {
    IT::Intrinsic_input input(IT::Gluing_map(g.gluing), gallery::squared_lengths(g),
                              IT::Mollification::none);
    const Triangulation t(std::move(input));
    const Input& s = t.input();
    for (int i = 0; i < 200; ++i) {
      std::vector<Geodesic_crossing> crossings;
      const Surface_point p = random.point(s);
      const Geodesic_end e = IT::internal::trace_geodesic(s, p, random.direction(), 20, crossings);
      EXPECT_NE(e.status, Status::cap) << g.name;
      expect_point_of_a_face(e.point);
      const Geodesic_end v = trace_from_vertex(s, {p.halfedge, 100 * random() - 50}, 20, crossings);
      EXPECT_NE(v.status, Status::cap) << g.name;
      expect_point_of_a_face(v.point);
    }
  }
}
